#include "tests/language/texts_in_source.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "engine/navigate/built_in_lessons.h"

namespace odontoscope::test {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::set<std::string> marked_in_script(const std::string& script) {
  static const std::regex marked(R"((^|[^\w.])t\('((?:[^'\\]|\\.)*)')");
  std::set<std::string> texts;
  for (std::sregex_iterator found(script.begin(), script.end(), marked), end; found != end; ++found)
    texts.insert(std::regex_replace((*found)[2].str(), std::regex(R"(\\(.))"), "$1"));
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
    const Lesson lesson = built_in_lesson(i);
    add(lesson.title);
    for (const LessonNote& note : lesson.notes) {
      add(note.title);
      add(note.text);
      add(note.tour);
      add(note.narration);
      for (const LessonArrow& arrow : note.arrows) add(arrow.label);
      for (const LessonPin& mark : note.marks) add(mark.label);
      if (!note.question) continue;
      for (const std::string& text : {note.question->ask, note.question->explain, note.question->structure,
                                      note.question->part, note.question->unit})
        add(text);
      for (const std::string& choice : note.question->choices) add(choice);
    }
  }
  return texts;
}

std::string with_bare_places(const std::string& text) {
  static const std::regex place(R"(\{[^{}]*\})");
  return std::regex_replace(text, place, "{}");
}

namespace {

/// What stands after a backslash; `at` is its place, and goes to the escape's last character.
char unescaped(const std::string& cpp, std::size_t& at) {
  switch (cpp[at]) {
    case 'n':
      return '\n';
    case 't':
      return '\t';
    case 'r':
      return '\r';
    case 'x': {
      const char byte = static_cast<char>(std::stoi(cpp.substr(at + 1, 2), nullptr, 16));
      at += 2;
      return byte;
    }
    default:
      return cpp[at];
  }
}

bool only_space(const std::string& text, std::size_t from, std::size_t to) {
  return text.find_first_not_of(" \n", from) >= to;
}

}  // namespace

std::set<std::string> literals_in(const std::string& cpp) {
  std::set<std::string> found;
  std::string literal;
  std::size_t behind = std::string::npos;  // the literal before, whose neighbour goes on with it
  for (std::size_t at = 0; at < cpp.size(); ++at) {
    if (cpp.compare(at, 2, "//") == 0 || cpp.compare(at, 8, "#include") == 0) {
      at = std::min(cpp.find('\n', at), cpp.size());
    } else if (cpp[at] == '\'') {
      at += cpp[at + 1] == '\\' ? 3 : 2;
    } else if (cpp[at] == '"') {
      if (behind == std::string::npos || !only_space(cpp, behind, at)) {
        found.insert(literal);
        literal.clear();
      }
      for (++at; at < cpp.size() && cpp[at] != '"'; ++at) literal += cpp[at] == '\\' ? unescaped(cpp, ++at) : cpp[at];
      behind = at + 1;
    }
  }
  found.insert(literal);
  return found;
}

std::set<std::string> texts_of_viewer(const std::filesystem::path& source) {
  std::set<std::string> none{""};
  std::istringstream lines(content_of(source / "tests/language/no_texts.txt"));
  for (std::string line; std::getline(lines, line);) none.insert(line);
  std::vector<std::filesystem::path> files{source / "engine/comparison/artefacts.cpp"};
  const std::set<std::string> aside{
      "settings.cpp", "file_list.cpp"};  // names of keys and endings, and what is told on the terminal, too
  for (const char* room : {"engine/ui", "engine/viewer", "engine/headset_viewer"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / room))
      if (entry.path().extension() == ".cpp" && !aside.contains(entry.path().filename().string()))
        files.push_back(entry.path());
  std::set<std::string> texts;
  static const std::regex words("[A-Za-z]{2}");
  for (const std::filesystem::path& file : files)
    for (const std::string& literal : literals_in(content_of(file)))
      if (std::regex_search(with_bare_places(literal), words) && !none.contains(literal) && !literal.starts_with("##"))
        texts.insert(literal);
  return texts;
}

std::set<std::string> texts_of_db_lesson(const std::filesystem::path& source) {
  const auto lesson = nlohmann::json::parse(content_of(source / "assets/lessons/artefacts.lesson.json"));
  std::set<std::string> texts{lesson.at("title").get<std::string>()};
  for (const auto& step : lesson.at("steps"))
    for (const char* key : {"title", "words"}) texts.insert(step.at(key).get<std::string>());
  return texts;
}

std::set<std::string> causes_in_source(const std::filesystem::path& source) {
  static const std::regex thrown(
      R"re((?:\b(?:InputError|refuse|fault)\s*\(|\.(?:cause|truncated|unreadable) =)\s*"([a-z0-9-]+)")re");
  std::set<std::string> causes;
  for (const char* part : {"recon", "engine"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / part)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      const std::string text = content_of(entry.path());
      for (std::sregex_iterator found(text.begin(), text.end(), thrown), end; found != end; ++found)
        causes.insert((*found)[1]);
    }
  return causes;
}

}  // namespace odontoscope::test
