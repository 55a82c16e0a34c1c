#pragma once
// What a person does in the headset, as values: made by a runtime, or by a script that tests the interaction.

#include <array>
#include <string>

#include "engine/headset/pose.h"

namespace odontoscope {

struct HandInput {
  bool tracked = false;          // the poses are worth something; a controller that is put away or hidden is not
  Pose grip, aim;                // where it is held, and where it points
  double trigger = 0, grab = 0;  // from 0 to 1
  bool can_grab = true;          // false: a controller with one button, whose trigger grabs, too
  glm::dvec2 stick{0};           // from -1 to 1: right, away from the body
  bool menu = false;
};

struct HeadsetInput {
  Pose head;
  bool head_tracked = false;
  std::array<HandInput, 2> hands;  // left, right
  /// The person sees this program and means it; otherwise the system's menu or another program has the controllers.
  bool focused = false;
  /// The person asked the system to make the present place and heading the middle of the room.
  bool recentred = false;
};

}  // namespace odontoscope
