// OpenGL through EGL with no window and no surface: Mesa's surfaceless platform, else the first device that answers.

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "engine/gpu/context.h"
#include "engine/gpu/dynamic_library.h"

namespace odontoscope {

namespace {

constexpr const char* install_egl = "Install EGL with a driver (Debian: libegl1 libegl-mesa0 libgl1-mesa-dri).";
constexpr EGLint most_devices = 16;

/// The functions of EGL that are needed, found by name.
struct Egl {
  DynamicLibrary library{"libEGL.so.1", "libEGL.so"};
  decltype(&eglGetProcAddress) get_proc_address = library.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglQueryString) query_string = library.function<decltype(&eglQueryString)>("eglQueryString");
  decltype(&eglInitialize) initialize = library.function<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bind_api = library.function<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglCreateContext) create_context = library.function<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy_context = library.function<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current = library.function<decltype(&eglMakeCurrent)>("eglMakeCurrent");
  decltype(&eglGetCurrentContext) current = library.function<decltype(&eglGetCurrentContext)>("eglGetCurrentContext");

  bool complete() const {
    return get_proc_address && query_string && initialize && bind_api && create_context && destroy_context &&
           make_current && current;
  }
};

bool lists(const char* extensions, std::string_view wanted) {
  return extensions && std::string_view(extensions).find(wanted) != std::string_view::npos;
}

std::vector<EGLDisplay> displays_without_window(const Egl& egl) {
  std::vector<EGLDisplay> displays;
  const char* extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.get_proc_address("eglGetPlatformDisplayEXT"));
  if (!platform_display) return displays;
  if (lists(extensions, "EGL_MESA_platform_surfaceless"))
    displays.push_back(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.get_proc_address("eglQueryDevicesEXT"));
  if (!query_devices || !lists(extensions, "EGL_EXT_platform_device")) return displays;
  std::array<EGLDeviceEXT, most_devices> devices{};
  EGLint count = 0;
  if (!query_devices(most_devices, devices.data(), &count)) return displays;
  for (EGLint i = 0; i < count; ++i) displays.push_back(platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
  return displays;
}

class EglContext final : public GlContext {
 public:
  explicit EglContext(const ContextOptions& options) : GlContext(Backend::egl) {
    if (!egl_.library.is_open())
      throw GraphicsError("no-egl", fmt::format("EGL cannot be opened ({})", egl_.library.trouble()), install_egl);
    if (!egl_.complete()) throw GraphicsError("no-egl", "this EGL lacks a function that is needed", install_egl);
    create(options);
    make_current();
    try {
      load(egl_.get_proc_address, options);
    } catch (...) {
      egl_.destroy_context(display_, context_);
      throw;
    }
  }

  // The display stays initialised: it is shared by every context of the process, and eglTerminate would end them all.
  ~EglContext() override {
    if (egl_.current() == context_) egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }

  void make_current() override {
    egl_.bind_api(EGL_OPENGL_API);
    if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw GraphicsError("no-egl", "EGL cannot make its context current without a surface", install_egl);
  }

 private:
  void create(const ContextOptions& options) {
    const std::vector<EGLint> wanted = {EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        1,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_CONTEXT_OPENGL_DEBUG,
                                        options.debug ? EGL_TRUE : EGL_FALSE,
                                        EGL_NONE};
    bool initialised = false;
    for (const EGLDisplay display : displays_without_window(egl_)) {
      if (display == EGL_NO_DISPLAY || !egl_.initialize(display, nullptr, nullptr)) continue;
      initialised = true;
      const char* extensions = egl_.query_string(display, EGL_EXTENSIONS);
      if (!lists(extensions, "EGL_KHR_surfaceless_context") || !egl_.bind_api(EGL_OPENGL_API)) continue;
      context_ = egl_.create_context(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
      if (context_ == EGL_NO_CONTEXT) continue;
      display_ = display;
      return;
    }
    if (initialised)
      throw GraphicsError("gl-too-old", "EGL works, and its driver has no OpenGL 4.1 core without a surface",
                          "Update the driver, or draw in software with --backend osmesa.");
    throw GraphicsError("no-egl", "EGL finds no device that draws without a display", install_egl);
  }

  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context(const ContextOptions& options) {
  return std::make_unique<EglContext>(options);
}

}  // namespace odontoscope
