#pragma once
// Every command that has a key, with what it does in words: the keyboard and the list under `?` read the same table.

#include <optional>
#include <span>
#include <string_view>

#include "engine/scene/camera.h"
#include "engine/view/input.h"

namespace odontoscope {

enum class Action {
  view_three_quarter,
  view_buccal,
  view_lingual,
  view_mesial,
  view_distal,
  view_occlusal,
  view_apical,
  fit,
  toggle_projection,
  next_back_faces,
  toggle_wire,
  toggle_section,
  flip_section,
  measure_distance,
  measure_thickness,
  take_picture,
  save_scene,
  toggle_panel,
  toggle_names,
  toggle_help,
  open_file,
  choose_save_folder,
  escape,
  enter_pulp,
  fly_outdoors,
  enter_here,
  leave_flight,
  pass_wall,
  catch_mouse,
  faster,
  slower,
  ride_play,
  ride_back,
  ride_farther,
  ride_nearer,
  ride_to_start,
  ride_to_end,
  next_canal,
  toggle_labels,
  toggle_depth,
  toggle_wall_thickness,
  toggle_where,
  turn_where,
  write_note,
  toggle_comparison,
  next_comparison_layout,
  swap_methods,
  toggle_faulty_edges,
  next_artefact,
  previous_artefact,
  toggle_lesson,
  toggle_lessons,
  next_step,
  previous_step,
  undo,
  redo
};

struct ActionKey {
  std::string_view printed;  // as on the keyboard
  Action action;
  std::string_view words;
  char32_t character = 0;  // typed; small and capital letters alike
  Key key = Key::other;    // or pressed
  bool control = false;
  bool shift = false;  // needed, too; otherwise it makes no difference
};

/// What the mouse does, for the list.
struct Gesture {
  std::string_view printed, words;
};

struct KeyTable {
  std::span<const Gesture> gestures;
  std::span<const ActionKey> keys;
  std::size_t rows_at_left = 0;  // of the keys, in the list
};
const KeyTable& usual_keys();
/// While one flies letters mean this instead. (Those that fly are held down, see fly/flight_input.h.)
const KeyTable& flight_keys();
/// What a gamepad does, in flight or not.
std::span<const Gesture> gamepad_gestures();

/// What is meant, by either of these lists.
std::optional<Action> action_for(const TextTyped& text, std::span<const ActionKey> known = usual_keys().keys);
std::optional<Action> action_for(const KeyChanged& key, std::span<const ActionKey> known = usual_keys().keys);

std::optional<NamedView> view_of(Action action);

}  // namespace odontoscope
