#pragma once
// The English texts that stand in the sources, where they are marked as such: t('...') of the page, and what pages and
// lessons hold.

#include <filesystem>
#include <set>
#include <string>

namespace odontoscope::test {

/// t('...') in web/source, and what web/source/page.html marks with data-text.
std::set<std::string> texts_of_page(const std::filesystem::path& source);
/// Titles, texts, labels, questions, choices and explanations of every lesson that comes with the program.
std::set<std::string> texts_of_lessons();

/// String literals of the viewer's sources (engine/ui, engine/viewer, engine/headset_viewer,
/// engine/comparison/artefacts.cpp) with words in them, but those of tests/language/no_texts.txt: names of controls and
/// files, and parts that others are put together from.
std::set<std::string> texts_of_viewer(const std::filesystem::path& source);
/// The lesson about DB: assets/lessons/artefacts.lesson.json.
std::set<std::string> texts_of_db_lesson(const std::filesystem::path& source);

/// "{:.1f} of {n}" and "{depth} of {whole}" are both "{} of {}".
std::string with_bare_places(const std::string& text);
std::set<std::string> literals_in(const std::string& cpp);

/// Of one file's text: t('it\'s') is "it's".
std::set<std::string> marked_in_script(const std::string& script);
std::set<std::string> marked_in_page(const std::string& html);

std::string content_of(const std::filesystem::path& file);

/// Of all that is thrown for bad input, by the first argument of InputError and of what leads to it.
std::set<std::string> causes_in_source(const std::filesystem::path& source);

}  // namespace odontoscope::test
