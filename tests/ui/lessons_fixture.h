#pragma once
// A person with lessons, scripted: over flight_fixture.h.

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/viewer/notes/lesson_player.h"
#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {

class LessonsTest : public FlightTest {
 protected:
  NotesState& notes() { return mode<NotesMode>().notes(); }
  const LessonPlayer& lesson() { return mode<NotesMode>().lesson(); }
  void settle() {
    for (int i = 0; i < 6; ++i) frame(0.3);
  }
  glm::dvec2 middle() {
    const Area& area = viewer().panes().front().area;
    return {area.left + area.width / 2, area.top + area.height / 2};
  }
  void take(Lesson lesson) {
    notes() = {};
    notes().lesson = std::move(lesson);
    notes().go_to = 0;
    frames(2);
    settle();
  }
  void undo() {
    press_key(Key::z, {.control = true});
    frames(2);
  }
  void redo() {
    press_key(Key::z, {.shift = true, .control = true});
    frames(2);
  }
  void type_all(std::u32string_view letters) {
    for (const char32_t letter : letters) type(letter);
  }
  static std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
  }
};

/// Three questions about the toy tooth, one of each kind.
inline Lesson toy_quiz(const Viewer& viewer, bool at_end = false) {
  Lesson lesson{"Toy quiz", "", {}};
  lesson.feedback_at_end = at_end;
  LessonNote note = note_of(viewer.state().scene, TakenFrom::outside);
  note.title = "Click";
  note.question = LessonQuestion{.kind = LessonQuestion::Kind::click,
                                 .ask = "Click the enamel.",
                                 .explain = "It is outside.",
                                 .structure = "enamel"};
  lesson.notes.push_back(note);
  note.title = "Choose";
  note.question = LessonQuestion{
      .kind = LessonQuestion::Kind::choice, .ask = "Which is inside?", .choices = {"enamel", "pulp"}, .answer = 1};
  note.marks = {{{0, 0, 4}, ""}};
  lesson.notes.push_back(note);
  note.title = "Count";
  note.question = LessonQuestion{
      .kind = LessonQuestion::Kind::number, .ask = "How wide?", .answer = 12.5, .within = 0.5, .unit = "mm"};
  lesson.notes.push_back(note);
  return lesson;
}

}  // namespace odontoscope::testing_support
