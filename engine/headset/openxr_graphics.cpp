#include "engine/headset/openxr_graphics.h"

#include <glad/gl.h>
#define EGL_NO_X11
#include <EGL/egl.h>
#include <GL/glx.h>
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_PLATFORM_EGL
#include <fmt/format.h>
#include <openxr/openxr_platform.h>

#include <optional>

#include "engine/gpu/dynamic_library.h"
#include "engine/headset/headset.h"
#include "engine/headset/openxr_calls.h"

namespace odontoscope {

namespace {

/// The functions of GLX that are needed, found by name: the program starts without GLX, too.
struct Glx {
  DynamicLibrary library{"libGLX.so.0", "libGL.so.1"};
  decltype(&glXGetCurrentDisplay) current_display =
      library.function<decltype(&glXGetCurrentDisplay)>("glXGetCurrentDisplay");
  decltype(&glXGetCurrentContext) current_context =
      library.function<decltype(&glXGetCurrentContext)>("glXGetCurrentContext");
  decltype(&glXGetCurrentDrawable) current_drawable =
      library.function<decltype(&glXGetCurrentDrawable)>("glXGetCurrentDrawable");
  decltype(&glXQueryContext) query_context = library.function<decltype(&glXQueryContext)>("glXQueryContext");
  decltype(&glXGetFBConfigs) configs = library.function<decltype(&glXGetFBConfigs)>("glXGetFBConfigs");
  decltype(&glXGetFBConfigAttrib) attribute = library.function<decltype(&glXGetFBConfigAttrib)>("glXGetFBConfigAttrib");
  bool complete() const {
    return current_display && current_context && current_drawable && query_context && configs && attribute;
  }
};

struct Egl {
  DynamicLibrary library{"libEGL.so.1", "libEGL.so"};
  decltype(&eglGetProcAddress) get_proc_address = library.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglGetCurrentDisplay) current_display =
      library.function<decltype(&eglGetCurrentDisplay)>("eglGetCurrentDisplay");
  decltype(&eglGetCurrentContext) current_context =
      library.function<decltype(&eglGetCurrentContext)>("eglGetCurrentContext");
  bool complete() const { return get_proc_address && current_display && current_context; }
};

std::optional<XrGraphicsBindingOpenGLXlibKHR> current_glx() {
  const Glx glx;
  if (!glx.complete() || !glx.current_context()) return std::nullopt;
  XrGraphicsBindingOpenGLXlibKHR binding{XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR};
  binding.xDisplay = glx.current_display();
  binding.glxContext = glx.current_context();
  binding.glxDrawable = glx.current_drawable();
  int wanted = 0, screen = 0;
  glx.query_context(binding.xDisplay, binding.glxContext, GLX_FBCONFIG_ID, &wanted);
  glx.query_context(binding.xDisplay, binding.glxContext, GLX_SCREEN, &screen);
  int count = 0;
  GLXFBConfig* configs = glx.configs(binding.xDisplay, screen, &count);
  for (int i = 0; i < count; ++i) {
    int id = 0, visual = 0;
    glx.attribute(binding.xDisplay, configs[i], GLX_FBCONFIG_ID, &id);
    if (id != wanted) continue;
    glx.attribute(binding.xDisplay, configs[i], GLX_VISUAL_ID, &visual);
    binding.glxFBConfig = configs[i];
    binding.visualid = static_cast<std::uint32_t>(visual);
  }
  // The list stays with Xlib: a few kilobytes once, against one more library to link.
  return binding;
}

std::optional<XrGraphicsBindingEGLMNDX> current_egl() {
  const Egl egl;
  if (!egl.complete() || egl.current_context() == EGL_NO_CONTEXT) return std::nullopt;
  XrGraphicsBindingEGLMNDX binding{XR_TYPE_GRAPHICS_BINDING_EGL_MNDX};
  binding.getProcAddress = egl.get_proc_address;
  binding.display = egl.current_display();
  binding.config = nullptr;  // our contexts without a window have none
  binding.context = egl.current_context();
  return binding;
}

}  // namespace

struct CurrentGraphics::Binding {
  std::optional<XrGraphicsBindingOpenGLXlibKHR> glx = current_glx();
  std::optional<XrGraphicsBindingEGLMNDX> egl = glx ? std::nullopt : current_egl();
};

CurrentGraphics::CurrentGraphics() : binding_(std::make_unique<Binding>()) {
  if (binding_->glx || binding_->egl) return;
  throw HeadsetError("headset-graphics", "OpenXR cannot share this OpenGL context, which is neither GLX nor EGL",
                     "Start the viewer on an X display, or on XWayland.");
}

CurrentGraphics::~CurrentGraphics() = default;

std::vector<const char*> CurrentGraphics::extensions() const {
  if (binding_->glx) return {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME};
  return {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_MNDX_EGL_ENABLE_EXTENSION_NAME};
}

const char* CurrentGraphics::words() const { return binding_->glx ? "Xlib" : "EGL"; }

const void* CurrentGraphics::binding() const {
  return binding_->glx ? static_cast<const void*>(&*binding_->glx) : static_cast<const void*>(&*binding_->egl);
}

void check_requirements(XrInstance instance, XrSystemId system, int major, int minor) {
  PFN_xrVoidFunction function = nullptr;
  check(xrGetInstanceProcAddr(instance, "xrGetOpenGLGraphicsRequirementsKHR", &function), "asking for its OpenGL");
  XrGraphicsRequirementsOpenGLKHR requirements{XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR};
  check(reinterpret_cast<PFN_xrGetOpenGLGraphicsRequirementsKHR>(function)(instance, system, &requirements),
        "asking for its OpenGL");
  if (requirements.minApiVersionSupported <=
      XR_MAKE_VERSION(static_cast<std::uint64_t>(major), static_cast<std::uint64_t>(minor), 0))
    return;
  throw HeadsetError(
      "headset-graphics",
      fmt::format("the headset needs OpenGL {}.{} and has {}.{}", XR_VERSION_MAJOR(requirements.minApiVersionSupported),
                  XR_VERSION_MINOR(requirements.minApiVersionSupported), major, minor),
      "Update the graphics driver.");
}

std::vector<unsigned> images_of(XrSwapchain swapchain) {
  std::uint32_t count = 0;
  check(xrEnumerateSwapchainImages(swapchain, 0, &count, nullptr), "asking for its pictures");
  std::vector<XrSwapchainImageOpenGLKHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR});
  check(xrEnumerateSwapchainImages(swapchain, count, &count,
                                   reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
        "asking for its pictures");
  std::vector<unsigned> names;
  for (const XrSwapchainImageOpenGLKHR& image : images) names.push_back(image.image);
  return names;
}

}  // namespace odontoscope
