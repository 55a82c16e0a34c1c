#pragma once
// What a person does, as values: made by a window, or by a script that tests the viewer. Places in pixels of the picture from its upper left.

#include <string>
#include <variant>
#include <vector>

#include "engine/gpu/framebuffer.h"

namespace odontoscope {

enum class MouseButton { left, right, middle };

/// Keys without a character, and those letters that shortcuts of text fields use. Commands of one letter come as TextTyped, which
/// knows the keyboard's layout.
enum class Key {
  other, left, right, up, down, home, end, page_up, page_down, tab, enter, escape, backspace, remove, space,
  a, c, o, s, v, x, y, z, f1, f12
};

struct Modifiers {
  bool shift = false, control = false, alt = false;
};

struct MouseMoved { double x = 0, y = 0; };
struct MouseButtonChanged { MouseButton button = MouseButton::left; bool down = false; Modifiers with = {}; };
/// One notch of a wheel is 1; positive away from the hand.
struct Scrolled { double across = 0, along = 0; Modifiers with = {}; };
struct KeyChanged { Key key = Key::other; bool down = false; Modifiers with = {}; };
struct TextTyped { char32_t character = 0; };
struct FilesDropped { std::vector<std::string> files; };
/// The window lost the keyboard: nothing is held down any more as far as we know.
struct FocusLost {};

using Event = std::variant<MouseMoved, MouseButtonChanged, Scrolled, KeyChanged, TextTyped, FilesDropped, FocusLost>;

/// What a frame needs to know besides.
struct FrameInput {
  PixelSize size;
  float scale = 1;        // pixels of the picture for one of the interface's
  double seconds = 0;     // since the frame before
};

enum class Pointer { arrow, hand, text, cross, none };

}  // namespace odontoscope
