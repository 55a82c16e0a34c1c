#pragma once
// What a person does, as values: made by a window, or by a script that tests the viewer. Places in pixels of the
// picture from its upper left.

#include <string>
#include <variant>
#include <vector>

#include "engine/gpu/framebuffer.h"

namespace odontoscope {

enum class MouseButton { left, right, middle };

/// Keys without a character, and those letters that shortcuts of text fields use. Commands of one letter come as
/// TextTyped, which knows the keyboard's layout.
enum class Key {
  other,
  left,
  right,
  up,
  down,
  home,
  end,
  page_up,
  page_down,
  tab,
  enter,
  escape,
  backspace,
  remove,
  space,
  a,
  c,
  o,
  s,
  v,
  x,
  y,
  z,
  f1,
  f9,
  f12,
  shift
};

struct Modifiers {
  bool shift = false, control = false, alt = false;
};

struct MouseMoved {
  double x = 0, y = 0;
};
struct MouseButtonChanged {
  MouseButton button = MouseButton::left;
  bool down = false;
  Modifiers with = {};
};
/// One notch of a wheel is 1; positive away from the hand.
struct Scrolled {
  double across = 0, along = 0;
  Modifiers with = {};
};
/// `place`: the letter that an American keyboard has there, 0 if none: flying goes by where keys are, not by what they
/// say.
struct KeyChanged {
  Key key = Key::other;
  bool down = false;
  Modifiers with = {};
  char place = 0;
};
struct TextTyped {
  char32_t character = 0;
};
struct FilesDropped {
  std::vector<std::string> files;
};
/// A gamepad as it is now; sent when something on it changes. Sticks and triggers from -1 to 1; up and right are
/// positive.
struct GamepadChanged {
  bool present = false;
  double move_right = 0, move_ahead = 0, turn_right = 0, turn_up = 0, rise = 0;
  bool faster = false, pass = false, leave = false, play = false, next = false;
  bool next_note = false, previous_note = false, labels = false, pictures = false, help = false, outdoors = false;
  friend bool operator==(const GamepadChanged&, const GamepadChanged&) = default;
};
/// The window lost the keyboard: nothing is held down any more as far as we know.
struct FocusLost {};

using Event = std::variant<MouseMoved, MouseButtonChanged, Scrolled, KeyChanged, TextTyped, FilesDropped,
                           GamepadChanged, FocusLost>;

/// What a frame needs to know besides.
struct FrameInput {
  PixelSize size;
  float scale = 1;     // pixels of the picture for one of the interface's
  double seconds = 0;  // since the frame before
};

/// `caught`: hidden and held in the window; places go on beyond its edges.
enum class Pointer { arrow, hand, text, cross, none, caught };

}  // namespace odontoscope
