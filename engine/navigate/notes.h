#pragma once
// A teacher's notes: viewpoints with a title and a text, in an order, as a file that is passed on and played as a
// lesson; with questions it is a quiz.
//
//   {"format":"odontoscope.tour","version":4,"title":"Three canals","model":"molar.json",
//    "notes":[{"title":"The chamber","text":"Its floor shows three orifices.","inside":true,
//              "camera":{"position":[0,0,9],"target":[0,0,8],"up":[0,1,0]},
//              "scene":{"format":"odontoscope.scene","version":1,"structures":[{"name":"enamel","visible":false}]},
//              "marks":[{"at":[2.1,2,13.9],"label":"mesiobuccal orifice"}],"tour":"mesiobuccal canal",
//              "arrows":[{"from":[5,6,16],"to":[2.1,2,13.9],"label":"an orifice"}],"narration":"Look at the floor...",
//              "question":{"kind":"number","ask":"How many
//              orifices?","answer":3,"within":0,"unit":"","explain":"..."}}]}
//
// "scene" is how things look, as scene_json.h says: looks of the structures, section and its cap, back faces, overlays,
// background, lamp. Its camera counts for nothing: the note has its own. Version 1 has no "scene"; a note without one
// leaves the looks as they are. Versions 1 and 2 have none of "marks", "tour" and "question", nor "language" and
// "feedback" at the top; all five may be left out of version 3, too. Versions 1 to 3 have neither "arrows" nor
// "narration"; both may be left out of version 4. "marks" are pins drawn in the picture; an empty
// label is a bare pin. "arrows" are drawn from a place to another, both in the model's space, and carry their label, if
// it is not empty, where they begin. "narration" is what is said, or read, of the note beyond its text. "tour" names a
// canal: the note rides down it, and its camera is where the ride ends. Questions are of three kinds; "ask" is needed,
// "explain" is told after the answer.
//   {"kind":"click","ask":...,"structure":"pulp","part":"distal canal"}   what is clicked is that structure, and the
//   named part nearest there is that one
//   {"kind":"choice","ask":...,"choices":["enamel","dentine"],"answer":1}  2 to 8 choices, counted from 0
//   {"kind":"number","ask":...,"answer":3,"within":0.5,"unit":"mm"}        "within" and "unit" may be left out: 0 and
//   none
// "language" is a tag such as "en" or "de-AT"; "feedback" is "at-once" or "at-end". "translations", from version 4 on,
// hold the lesson's words in other languages, which the page shows to their readers:
//   "translations":[{"language":"de","texts":[["Three canals","Drei Kanäle"]]}]
// "model" names the file that the notes are about, as seen from the notes' folder; without it they are for whatever is
// open, or the sample molar. A camera may also have "field_of_view_deg", "height_mm", "near_mm" and "parallel": true.
// Lengths in mm. Keys that begin with "x-" are others' notes and ignored; every other unknown key is refused.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"
#include "recon/core/named.h"

namespace odontoscope {

/// A pin in the picture.
struct LessonPin {
  glm::dvec3 at{0};        // mm
  std::string label = {};  // empty: a bare pin
  friend bool operator==(const LessonPin&, const LessonPin&) = default;
};

/// An arrow in the picture; it begins and ends in the model's space, so that it points at the same from any side.
struct LessonArrow {
  glm::dvec3 from{0}, to{0};  // mm, at least least_arrow_mm apart
  std::string label = {};     // empty: a bare arrow
  friend bool operator==(const LessonArrow&, const LessonArrow&) = default;
};

struct LessonQuestion {
  enum class Kind { click, choice, number };
  Kind kind = Kind::choice;
  std::string ask, explain = {};
  std::string structure = {}, part = {};  // click; `part` may be empty
  std::vector<std::string> choices = {};  // choice
  double answer = 0;                      // choice: which of them, from 0; number: the number
  double within = 0;                      // number: how far off is still right
  std::string unit = {};                  // number
  friend bool operator==(const LessonQuestion&, const LessonQuestion&) = default;
};

inline constexpr NameTable<LessonQuestion::Kind, 3> question_kinds{{{"click", LessonQuestion::Kind::click},
                                                                    {"choice", LessonQuestion::Kind::choice},
                                                                    {"number", LessonQuestion::Kind::number}}};

struct LessonNote {
  std::string title, text;
  Camera camera;
  bool inside = false;     // seen in flight, from within a cavity
  std::string scene = {};  // JSON as above, without a camera; empty: none
  std::vector<LessonPin> marks = {};
  std::optional<LessonQuestion> question = {};
  std::string tour = {};  // a canal's name; empty: no ride
  std::vector<LessonArrow> arrows = {};
  std::string narration = {};  // beyond the text; empty: the text says it all
  /// `now` as the note looks; what its scene does not speak of is as in `usual`, the camera is the note's.
  Scene scene_over(const Scene& now, const Scene& usual) const;
  friend bool operator==(const LessonNote&, const LessonNote&) = default;
};

enum class TakenFrom { outside, inside };

/// A note of all that `scene` is but its camera's near plane, which inside a cavity follows from the flight.
LessonNote note_of(const Scene& scene, TakenFrom from);

/// A lesson's words in another language, beside those that it has.
struct LessonTranslation {
  std::string language;
  std::vector<std::pair<std::string, std::string>> texts = {};
  friend bool operator==(const LessonTranslation&, const LessonTranslation&) = default;
};

struct Lesson {
  std::string title, model;
  std::vector<LessonNote> notes;  // at least one in a file
  std::string language = {};      // empty: not said
  std::vector<LessonTranslation> translations = {};
  bool feedback_at_end = false;  // of a quiz; otherwise after each answer
  bool is_quiz() const;          // has a question
  friend bool operator==(const Lesson&, const Lesson&) = default;
};

inline constexpr std::string_view tour_ending = ".tour.json";
inline constexpr std::size_t most_lesson_bytes = 4u << 20, most_notes = 1000, most_title_bytes = 200,
                             most_text_bytes = 10'000;
inline constexpr std::size_t most_marks = 50, least_choices = 2, most_choices = 8, most_unit_bytes = 20,
                             most_language_bytes = 35;
inline constexpr std::size_t most_arrows = 50, most_translations = 20, most_translated_texts = 5000;
inline constexpr double largest_answer = 1e9, least_arrow_mm = 1e-3;

/// Throws InputError: what recon/input/strict_json.h lists, and wrong-version, bad-title, bad-text, too-many-notes,
/// no-notes, too-many-marks, too-many-arrows, bad-arrow, repeated-text, too-many-texts, bad-question, bad-value,
/// bad-camera, too-large, and of a scene what scene_from_json throws. docs/formats.md says when.
Lesson parse_lesson(std::string_view bytes, const std::string& name);
/// Likewise, and FileError.
Lesson read_lesson(const std::string& file);

/// What parse_lesson reads as the very same, in the oldest version that can say it.
std::string to_json(const Lesson& lesson);

/// Why it cannot be asked, in words; empty: it can.
std::string fault_of(const LessonQuestion& question);

/// Is it called as such a file?
bool named_like_a_tour(std::string_view file);

}  // namespace odontoscope
