// A teacher's notes as files, and the marks of a quiz.

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "engine/viewer/notes/lesson_words.h"
#include "engine/viewer/notes/note_editor.h"
#include "engine/viewer/notes/notes_mode.h"
#include "engine/viewer/workspace.h"
#include "recon/core/atomic_file.h"
#include "recon/core/error.h"

namespace odontoscope {

/// Two files, written both or none.
void NotesMode::save_marks() {
  const auto& quiz = lesson_.quiz();
  if (!quiz) return;
  try {
    const std::string stem = (quiz->title.empty() ? "Quiz" : quiz->title) + "-marks";
    std::filesystem::path csv, json;
    std::error_code error;
    do {
      csv = at_.files.next(stem, ".csv");
      json = std::filesystem::path(csv).replace_extension(".json");
    } while (std::filesystem::exists(json, error));
    AtomicFile first(csv), second(json);
    first.write(marks_csv(*quiz));
    second.write(marks_json(*quiz));
    first.commit();
    second.commit();
    notice(fmt::format("Saved {} and the same as .json.", csv.string()));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

void NotesMode::save_notes() {
  if (notes_.draft && notes_.at_risk()) {
    if (const std::string fault = fault_of_draft(*notes_.draft); !fault.empty()) {
      notice(fmt::format("The note that is being written cannot be kept yet. {}", fault), NoticeKind::bad);
      return;
    }
    keep_draft(notes_);
  }
  if (notes_.lesson.notes.empty() || !state_.shown) return;
  try {
    if (notes_.lesson.title.empty()) notes_.lesson.title = state_.shown->title;
    const std::filesystem::path file = at_.files.next(notes_.lesson.title, std::string(tour_ending));
    notes_.lesson.model.clear();
    std::error_code error;
    if (!state_.origin.file.empty())
      notes_.lesson.model = std::filesystem::proximate(std::filesystem::absolute(state_.origin.file),
                                                       std::filesystem::absolute(file).parent_path(), error)
                                .generic_string();
    const std::string text = to_json(notes_.lesson);
    if (text.size() > most_lesson_bytes)
      throw UsageError(
          fmt::format("The notes are {} bytes long; a lesson has at most {}", text.size(), most_lesson_bytes),
          "Make two lessons of them.");
    AtomicFile written(file);
    written.write(text);
    written.commit();
    notes_.unsaved = false;
    notes_.saved = notes_.lesson;
    notice(fmt::format("Saved {}. Drop it on the window, or odontoscope view it.", file.string()));
  } catch (const Error& error) {
    state_.trouble = error.what();
  }
}

/// True: the request is done, or goes on as that of the lesson's model.
bool NotesMode::open_lesson(LoadRequest& request) {
  if (!request.lesson && !named_like_a_tour(request.file)) return false;
  state_.failure = nullptr;
  Lesson lesson;
  try {
    lesson = request.lesson ? translated(built_in_lesson(*request.lesson), at_.interface.language())
                            : read_lesson(request.file);
  } catch (const Error& error) {
    state_.failure = std::current_exception();
    state_.trouble = error.what();
    return true;
  }
  if (!request.lesson) remember_file(state_.settings, request.file);
  const std::filesystem::path folder = std::filesystem::path(request.file).parent_path();
  const std::string model = lesson.model.empty() ? "" : (folder / lesson.model).lexically_normal().string();
  const bool there =
      state_.shown && (!request.lesson || state_.origin.sample) &&
      (lesson.model.empty() || (!state_.origin.file.empty() && std::filesystem::weakly_canonical(state_.origin.file) ==
                                                                   std::filesystem::weakly_canonical(model)));
  if (there) {
    take_lesson(std::move(lesson));
    return true;
  }
  to_give_ = std::move(lesson);
  request.file = model;
  request.lesson.reset();
  return false;
}

void NotesMode::take_lesson(Lesson lesson) {
  notes_ = {};
  notes_.lesson = std::move(lesson);
  notes_.saved = notes_.lesson;
  history_ = {};
  lesson_.leave();
  go_to_note(0);
}

}  // namespace odontoscope
