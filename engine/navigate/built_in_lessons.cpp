#include "engine/navigate/built_in_lessons.h"

#include <algorithm>

namespace odontoscope {

std::vector<BuiltInLesson> built_in_lessons() {
  std::vector<BuiltInLesson> all;
  for (std::size_t number = 0; number < lesson_tours().size(); ++number) {
    const Lesson lesson = built_in_lesson(number);
    const auto questions = std::count_if(lesson.notes.begin(), lesson.notes.end(),
                                         [](const LessonNote& note) { return note.question.has_value(); });
    all.push_back(
        {lesson_tours()[number].name, lesson.title, lesson.notes.size(), static_cast<std::size_t>(questions)});
  }
  return all;
}

Lesson built_in_lesson(std::size_t number) {
  const EmbeddedFile& file = lesson_tours()[number];
  return parse_lesson(file.bytes, std::string(file.name));
}

}  // namespace odontoscope
