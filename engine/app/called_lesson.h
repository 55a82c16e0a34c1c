#pragma once
// Lessons by what one calls them.

#include <string>

#include "engine/navigate/notes.h"

namespace odontoscope::app {

struct CalledLesson {
  Lesson lesson;
  bool built_in = false;  // its texts are among those of the languages
};

/// A file, or one of the lessons that come with the program by its title. Throws as read_lesson does.
CalledLesson lesson_called(const std::string& called);

}  // namespace odontoscope::app
