#include "engine/app/called_lesson.h"

#include <vector>

#include "engine/navigate/built_in_lessons.h"

namespace odontoscope::app {

CalledLesson lesson_called(const std::string& called) {
  const std::vector<BuiltInLesson> known = built_in_lessons();
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i].title == called) return {built_in_lesson(i), true};
  return {read_lesson(called), false};
}

}  // namespace odontoscope::app
