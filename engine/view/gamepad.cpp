#include "engine/view/gamepad.h"

#include <algorithm>
#include <cmath>

namespace odontoscope {

namespace {

constexpr double stick_idle = 0.16, trigger_idle = 0.08;  // worn ones do not rest at zero

double beyond(double size, double idle) { return std::clamp((size - idle) / (1 - idle), 0.0, 1.0); }

struct Push {
  double right = 0, up = 0;
};

/// A circle is dead, not a cross: a stick that goes straight up does not snap to it.
Push push_of(double x, double y) {
  const double size = std::hypot(x, y);
  if (!std::isfinite(size)) return {};
  const double wanted = beyond(size, stick_idle);
  return wanted > 0 ? Push{wanted * wanted * x / size, -wanted * wanted * y / size} : Push{};
}

/// 0 to 1. Exactly in the middle: a driver that has not heard of the trigger yet.
double pull_of(double axis) { return std::isfinite(axis) && axis != 0 ? beyond(0.5 * (axis + 1), trigger_idle) : 0; }

}  // namespace

GamepadChanged gamepad_from(const PadState& state) {
  using Pad = PadState;
  const auto& axes = state.axes;
  const auto& held = state.held;
  const Push move = push_of(axes[Pad::left_x], axes[Pad::left_y]),
             turn = push_of(axes[Pad::right_x], axes[Pad::right_y]);
  return {.present = true,
          .move_right = move.right,
          .move_ahead = move.up,
          .turn_right = turn.right,
          .turn_up = turn.up,
          .rise = pull_of(axes[Pad::right_trigger]) - pull_of(axes[Pad::left_trigger]),
          .faster = held[Pad::left_bumper] || held[Pad::right_bumper],
          .pass = held[Pad::x],
          .leave = held[Pad::b],
          .play = held[Pad::a],
          .next = held[Pad::y],
          .next_note = held[Pad::dpad_right],
          .previous_note = held[Pad::dpad_left],
          .labels = held[Pad::dpad_up],
          .pictures = held[Pad::dpad_down],
          .help = held[Pad::start],
          .outdoors = held[Pad::back]};
}

bool in_use(const GamepadChanged& gamepad) { return gamepad != GamepadChanged{.present = gamepad.present}; }

}  // namespace odontoscope
