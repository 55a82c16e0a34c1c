#include "engine/navigate/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/scene/scene_json.h"

namespace odontoscope {

LessonNote note_of(const Scene& scene, TakenFrom from) {
  const bool inside = from == TakenFrom::inside;
  LessonNote note;
  note.camera = scene.camera;
  if (inside) note.camera.near_mm = 0;
  note.inside = inside;
  auto json = nlohmann::ordered_json::parse(to_json(scene));
  json.erase("camera");
  note.scene = json.dump();
  return note;
}

Scene LessonNote::scene_over(const Scene& now, const Scene& usual) const {
  Scene result = now;
  if (!scene.empty()) {
    Scene start = usual;
    start.section.reset();  // a scene that has none does not speak of it
    if (!inside) start.headlight.reset();
    start.overlays.slab.reset();
    result = scene_from_json(scene, start, "note");
  }
  result.camera = camera;
  return result;
}

std::string fault_of(const LessonQuestion& question) {
  if (question.ask.empty()) return "Write what is asked.";
  if (question.kind == LessonQuestion::Kind::click)
    return question.structure.empty() ? "Say which structure is right." : "";
  if (!(std::abs(question.answer) <= largest_answer)) return fmt::format("An answer lies within {}.", largest_answer);
  if (question.kind == LessonQuestion::Kind::number)
    return question.within >= 0 && question.within <= largest_answer ? ""
                                                                     : "Say how far off is still right: 0 or more.";
  if (question.choices.size() < least_choices) return "Offer two choices or more.";
  if (std::any_of(question.choices.begin(), question.choices.end(),
                  [](const std::string& choice) { return choice.empty(); }))
    return "Write something for each choice.";
  if (question.answer != std::floor(question.answer) || question.answer < 0 ||
      question.answer >= static_cast<double>(question.choices.size()))
    return fmt::format("Answer {} is none of {} choices; they are counted from 0.", question.answer,
                       question.choices.size());
  return "";
}

bool Lesson::is_quiz() const {
  return std::any_of(notes.begin(), notes.end(), [](const LessonNote& note) { return note.question.has_value(); });
}

bool named_like_a_tour(std::string_view file) {
  return file.size() > tour_ending.size() &&
         std::equal(tour_ending.begin(), tour_ending.end(),
                    file.end() - static_cast<std::ptrdiff_t>(tour_ending.size()),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b - 'A' + 'a') : b); });
}

}  // namespace odontoscope
