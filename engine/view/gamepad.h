#pragma once
// A gamepad's raw state as what is wanted of it. Without a window, so that recorded states can be tested.

#include <array>
#include <cstddef>

#include "engine/view/input.h"

namespace odontoscope {

/// Laid out as GLFW lays out every gamepad that it knows (GLFWgamepadstate): axes from -1 to 1, y down; triggers rest
/// at -1.
struct PadState {
  enum Axis : std::size_t { left_x, left_y, right_x, right_y, left_trigger, right_trigger, axes_in_all };
  enum Button : std::size_t {
    a,
    b,
    x,
    y,
    left_bumper,
    right_bumper,
    back,
    start,
    guide,
    left_thumb,
    right_thumb,
    dpad_up,
    dpad_right,
    dpad_down,
    dpad_left,
    buttons_in_all
  };
  std::array<float, axes_in_all> axes{0, 0, 0, 0, -1, -1};
  std::array<bool, buttons_in_all> held{};
};

/// Sticks count from a dead zone on, whichever way they are pushed, and gently at first; what is no number counts as
/// rest.
GamepadChanged gamepad_from(const PadState& state);

/// Is something on it held or pushed?
bool in_use(const GamepadChanged& gamepad);

}  // namespace odontoscope
