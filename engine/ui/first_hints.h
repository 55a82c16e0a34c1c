#pragma once
// For the first run: a strip of three hints, each ticked once done. All done, or closed, it never comes again
// (Settings::hints).

#include <glm/vec3.hpp>
#include <optional>

#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

class FirstHints {
 public:
  bool shown(const ViewerState& state) const {
    return state.settings.hints && state.shown && !state.fly.on && !state.lab.on && !state.notes.shown &&
           !state.notes.draft;
  }
  /// Once a frame. true: the last hint was followed just now.
  bool follow(ViewerState& state);
  void draw(ViewerState& state, const Interface& interface, const Area& viewport, float scale) const;

  bool turned() const { return turned_; }
  bool clicked() const { return clicked_; }
  bool flown() const { return flown_; }

 private:
  std::optional<glm::dvec3> first_sight_;  // from where the model was seen first
  bool turned_ = false, clicked_ = false, flown_ = false;
};

}  // namespace odontoscope
