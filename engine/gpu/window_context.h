#pragma once
// A window of the system's with OpenGL in it, through GLFW. Main thread only.

#include <memory>
#include <string>

#include "engine/gpu/context.h"
#include "engine/gpu/framebuffer.h"

struct GLFWwindow;

namespace odontoscope {

struct WindowOptions {
  /// In the system's units, which a dense screen multiplies.
  PixelSize size{1280, 800};
  std::string title = "Odontoscope";
  bool visible = true;  // false: a context that needs the display, but shows nothing
  bool debug = false;
};

class WindowContext : public GlContext {
 public:
  /// For whoever handles the window's events.
  virtual GLFWwindow* handle() const = 0;

 protected:
  WindowContext() : GlContext(Backend::window) {}
};

/// Opens the window and makes its context current. Throws GraphicsError: no-display, no-gl, gl-too-old.
std::unique_ptr<WindowContext> open_window(const WindowOptions& options = {});

}  // namespace odontoscope
