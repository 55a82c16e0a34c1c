#pragma once
// What the viewer's panels read and change: plain values. What takes the viewer's help to do is asked for as an action.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/language/language.h"
#include "engine/measure/wall_thickness.h"
#include "engine/navigate/canal_pick.h"
#include "engine/scene/scene.h"
#include "engine/ui/file_list.h"
#include "engine/ui/fly_state.h"
#include "engine/ui/lab_state.h"
#include "engine/ui/loading.h"
#include "engine/ui/notes_state.h"
#include "engine/ui/settings.h"
#include "engine/ui/volume_question.h"

namespace odontoscope {

/// What a click in the picture does. Moving the camera works with every tool.
enum class Tool { look, distance, thickness };

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
  toggle_where,
  turn_where,
  write_note,
  toggle_lab,
  next_lab_layout,
  swap_methods,
  toggle_faulty_edges,
  next_artefact,
  previous_artefact,
  toggle_lesson,
  toggle_lessons,
  next_step,
  previous_step
};

/// A rectangle of the picture in pixels from the upper left.
struct Area {
  double left = 0, top = 0, width = 0, height = 0;
  double aspect() const { return height > 0 ? width / height : 1; }
  bool holds(double x, double y) const { return x >= left && y >= top && x < left + width && y < top + height; }
  friend bool operator==(const Area&, const Area&) = default;
};

/// What was measured last; the marks stay until something else is.
struct Measured {
  std::vector<Hit> ends;  // of a distance: one or two
  std::optional<Hit> wall_at;
  std::optional<WallThickness> wall;
};

/// A few words that go away by themselves.
struct Notice {
  std::string words;
  bool bad = false;
  double seconds_left = 6;
};

/// What is in one part of the picture: one eye. Two of them are a comparison.
struct ViewPane {
  Area area;
  Camera camera;
  bool db = false;                // the DB surface of DB mode instead of the model
  std::optional<Area> seen = {};  // the part of `area` that is shown, if not all: beside the line of a split view
  const Area& shown() const { return seen ? *seen : area; }
  friend bool operator==(const ViewPane&, const ViewPane&) = default;
};

/// Where a structure may be pointed at from outside: see names.h.
struct NamedPlaces {
  std::string structure;
  std::vector<glm::dvec3> places, everywhere;  // mm: near one height, and all over it
  glm::dvec3 low{0}, high{0};
};

/// What the transfer function was laid out by.
struct VolumeLayout {
  TransferPreset preset = TransferPreset::tooth;
  double air = 0, dentine = 1, density = 1;
  std::vector<TransferPoint> edited = {};  // at density 1; none: as the preset has it
  std::size_t chosen = 0;                  // of the transfer function's points
  double data = 0.85;                      // from the surfaces alone, 0, to the volume alone, 1
};

struct ViewerState {
  std::shared_ptr<const LoadedModel> shown;  // null until something is loaded
  Scene scene;
  VolumeLayout volume_layout;
  bool film_asked = false;  // another film was chosen: the camera goes where all of it is seen
  std::optional<double>
      tube_asked;  // degrees to the right of buccal, from where an X-ray tube would look: the camera goes there
  std::optional<DataColours::Of>
      data_colours_asked;  // of a model whose deviations are not known yet: they are measured meanwhile
  Settings settings;
  std::vector<Language> languages;  // to choose from
  Tool tool = Tool::look;
  Measured measured;
  std::optional<glm::dvec3> look_at;    // a place that was asked for, mm: the camera goes there
  std::optional<glm::dvec3> looked_at;  // and that is marked
  std::optional<Hit> under_pointer;
  std::vector<NamedPlaces> names;                // beside the tooth, from outside,
  std::optional<std::size_t> name_told;          // and the one that was clicked
  std::optional<CanalPick> canal;                // that was clicked from outside,
  std::optional<CanalPick> canal_under_pointer;  // and that could be
  std::optional<Section> section_put_away;       // what switching the section off and on again brings back
  bool help = false;
  std::optional<std::string> file_asked_for;  // being typed,
  FolderList folder;                          // and the folder that is shown beside
  std::optional<VolumeQuestion> question;
  ComparisonState lab;
  FlyState fly;
  NotesState notes;
  bool pad_in_hand = false;  // what was used last was the gamepad: hints speak of it
  bool headset_possible = false,
       headset_asked = false;  // asked: the window's loop ends, for whoever drives the headset
  bool close = false;          // nothing is left to ask: the window's loop ends
  std::string trouble;         // an error to read and close; empty if none
  std::vector<Notice> notices;
  std::string drawn_with;  // the context in words

  std::vector<Action> pending_actions;  // asked for, done in the next frame
  std::optional<LoadRequest> to_load;   // likewise
  bool cancel_loading = false;
  /// Is an X-ray film shown: of the CT, or of a model without one?
  bool film() const { return scene.volume.shows_volume() && scene.volume.cast == VolumeLook::Cast::radiograph; }
  bool film_of_model() const { return film() && shown && !shown->values; }
  bool draft = false;  // what is shown stands for a model that is being made
};

}  // namespace odontoscope
