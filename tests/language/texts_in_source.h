#pragma once
// The English texts that stand in the sources, where they are marked as such: t('...') of the page, and what pages and lessons hold.

#include <filesystem>
#include <set>
#include <string>

namespace odontoscope::test {

/// t('...') in web/source, and what web/source/page.html marks with data-text.
std::set<std::string> texts_of_page(const std::filesystem::path& source);
/// Titles, texts, labels, questions, choices and explanations of every lesson that comes with the program.
std::set<std::string> texts_of_lessons();

/// Of one file's text: t('it\'s') is "it's".
std::set<std::string> marked_in_script(const std::string& script);
std::set<std::string> marked_in_page(const std::string& html);

std::string content_of(const std::filesystem::path& file);

}  // namespace odontoscope::test
