#pragma once
// The lessons about teeth that come with the program: assets/lessons/*.tour.json, for the sample molar.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/navigate/notes.h"
#include "recon/core/embedded_file.h"

namespace odontoscope {

/// In the order in which they are best taken; in lesson_tours.cpp, written by the build.
std::span<const EmbeddedFile> lesson_tours();

/// Of each its title, to choose by: what a list shows.
struct BuiltInLesson {
  std::string_view file;  // "canals.tour.json"
  std::string title;
  std::size_t notes = 0, questions = 0;
};
std::vector<BuiltInLesson> built_in_lessons();

/// Precondition: `number` is one of built_in_lessons().
Lesson built_in_lesson(std::size_t number);

}  // namespace odontoscope
