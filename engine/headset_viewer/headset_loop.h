#pragma once
// The viewer's model in the headset, while the window shows what the left eye sees.

#include <functional>
#include <stop_token>
#include <string>

#include "engine/headset/eye_painter.h"
#include "engine/view/window.h"
#include "engine/viewer/viewer.h"

namespace odontoscope {

struct HeadsetVisitOptions {
  HeadsetOptions headset = {};
  EyeQuality quality = {};
  ComfortRules comfort = {};
  /// Told in words what happens, for a terminal; may be empty.
  std::function<void(const std::string&)> say = {};
  /// After every frame, for tests; may be empty.
  std::function<void(const HeadsetFrame&, const Visit&)> watch = {};
};

/// Waits until the viewer has something to show, enters the headset, and returns when the person leaves it (Escape in
/// the window, or the headset's own menu), the window is closed or a stop is requested; a runtime that does not end the
/// session within three seconds is left without its leave. A file that is dropped on the window is loaded meanwhile and
/// takes the model's place. The window is the viewer's again then. What goes wrong with the headset is not thrown: it
/// is ViewerState::trouble, for the person to read, and the desktop goes on. false: something did.
bool visit_in_headset(Viewer& viewer, Window& window, const ShaderLibrary& shaders, const std::stop_token& stop,
                      const HeadsetVisitOptions& options = {});

}  // namespace odontoscope
