#pragma once
// What all modes of the viewer read and change: plain values. What takes the viewer's help to do is asked for as an
// action. What only one mode knows is that mode's own.

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/language/language.h"
#include "engine/scene/scene.h"
#include "engine/ui/area.h"
#include "engine/viewer/actions.h"
#include "engine/viewer/loading.h"
#include "engine/viewer/settings.h"

namespace odontoscope {

/// A few words that go away by themselves.
enum class NoticeKind { told, bad };

struct Notice {
  std::string words;
  NoticeKind kind = NoticeKind::told;
  double seconds_left = 6;
};

/// What is in one part of the picture: one eye. Two of them are a comparison.
struct ViewPane {
  Area area;
  Camera camera;
  bool db = false;                // the DB surface, Mode::other_model, instead of the model
  std::optional<Area> seen = {};  // the part of `area` that is shown, if not all: beside the line of a split view
  const Area& shown() const { return seen ? *seen : area; }
  friend bool operator==(const ViewPane&, const ViewPane&) = default;
};

/// Where the model came from.
struct ModelOrigin {
  bool sample = false;
  std::string file;    // empty: the sample, or nobody can open it again by name alone
  bool draft = false;  // what is shown stands for a model that is being made
};

struct ViewerState {
  std::shared_ptr<const LoadedModel> shown;  // null until something is loaded
  ModelOrigin origin;
  Scene scene;
  Settings settings;
  std::vector<Language> languages;  // to choose from
  std::string trouble;              // an error to read and close; empty if none
  std::exception_ptr failure;       // what the last load ended with; the person has been told
  std::vector<Notice> notices;
  std::vector<Action> pending_actions;  // asked for, done in the next frame
  std::optional<LoadRequest> to_load;   // likewise
  bool pad_in_hand = false;             // what was used last was the gamepad: hints speak of it
  bool headset_possible = false;
  bool headset_asked = false;  // the window's loop ends, for whoever drives the headset
  bool close = false;          // nothing is left to ask: the window's loop ends

  /// Is an X-ray film shown: of the CT, or of a model without one?
  bool film() const { return scene.volume.shows_volume() && scene.volume.cast == VolumeLook::Cast::radiograph; }
  bool film_of_model() const { return film() && shown && !shown->values; }
};

}  // namespace odontoscope
