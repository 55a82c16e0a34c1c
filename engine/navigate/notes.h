#pragma once
// A teacher's notes: viewpoints with a title and a text, in an order, as a file that is passed on and played as a lesson.
//
//   {"format":"odontoscope.tour","version":2,"title":"Three canals","model":"molar.json",
//    "notes":[{"title":"The chamber","text":"Its floor shows three orifices.","inside":true,
//              "camera":{"position":[0,0,9],"target":[0,0,8],"up":[0,1,0]},
//              "scene":{"format":"odontoscope.scene","version":1,"structures":[{"name":"enamel","visible":false}]}}]}
//
// "scene" is how things look, as scene_json.h says: looks of the structures, section and its cap, back faces, overlays, background, lamp. Its
// camera counts for nothing: the note has its own. Version 1 has no "scene"; a note without one leaves the looks as they are.
// "model" names the file that the notes are about, as seen from the notes' folder; without it they are for whatever is open, or
// the sample molar. A camera may also have "field_of_view_deg", "height_mm", "near_mm" and "parallel": true. Lengths in mm. Keys that begin with "x-" are
// others' notes and ignored; every other unknown key is refused.

#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.h"

namespace odontoscope {

struct TourNote {
  std::string title, text;
  Camera camera;
  bool inside = false;   // seen in flight, from within a cavity
  std::string scene = {};   // JSON as above, without a camera; empty: none
  /// `now` as the note looks; what its scene does not speak of is as in `usual`, the camera is the note's.
  Scene scene_over(const Scene& now, const Scene& usual) const;
  friend bool operator==(const TourNote&, const TourNote&) = default;
};

/// A note of all that `scene` is but its camera's near plane, which inside a cavity follows from the flight.
TourNote note_of(const Scene& scene, bool inside);

struct TourNotes {
  std::string title, model;
  std::vector<TourNote> notes;   // at least one in a file
  friend bool operator==(const TourNotes&, const TourNotes&) = default;
};

inline constexpr std::string_view tour_ending = ".tour.json";
inline constexpr std::size_t most_tour_bytes = 4u << 20, most_notes = 1000, most_title_bytes = 200, most_text_bytes = 10'000;

/// Throws InputError: what strict_json.h lists, and wrong-version, bad-title, bad-text, too-many-notes, no-notes, bad-camera, too-large,
/// and of a scene what scene_from_json throws.
TourNotes parse_tour(std::string_view bytes, const std::string& name);
/// Likewise, and FileError.
TourNotes read_tour(const std::string& file);

/// What parse_tour reads as the very same.
std::string to_json(const TourNotes& tour);

/// Is it called as such a file?
bool named_like_a_tour(std::string_view file);

}  // namespace odontoscope
