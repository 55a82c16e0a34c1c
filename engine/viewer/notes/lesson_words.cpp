#include "engine/viewer/notes/lesson_words.h"

namespace odontoscope {

Lesson translated(Lesson lesson, const Language& language) {
  if (language.english()) return lesson;
  const auto say = [&](std::string& words) { words = language.of(words); };
  say(lesson.title);
  lesson.language = language.tag;
  for (LessonNote& note : lesson.notes) {
    say(note.title);
    say(note.text);
    say(note.narration);
    for (LessonPin& mark : note.marks) say(mark.label);
    for (LessonArrow& arrow : note.arrows) say(arrow.label);
    if (!note.question) continue;
    for (std::string* words : {&note.question->ask, &note.question->explain, &note.question->unit}) say(*words);
    for (std::string& choice : note.question->choices) say(choice);
  }
  return lesson;
}

}  // namespace odontoscope
