#include "engine/navigate/built_in_lessons.h"

#include <algorithm>

namespace odontoscope {

std::vector<BuiltInLesson> built_in_lessons() {
  std::vector<BuiltInLesson> all;
  for (std::size_t number = 0; number < lesson_tours().size(); ++number) {
    const TourNotes tour = built_in_lesson_tour(number);
    const auto questions = std::count_if(tour.notes.begin(), tour.notes.end(),
                                         [](const TourNote& note) { return note.question.has_value(); });
    all.push_back({lesson_tours()[number].name, tour.title, tour.notes.size(), static_cast<std::size_t>(questions)});
  }
  return all;
}

TourNotes built_in_lesson_tour(std::size_t number) {
  const EmbeddedFile& file = lesson_tours()[number];
  return parse_tour(file.bytes, std::string(file.name));
}

}  // namespace odontoscope
