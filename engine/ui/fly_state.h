#pragma once
// Flight as plain values: where the eye is, what is held down, and what leaving brings back. Part of ViewerState.

#include <optional>
#include <vector>

#include "engine/navigate/flight_spaces.h"
#include "engine/navigate/labels.h"
#include "engine/navigate/ride.h"
#include "engine/scene/scene.h"
#include "engine/view/input.h"

namespace odontoscope {

struct FlyState {
  bool on = false;
  std::optional<std::size_t> cavity;  // of LoadedModel::flight; none: outdoors
  Flight flight;
  double speed_factor = 1;        // the person's factor on all speeds
  bool mouse_caught = false;      // every move of the mouse turns the eye
  double dark = 0;                // of the fade: 1 hides everything
  double turning = 0;             // 0 to 1, how fast the picture turns: for the vignette,
  glm::dvec3 sight_before{0};     // since the frame before
  std::vector<glm::dvec3> trail;  // where the eye was, one place every few clearances
  Scene scene_before;
  bool lab_before = false;  // DB mode was on

  std::optional<Ride> ride;               // along a canal; any key that flies ends it
  std::optional<std::size_t> ride_asked;  // of rideable(), begun in the next frame
  std::optional<CanalPlace> place;        // in terms of the cavity's lines; none outdoors, or where it has none
  std::vector<FlightLabel> labels;
  bool show_labels = true, show_where = true;
  NamedView inset_from = NamedView::buccal;  // the small picture's side
};

}  // namespace odontoscope
