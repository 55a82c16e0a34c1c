#include "tests/language/texts_in_source.h"

#include <fstream>
#include <iterator>
#include <regex>

#include "engine/navigate/built_in_lessons.h"

namespace odontoscope::test {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::set<std::string> marked_in_script(const std::string& script) {
  static const std::regex marked(R"((^|[^\w.])t\('((?:[^'\\]|\\.)*)')");
  std::set<std::string> texts;
  for (std::sregex_iterator found(script.begin(), script.end(), marked), end; found != end; ++found) texts.insert(std::regex_replace((*found)[2].str(), std::regex(R"(\\(.))"), "$1"));
  return texts;
}

std::set<std::string> marked_in_page(const std::string& html) {
  static const std::regex marked(R"(<[^>]*\bdata-text\b[^>]*>([^<]*))"), label("aria-label=\"([^\"]*)\"");
  std::set<std::string> texts;
  for (std::sregex_iterator found(html.begin(), html.end(), marked), end; found != end; ++found) {
    const std::string tag = (*found)[0].str(), words = (*found)[1].str();
    std::smatch labelled;
    if (std::regex_search(tag, labelled, label)) texts.insert(labelled[1]);
    if (words.find_first_not_of(" \n") != words.npos) texts.insert(words);
  }
  return texts;
}

std::set<std::string> texts_of_page(const std::filesystem::path& source) {
  std::set<std::string> texts = marked_in_page(content_of(source / "web/source/page.html"));
  for (const auto& entry : std::filesystem::directory_iterator(source / "web/source"))
    if (entry.path().extension() == ".js") texts.merge(marked_in_script(content_of(entry.path())));
  return texts;
}

std::set<std::string> texts_of_lessons() {
  std::set<std::string> texts;
  const auto add = [&](const std::string& text) {
    if (!text.empty()) texts.insert(text);
  };
  for (std::size_t i = 0; i < built_in_lessons().size(); ++i) {
    const TourNotes tour = built_in_lesson_tour(i);
    add(tour.title);
    for (const TourNote& note : tour.notes) {
      add(note.title);
      add(note.text);
      add(note.tour);
      for (const TourMark& mark : note.marks) add(mark.label);
      if (!note.question) continue;
      for (const std::string& text : {note.question->ask, note.question->explain, note.question->structure, note.question->part, note.question->unit}) add(text);
      for (const std::string& choice : note.question->choices) add(choice);
    }
  }
  return texts;
}

}  // namespace odontoscope::test
