// Each text that stands in the sources has its words in every language that comes with the program.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "engine/language/language.h"
#include "tests/language/texts_in_source.h"

namespace odontoscope::test {
namespace {

const std::filesystem::path source = ODONTOSCOPE_SOURCE;

std::string missing_in(const Language& language, const std::set<std::string>& texts) {
  std::string missing;
  for (const std::string& text : texts)
    if (!language.texts.contains(text)) missing += "\n  " + text;
  return missing;
}

std::vector<Language> others() {
  std::vector<Language> known = known_languages();
  known.erase(known.begin());  // English
  return known;
}

TEST(Texts, AreFoundInTheSources) {
  EXPECT_EQ(marked_in_script("t('It\\'s {n}', {n: 1}) + set('no') + a.t('no') + [t('b')]"),
            (std::set<std::string>{"It's {n}", "b"}));
  EXPECT_EQ(marked_in_page("<a data-text href=x>To</a><i aria-label=\"no\">no</i><b data-text aria-label=\"Yes\"></b>"),
            (std::set<std::string>{"To", "Yes"}));
  EXPECT_EQ(literals_in("#include \"no.h\"\nf(\"a\\x41\" \"b\", 'c', '\"');  // \"no\"\ng(\"d \\\"e\\\"\");"),
            (std::set<std::string>{"", "aAb", "d \"e\""}));
  EXPECT_EQ(with_bare_places("{:.1f} of {n}"), "{} of {}");
  EXPECT_GT(texts_of_page(source).size(), 150u);
  EXPECT_GT(texts_of_lessons().size(), 100u);
}

TEST(Texts, OfThePageHaveTheirWordsInEachLanguage) {
  ASSERT_FALSE(others().empty());
  for (const Language& language : others()) EXPECT_EQ(missing_in(language, texts_of_page(source)), "") << language.name;
}

TEST(Texts, OfTheLessonsHaveTheirWordsInEachLanguage) {
  for (const Language& language : others()) EXPECT_EQ(missing_in(language, texts_of_lessons()), "") << language.name;
}

TEST(Texts, OfTheViewerHaveTheirWordsInEachLanguage) {
  const std::set<std::string> texts = texts_of_viewer(source);
  EXPECT_GT(texts.size(), 400u);
  for (const Language& language : others()) {
    std::set<std::string> known;
    for (const auto& [english, words] : language.texts) known.insert(with_bare_places(english));
    std::string missing;
    for (const std::string& text : texts)
      if (!known.contains(with_bare_places(text))) missing += "\n  " + text;
    EXPECT_EQ(missing, "") << language.name;
    EXPECT_EQ(missing_in(language, texts_of_db_lesson(source)), "") << language.name;
  }
}

/// Whoever reads no English reads why a file cannot be read.
TEST(Texts, OfErrorsHaveTheirWordsInEachLanguage) {
  const std::set<std::string> causes = causes_in_source(source);
  EXPECT_GT(causes.size(), 110u);
  EXPECT_TRUE(causes.contains("bad-camera") && causes.contains("unparsable") && causes.contains("several-series"));
  for (const Language& language : others()) {
    std::string missing, needless;
    for (const std::string& cause : causes)
      if (!language.errors.contains(cause)) missing += "\n  " + cause;
    for (const auto& [cause, words] : language.errors) {
      if (!causes.contains(cause)) needless += "\n  " + cause;
      for (const std::string& sentence : {words.rule, words.remedy})
        EXPECT_TRUE(sentence.ends_with('.') && std::isupper(static_cast<unsigned char>(sentence[0]))) << sentence;
    }
    EXPECT_EQ(missing, "") << language.name;
    EXPECT_EQ(needless, "") << language.name << ": thrown nowhere";
  }
}

/// An answer that is compared by its words must not become the same as another.
TEST(Texts, OfTheLessonsStayApart) {
  for (const Language& language : others()) {
    std::map<std::string, std::string> english;
    for (const std::string& text : texts_of_lessons()) {
      if (text.size() > 60) continue;
      const auto [known, fresh] = english.emplace(language.of(text), text);
      const auto lower = [](std::string words) {
        words[0] = static_cast<char>(std::tolower(words[0]));
        return words;
      };
      EXPECT_TRUE(fresh || lower(known->second) == lower(text))
          << text << " and " << known->second << " are both " << known->first;
    }
  }
}

TEST(Texts, OfNumbersKeepTheirDecimals) {
  for (const Language& language : others()) {
    if (language.decimal == ".") continue;
    for (const auto& [text, words] : language.texts)
      for (std::size_t at = words.find('.'); at != words.npos; at = words.find('.', at + 1))
        EXPECT_FALSE(at > 0 && at + 1 < words.size() && std::isdigit(words[at - 1]) && std::isdigit(words[at + 1]))
            << words;
  }
}

}  // namespace
}  // namespace odontoscope::test
