#include "engine/ui/lesson_words.h"

namespace odontoscope {

TourNotes translated(TourNotes tour, const Language& language) {
  if (language.english()) return tour;
  const auto say = [&](std::string& words) { words = language.of(words); };
  say(tour.title);
  tour.language = language.tag;
  for (TourNote& note : tour.notes) {
    say(note.title);
    say(note.text);
    for (TourMark& mark : note.marks) say(mark.label);
    if (!note.question) continue;
    for (std::string* words : {&note.question->ask, &note.question->explain, &note.question->unit}) say(*words);
    for (std::string& choice : note.question->choices) say(choice);
  }
  return tour;
}

}  // namespace odontoscope
