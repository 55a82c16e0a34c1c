#include "engine/gpu/window_context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <cstdlib>

namespace odontoscope {

namespace {

constexpr const char* without_display = "Pictures need none: odontoscope render INPUT -o PICTURE.png.";

std::string said_by_glfw() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words ? words : "it does not say why";
}

/// GLFW is started with the first window and ended after the last.
class Glfw {
 public:
  Glfw() {
    if (glfwInit()) return;
    const std::string why = said_by_glfw();
    if (!names_a_display())
      throw GraphicsError("no-display",
                          "there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are not set)",
                          without_display);
    throw GraphicsError("no-display", fmt::format("the display cannot be opened ({})", why), without_display);
  }
  ~Glfw() { glfwTerminate(); }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;

  static std::shared_ptr<Glfw> shared() {
    static std::weak_ptr<Glfw> running;  // GLFW is one for the process, whatever we would like
    if (auto glfw = running.lock()) return glfw;
    auto glfw = std::make_shared<Glfw>();
    running = glfw;
    return glfw;
  }
};

class GlfwContext final : public WindowContext {
 public:
  explicit GlfwContext(const WindowOptions& options) : glfw_(Glfw::shared()) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS gives nothing newer than 2.1 otherwise
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    // Everything is drawn into framebuffers of our own; the window gets the finished picture.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window_ = glfwCreateWindow(options.size.width, options.size.height, options.title.c_str(), nullptr, nullptr);
    if (!window_) refuse();
    try {
      make_current();
      load(reinterpret_cast<GLADloadfunc>(glfwGetProcAddress), {.debug = options.debug});
    } catch (...) {
      glfwDestroyWindow(window_);
      throw;
    }
  }

  ~GlfwContext() override { glfwDestroyWindow(window_); }

  void make_current() override {
    glfwMakeContextCurrent(window_);
    if (glfwGetCurrentContext() != window_)
      throw GraphicsError("no-gl", fmt::format("the window's OpenGL cannot be used ({})", said_by_glfw()),
                          without_display);
  }

  GLFWwindow* handle() const override { return window_; }

 private:
  [[noreturn]] static void refuse() {
    const char* words = nullptr;
    const int code = glfwGetError(&words);
    const std::string why = words ? words : "it does not say why";
    if (code == GLFW_VERSION_UNAVAILABLE)
      throw GraphicsError("gl-too-old", fmt::format("this display has no OpenGL 4.1 core ({})", why),
                          fmt::format("Update the graphics driver. {}", without_display));
    throw GraphicsError("no-gl", fmt::format("this display has no OpenGL for a window ({})", why),
                        fmt::format("Install a driver, e.g. libgl1-mesa-dri. {}", without_display));
  }

  std::shared_ptr<Glfw> glfw_;
  GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<WindowContext> open_window(const WindowOptions& options) {
  return std::make_unique<GlfwContext>(options);
}

}  // namespace odontoscope
