#pragma once
// A window on the screen: events in, pictures out. Main thread only.

#include <memory>
#include <vector>

#include "engine/gpu/window_context.h"
#include "engine/view/input.h"

namespace odontoscope {

class Window {
 public:
  /// Throws GraphicsError as open_window does.
  explicit Window(const WindowOptions& options = {});
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GlContext& context() { return *context_; }
  /// Of the picture, which may be finer than the system's units.
  PixelSize size() const;
  /// In the system's units, to open it as large again.
  PixelSize outer_size() const;
  /// Pixels of the picture for one of the interface's: 1 on an ordinary screen, 2 on a dense one.
  float scale() const;

  /// What happened since the last call. Waits for something, or for `timeout_seconds` if that is positive.
  std::vector<Event> events(double timeout_seconds);
  /// The person asked to close it, by whatever means.
  bool closing() const;
  /// Not yet, after all.
  void keep_open();

  /// Shows what was drawn into framebuffer 0; waits for the screen's beat.
  void show();
  /// Whether `show` waits; not while something else sets the beat, such as a headset.
  void set_paced(bool paced);

  void set_title(const std::string& title);
  void set_pointer(Pointer pointer);
  std::string clipboard() const;
  void set_clipboard(const std::string& text);

 private:
  struct Inbox;
  std::unique_ptr<WindowContext> context_;
  std::unique_ptr<Inbox> inbox_;
};

}  // namespace odontoscope
