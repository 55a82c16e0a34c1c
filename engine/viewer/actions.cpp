#include "engine/viewer/actions.h"

#include <algorithm>
#include <array>

namespace odontoscope {

namespace {

constexpr std::array<ActionKey, 38> keys = {{
    {"1", Action::view_buccal, "from buccal (the cheek)", U'1'},
    {"2", Action::view_lingual, "from lingual (the tongue)", U'2'},
    {"3", Action::view_mesial, "from mesial (towards the midline)", U'3'},
    {"4", Action::view_distal, "from distal (away from it)", U'4'},
    {"5", Action::view_occlusal, "from occlusal (the biting surface)", U'5'},
    {"6", Action::view_apical, "from apical (the root tips)", U'6'},
    {"0", Action::view_three_quarter, "from three quarters", U'0'},
    {"F", Action::fit, "fit all into the picture", U'f'},
    {"P", Action::toggle_projection, "perspective or parallel", U'p'},
    {"H", Action::toggle_names, "names on or off", U'h'},
    {"B", Action::next_back_faces, "back faces: cull, show, tint", U'b'},
    {"W", Action::toggle_wire, "triangle edges", U'w'},
    {"S", Action::toggle_section, "section on or off", U's'},
    {"R", Action::flip_section, "cut away the other side", U'r'},
    {"C", Action::enter_pulp, "into the pulp chamber, to fly", U'c'},
    {"A", Action::fly_outdoors, "fly around the outside", U'a'},
    {"Enter", Action::enter_here, "ride the canal clicked; measure: the middle", 0, Key::enter},
    {"M", Action::measure_distance, "measure a distance", U'm'},
    {"T", Action::measure_thickness, "measure a wall's thickness", U't'},
    {"I", Action::toggle_wall_thickness, "how thick walls are, by colour", U'i'},
    {"D", Action::toggle_comparison, "DT beside DB, the other method", U'd'},
    {"L", Action::next_comparison_layout, "side by side, split, one in place", U'l'},
    {"X", Action::swap_methods, "DT or DB in place", U'x'},
    {"E", Action::toggle_faulty_edges, "faulty edges", U'e'},
    {"N", Action::next_artefact, "next artefact", U'n'},
    {"V", Action::previous_artefact, "the artefact before", U'v'},
    {"G", Action::toggle_lessons, "lessons", U'g'},
    {"PgDn", Action::next_step, "lesson: next", 0, Key::page_down},
    {"PgUp", Action::previous_step, "lesson: back", 0, Key::page_up},
    {"Ctrl Z", Action::undo, "lesson: undo", 0, Key::z, true},
    {"Ctrl Z", Action::redo, "with Shift: redo", 0, Key::z, true, true},
    {"F12", Action::take_picture, "take a picture", 0, Key::f12},
    {"Ctrl S", Action::save_scene, "save camera and looks", 0, Key::s, true},
    {"Ctrl O", Action::open_file, "open a file", 0, Key::o, true},
    {"F9", Action::toggle_panel, "panel on or off", 0, Key::f9},
    {"?", Action::toggle_help, "this list", U'?'},
    {"F1", Action::toggle_help, "this list", 0, Key::f1},
    {"Esc", Action::escape, "put away what is open; stop loading", 0, Key::escape},
}};

constexpr std::array<ActionKey, 26> in_flight = {{
    {"C", Action::enter_pulp, "back to outside; from outdoors: into the pulp", U'c'},
    {"X", Action::pass_wall, "through the wall straight ahead", U'x'},
    {"T", Action::next_canal, "ride down the next canal (1 to 9: that one)", U't'},
    {"Space", Action::ride_play, "ride: go on, stop", 0, Key::space},
    {"R", Action::ride_back, "ride: the other way", U'r'},
    {",  .", Action::ride_nearer, "ride: a little back, ahead", U','},
    {",  .", Action::ride_farther, "", U'.'},
    {"Home", Action::ride_to_start, "ride: to its start; End: to its end", 0, Key::home},
    {"End", Action::ride_to_end, "", 0, Key::end},
    {"B", Action::toggle_labels, "names on or off", U'b'},
    {"G", Action::toggle_depth, "on the wall: depth, thickness, nothing", U'g'},
    {"V", Action::turn_where, "small picture: from another side", U'v'},
    {"H", Action::toggle_where, "small pictures on or off", U'h'},
    {"N", Action::write_note, "write a note on this view", U'n'},
    {"PgDn", Action::next_step, "notes: next; PgUp: back", 0, Key::page_down},
    {"PgUp", Action::previous_step, "", 0, Key::page_up},
    {"+", Action::faster, "faster", U'+'},
    {"+", Action::faster, "faster", U'='},
    {"\xE2\x88\x92", Action::slower, "slower", U'-'},
    {"M", Action::catch_mouse, "the mouse looks without a button", U'm'},
    {"?", Action::toggle_help, "this list", U'?'},
    {"Ctrl Z", Action::undo, "notes: undo; with Shift: redo", 0, Key::z, true},
    {"Ctrl Z", Action::redo, "", 0, Key::z, true, true},
    {"F12", Action::take_picture, "take a picture", 0, Key::f12},
    {"Ctrl S", Action::save_scene, "save camera and looks", 0, Key::s, true},
    {"F9", Action::toggle_panel, "panel on or off", 0, Key::f9},
}};

constexpr std::array<Gesture, 9> flying = {{
    {"W S", "ahead, back (I K)"},
    {"A D", "to the left, right (J L)"},
    {"Q E", "down, up (U O)"},
    {"Arrow keys, drag", "look around"},
    {"Shift", "three times as fast"},
    {"Wheel", "slower, faster"},
    {"Tab, Shift Tab", "keyboard into the panel; Esc: back"},
    {"Gamepad", "sticks fly and look; Start: all buttons"},
    {"Esc, Backspace", "back to outside"},
}};

constexpr std::array<Gesture, 13> gamepad = {{
    {"A", "into the pulp; there: ride, go on, stop"},
    {"B", "back to outside"},
    {"X", "through the wall straight ahead"},
    {"Y", "ride down the next canal"},
    {"Left stick", "fly ahead, back, to the sides"},
    {"Right stick", "look around"},
    {"Triggers", "down, up"},
    {"LB RB", "three times as fast"},
    {"Cross left, right", "notes and lesson: back, next"},
    {"Cross up", "names on or off"},
    {"Cross down", "small pictures on or off"},
    {"Back", "fly around the outside"},
    {"Start", "this list"},
}};

constexpr std::array<Gesture, 9> mouse = {{
    {"Drag", "turn"},
    {"Right drag, Shift drag", "move"},
    {"Wheel", "nearer and farther, at the pointer"},
    {"Click on a canal", "its name; twice: ride down it"},
    {"Double click", "turn round this point"},
    {"Arrow keys", "turn; with Shift: move"},
    {"+  \xE2\x88\x92", "nearer, farther"},
    {"Drop a file", "open it"},
    {"Tab, Shift Tab", "into the panel; arrows, Enter; Esc: back"},
}};

char32_t small(char32_t character) {
  return character >= U'A' && character <= U'Z' ? character - U'A' + U'a' : character;
}

}  // namespace

const KeyTable& usual_keys() {
  static const KeyTable table{mouse, keys, 12};
  return table;
}

const KeyTable& flight_keys() {
  static const KeyTable table{flying, in_flight, 7};
  return table;
}

std::span<const Gesture> gamepad_gestures() { return gamepad; }

std::optional<Action> action_for(const TextTyped& text, std::span<const ActionKey> known) {
  const auto found = std::find_if(known.begin(), known.end(), [&](const ActionKey& key) {
    return key.character != 0 && key.character == small(text.character);
  });
  return found == known.end() ? std::nullopt : std::optional(found->action);
}

std::optional<Action> action_for(const KeyChanged& pressed, std::span<const ActionKey> known) {
  if (!pressed.down || pressed.key == Key::other) return std::nullopt;
  const auto find = [&](bool with_shift) {
    return std::find_if(known.begin(), known.end(), [&](const ActionKey& key) {
      return key.key == pressed.key && key.control == pressed.with.control && key.shift == with_shift;
    });
  };
  auto found = pressed.with.shift ? find(true) : known.end();
  if (found == known.end()) found = find(false);
  return found == known.end() ? std::nullopt : std::optional(found->action);
}

std::optional<NamedView> view_of(Action action) {
  switch (action) {
    case Action::view_three_quarter:
      return NamedView::three_quarter;
    case Action::view_buccal:
      return NamedView::buccal;
    case Action::view_lingual:
      return NamedView::lingual;
    case Action::view_mesial:
      return NamedView::mesial;
    case Action::view_distal:
      return NamedView::distal;
    case Action::view_occlusal:
      return NamedView::occlusal;
    case Action::view_apical:
      return NamedView::apical;
    default:
      return std::nullopt;
  }
}

}  // namespace odontoscope
