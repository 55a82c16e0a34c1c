// A language's file as it is read, and what is made of its texts.
#include "engine/language/language.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

std::string file_of(const std::string& texts,
                    const std::string& head = R"("language":"xx","name":"Xish","decimal":",","group":".")") {
  return R"({"format":"odontoscope.language","version":1,)" + head + R"(,"texts":[)" + texts + "]}";
}

std::string cause_of(const std::string& bytes) {
  try {
    parse_language(bytes, "test.json");
  } catch (const InputError& error) {
    return error.cause();
  }
  return "none";
}

Language little() {
  return parse_language(
      file_of(
          R"(["Fly","Fliegen"],["Step {step} of {steps}","{steps}: Schritt {step}"],["{count} triangles","{count} Dreiecke"],
    ["canal","Kanal"],["pulp","Pulpa"],["cavity","Hohlraum"],["{structure}: {what} seen","{structure} zeigt {what}"],["dentine","Dentin"])"),
      "test.json");
}

std::string with_errors(const std::string& errors) {
  std::string text = file_of("");
  text.insert(text.size() - 1, ",\"errors\":[" + errors + "]");
  return text;
}

TEST(Language, HasWordsForErrorsByTheirCause) {
  const Language xish = parse_language(with_errors(R"(["too-few-points","Drei Punkte.","Entfernen."])"), "test.json");
  const ErrorWords* words = xish.words_for_error("a.json: slice 1 [2]: 2 points. Remove it. [too-few-points]");
  ASSERT_TRUE(words);
  EXPECT_EQ(words->rule, "Drei Punkte.");
  EXPECT_EQ(words->remedy, "Entfernen.");
  EXPECT_FALSE(xish.words_for_error("a.json: no such file"));
  EXPECT_FALSE(xish.words_for_error("something else [zero-area]"));
  EXPECT_FALSE(xish.words_for_error("[too-few-points] and more"));
  EXPECT_EQ(parse_language(to_json(xish), "again"), xish);
  EXPECT_EQ(cause_of(with_errors(R"(["too-few-points","Drei Punkte."])")), "bad-text");
  EXPECT_EQ(cause_of(with_errors(R"(["Too few","Drei Punkte.","Entfernen."])")), "bad-text");
  EXPECT_EQ(cause_of(with_errors(R"(["a","","Entfernen."])")), "bad-text");
  EXPECT_EQ(cause_of(with_errors(R"(["a","b","c"],["a","b","c"])")), "repeated-text");
  EXPECT_EQ(cause_of(with_errors(R"({"a":"b"})")), "wrong-type");
  std::string many;
  for (std::size_t i = 0; i <= most_language_errors; ++i)
    many += (i ? "," : "") + std::string(R"(["e)") + std::to_string(i) + R"(","b","c"])";
  EXPECT_EQ(cause_of(with_errors(many)), "too-many-texts");
}

TEST(Language, SaysWhatItHasAndEnglishElsewhere) {
  const Language xish = little();
  EXPECT_STREQ(xish.of("Fly"), "Fliegen");
  EXPECT_STREQ(xish.of("Leave"), "Leave");
  EXPECT_EQ(xish.told("Step {step} of {steps}", {{"step", "2"}, {"steps", "9"}}), "9: Schritt 2");
  EXPECT_EQ(Language{}.told("Step {step} of {steps}", {{"step", "2"}, {"steps", "9"}}), "Step 2 of 9");
  EXPECT_EQ(Language{}.told("{a} {b}", {{"a", "{b}"}, {"b", "x"}}), "{b} x") << "what is filled in is not filled again";
}

TEST(Language, WritesNumbersItsOwnWay) {
  const Language xish = little();
  EXPECT_EQ(xish.number(1234567.25, 2), "1.234.567,25");
  EXPECT_EQ(xish.number(-0.5, 1),
            "\xE2\x88\x92"
            "0,5");
  EXPECT_EQ(xish.number(-0.001, 1), "0,0") << "no zero below zero";
  EXPECT_EQ(xish.number(999, 0), "999");
  EXPECT_EQ(Language{}.whole(58312), "58,312");
  EXPECT_EQ(xish.localised("0.25 mm of 58,312; (1.5, 2.5)"), "0,25 mm of 58.312; (1,5, 2,5)");
  EXPECT_EQ(xish.localised("see slices 3,4 and 5."), "see slices 3,4 and 5.");
}

TEST(Language, NamesWhatDataCallThings) {
  const Language xish = little();
  EXPECT_EQ(xish.named("canal 2"), "Kanal 2");
  EXPECT_EQ(xish.named("pulp cavity"), "Pulpa: Hohlraum");
  EXPECT_EQ(xish.named("Struktur 7"), "Struktur 7");
}

TEST(Language, FindsAgainWhatTheProgramPutTogether) {
  const Language xish = little();
  EXPECT_EQ(xish.said("12,345 triangles"), "12.345 Dreiecke");
  EXPECT_EQ(xish.said("dentine: 3 triangles"), "Dentin: 3 Dreiecke");
  EXPECT_EQ(xish.said("dentine: canal 2 seen"), "Dentin zeigt Kanal 2");
  EXPECT_EQ(xish.said("3 triangles, 4 triangles."), "3 Dreiecke, 4 Dreiecke.");
  EXPECT_EQ(xish.said("three triangles"), "three triangles") << "a count is a number";
  EXPECT_EQ(xish.said("pulp   12.5   (1)"), "Pulpa   12,5   (1)");
  EXPECT_EQ(xish.said("nobody knows this"), "nobody knows this");
  EXPECT_EQ(Language{}.said("12,345 triangles"), "12,345 triangles");
}

TEST(Language, RefusesWhatIsNone) {
  EXPECT_EQ(cause_of(file_of(R"(["Fly","Fliegen"])")), "none");
  EXPECT_EQ(cause_of(file_of(R"(["Step {step}","Schritt"])")), "bad-text");
  EXPECT_EQ(cause_of(file_of(R"(["Step {step}","Schritt {stufe}"])")), "bad-text");
  EXPECT_EQ(cause_of(file_of(R"(["Fly",""])")), "bad-text");
  EXPECT_EQ(cause_of(file_of(R"(["Fly","Flieg\u0007en"])")), "bad-text");
  EXPECT_EQ(cause_of(file_of(R"(["Fly"])")), "bad-text");
  EXPECT_EQ(cause_of(file_of(R"(["Fly","a","b"])")), "bad-text");
  EXPECT_EQ(cause_of(file_of(R"(["Fly","a"],["Fly","b"])")), "repeated-text");
  EXPECT_EQ(cause_of(file_of("", R"("language":"x x","name":"X","decimal":",","group":".")")), "bad-language");
  EXPECT_EQ(cause_of(file_of("", R"("language":"xx","name":"X","decimal":".","group":".")")), "bad-language");
  EXPECT_EQ(cause_of(file_of("", R"("language":"xx","name":"X","decimal":"1","group":".")")), "bad-language");
  EXPECT_EQ(cause_of(file_of("", R"("language":"xx","name":"","decimal":",","group":".")")), "bad-language");
  EXPECT_EQ(cause_of(R"({"format":"odontoscope.tour","version":1})"), "wrong-format");
  EXPECT_EQ(cause_of(R"({"format":"odontoscope.language","version":2})"), "wrong-version");
  EXPECT_EQ(cause_of("[1,2]"), "wrong-format");
  EXPECT_EQ(cause_of(R"({"format":"odontoscope.language")"), "unparsable");
  EXPECT_EQ(cause_of(R"({"format":"odontoscope.language","version":1})"), "missing-key");
  EXPECT_EQ(cause_of(file_of("") + "x"), "unparsable");
  std::string many;
  for (std::size_t i = 0; i <= most_language_texts; ++i)
    many += (i == 0 ? "" : ",") + std::string("[\"") + std::to_string(i) + "\",\"x\"]";
  EXPECT_EQ(cause_of(file_of(many)), "too-many-texts");
}

TEST(Language, IsWrittenAsItIsRead) {
  const Language xish = little();
  EXPECT_EQ(parse_language(to_json(xish), "again.json"), xish);
}

TEST(Language, IsChosenByTagEnvironmentOrFile) {
  EXPECT_EQ(known_language("de").name, "Deutsch");
  EXPECT_EQ(known_language("de_AT.UTF-8").tag, "de");
  EXPECT_EQ(known_language("DE-ch").tag, "de");
  EXPECT_EQ(known_language("C").tag, "en");
  EXPECT_EQ(known_language("").tag, "en");
  EXPECT_FALSE(knows_language("tlh"));
  EXPECT_TRUE(knows_language("en_GB.UTF-8"));
  EXPECT_THROW(language_asked("tlh"), UsageError);
  EXPECT_THROW(language_asked("missing.json"), FileError);
}

}  // namespace
}  // namespace odontoscope
