#pragma once
// Flight as plain values: where the eye is, what is held down, and what leaving brings back. Part of ViewerState.

#include <optional>
#include <vector>

#include "engine/navigate/flight_spaces.h"
#include "engine/scene/scene.h"
#include "engine/view/input.h"

namespace odontoscope {

struct FlyState {
  bool on = false;
  std::optional<std::size_t> cavity;   // of LoadedModel::flight; none: outdoors
  Flight flight;
  double haste = 1;                    // the person's factor on all speeds
  bool mouse_caught = false;           // every move of the mouse turns the eye
  double dark = 0;                     // of the fade: 1 hides everything
  double turning = 0;                  // 0 to 1, how fast the picture turns: for the vignette,
  glm::dvec3 sight_before{0};          // since the frame before
  std::vector<glm::dvec3> trail;       // where the eye was, one place every few clearances
  Scene scene_before;
};

}  // namespace odontoscope
