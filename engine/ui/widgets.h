#pragma once
// The few controls that the panels are made of, drawn in one style. They are called between Interface::begin and end.

#include <imgui.h>

#include <array>
#include <string>
#include <vector>

#include "engine/ui/interface.h"
#include "engine/ui/mark.h"

namespace odontoscope::widgets {

/// A heading that folds what follows. true: it is open.
enum class AtFirst { open, folded };
inline AtFirst open_if(bool condition) { return condition ? AtFirst::open : AtFirst::folded; }
bool section(const Interface& interface, const char* title, AtFirst at_first = AtFirst::open);

/// English words as the interface's language has them; see Interface::say. All that follows says its words so.
std::string say(const std::string& words);
/// Notes it where these words, said already, need more than this width.
void expect_room(const std::string& said, float width);
/// One line.
void text(const std::string& words);
void wrapped(const std::string& words);
/// What somebody wrote, as it is.
void as_written(const std::string& words);
/// Words in the quiet colour, wrapped.
void remark(const Interface& interface, const std::string& words);

/// One of a few, side by side. true: another was chosen.
bool choice(const char* id, int& chosen, const std::vector<const char*>& words);

/// On or off, with words behind.
bool toggle(const char* words, bool& on);

/// A slider under its name, with its value at the right.
bool slider(const char* words, double& value, double low, double high, const char* format);

/// An eye, open or shut.
bool eye(const char* id, bool& open);

/// ImGui's own button, and its own text fields between `text_field` and `noted`: the keyboard comes to these as to all
/// others.
bool button(const char* words, const ImVec2& size = {0, 0});
void text_field(const char* id);
enum class Field { text, drawn };
void noted(const char* id, Field field = Field::text);

/// A square of the colour (red, green, blue) that opens a picker.
bool swatch(const char* id, std::array<float, 3>& colour);

/// A button over the whole width; strong: in the accent's colour.
enum class Emphasis { none, strong };
inline Emphasis strong_if(bool condition) { return condition ? Emphasis::strong : Emphasis::none; }
bool wide_button(const char* words, Emphasis emphasis = Emphasis::none);

/// A coloured sign (tick, exclamation mark or cross), then words.
void marked(const Interface& interface, Mark mark, const std::string& words);
/// The same as a button. true: pressed.
bool marked_button(const char* id, Mark mark, const std::string& words);

float scaled(float size);  // by the letters' size, so by the screen's scale

}  // namespace odontoscope::widgets
