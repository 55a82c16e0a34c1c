#pragma once
// The hand in the picture: what modes are told of presses, clicks and drags, and what lies under the pointer.

#include <functional>
#include <glm/vec2.hpp>
#include <optional>

#include "engine/measure/pick.h"
#include "engine/navigate/canal_pick.h"
#include "engine/view/input.h"
#include "engine/viewer/actions.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

class Mode;

struct Press {
  const ViewPane& pane;
  double x = 0, y = 0;  // pixels
  MouseButton button = MouseButton::left;
  Modifiers with = {};
};

struct Click {
  const ViewPane& pane;
  double x = 0, y = 0;
  bool second = false;  // of a double click
};

struct Hover {
  const ViewPane& pane;
  double x = 0, y = 0;
};

/// From one place to the next, as engine/navigate/screen.h counts them, and in pixels.
struct DragMove {
  const ViewPane& pane;
  glm::dvec2 from{0}, to{0};
  glm::dvec2 pixels{0};
  double x = 0;
};

/// A mark in the picture that can be held.
struct Grip {
  const Mode* of = nullptr;
  int part = 0;
};

struct Drag {
  std::function<void(const DragMove&)> move;
  std::function<void(bool moved)> end = {};
  bool may_be_click = true;  // if the hand hardly moves
  std::optional<Grip> grip = {};
};

/// A drag that goes on.
struct HeldDrag {
  Drag drag;
  MouseButton button = MouseButton::left;
  double x = 0, y = 0;  // where the hand is
  double start_x = 0, start_y = 0;
  bool moved = false;    // far enough to be no click
  std::size_t pane = 0;  // that it began in
};

struct Pointing {
  double x = -1, y = -1;
  std::optional<HeldDrag> held;
  struct {
    double x = 0, y = 0, when = -1e9;
  } last_click;
  std::optional<Action> compass;  // the view that is pointed at there
  std::optional<Grip> grip;
  std::optional<Hit> hit;          // of the surface
  std::optional<CanalPick> canal;  // that could be clicked
  Pointer pointer = Pointer::arrow;

  /// Neither compass nor a mark lies under the pointer.
  bool at_model() const { return !compass && !grip; }
};

}  // namespace odontoscope
