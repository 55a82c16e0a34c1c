// Teachers' notes as files: what is written is read as the same, and whatever else is refused in one sentence.

#include "engine/navigate/notes.h"

#include <gtest/gtest.h>

#include "recon/core/error.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

Lesson some_tour() {
  Lesson lesson{"Three canals", "molar.json", {}};
  lesson.notes.push_back({"The chamber", "Its floor shows three orifices.\nLook for the third.", {}, true});
  lesson.notes.back().camera.position = {0.1, 1.0 / 3, 9};
  lesson.notes.back().camera.target = {0, 0, 8};
  lesson.notes.push_back({"From outside \"here\"", "", {}, false});
  lesson.notes.back().camera.projection = Camera::Projection::parallel;
  return lesson;
}

std::string cause_of(const std::string& text) {
  try {
    parse_lesson(text, "a.tour.json");
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a.tour.json"), std::string::npos);
    return std::string(error.cause());
  }
  return "read";
}

/// Of `some_tour` with one text replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = to_json(some_tour());
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Lesson, AreReadAsTheyWereWritten) { EXPECT_EQ(parse_lesson(to_json(some_tour()), "a"), some_tour()); }

/// With the whole of what is seen.
Lesson tour_with_scenes() {
  Lesson lesson = some_tour();
  Scene scene;
  scene.camera = lesson.notes[1].camera;
  scene.looks = {{"enamel", colour_of(0x112233), 0.3f, false, true}};
  scene.section = Section{{1, 2, 3}, {0, 0.6, 0.8}};
  scene.back_faces = BackFaces::tint;
  lesson.notes[1] = note_of(scene, TakenFrom::outside);
  scene.headlight = Headlight{1.5};
  scene.camera.near_mm = 0.01;
  lesson.notes[0] = note_of(scene, TakenFrom::inside);
  return lesson;
}

TEST(Lesson, WithScenesAreReadAsTheyWereWritten) {
  const Lesson lesson = tour_with_scenes();
  const Lesson read = parse_lesson(to_json(lesson), "a");
  EXPECT_EQ(read, lesson);
  EXPECT_EQ(read.notes[0].camera.near_mm, 0) << "inside it follows from the flight";
  Scene other;
  other.looks = {{"enamel", colour_of(0xffffff)}, {"pulp", colour_of(0xff0000), 0.5f}};
  other.section = Section{};
  other.headlight = Headlight{};
  const Scene shown = read.notes[1].scene_over(other, other);
  EXPECT_EQ(shown.camera, lesson.notes[1].camera);
  EXPECT_FALSE(shown.look_of("enamel")->visible);
  EXPECT_EQ(*shown.look_of("pulp"), other.looks[1]) << "not spoken of";
  EXPECT_EQ(shown.section->point_mm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(shown.back_faces, BackFaces::tint);
  EXPECT_FALSE(shown.headlight);
  EXPECT_EQ(some_tour().notes[0].scene_over(other, other).looks, other.looks)
      << "a note of a camera alone leaves looks as they are";
}

Lesson quiz_tour() {
  Lesson lesson = tour_with_scenes();
  lesson.language = "en";
  lesson.feedback_at_end = true;
  lesson.notes[0].tour = "mesiobuccal canal";
  lesson.notes[0].marks = {{{1, 2, 3}, "furcation"}, {{0.1, -1, 1.0 / 3}}};
  lesson.notes[1].question = LessonQuestion{.kind = LessonQuestion::Kind::click,
                                            .ask = "Click the distal canal.",
                                            .explain = "The wide one.",
                                            .structure = "pulp",
                                            .part = "distal canal"};
  lesson.notes.push_back({"Which?", "", lesson.notes[1].camera});
  lesson.notes.back().question = LessonQuestion{.kind = LessonQuestion::Kind::choice,
                                                .ask = "Which structure is this?",
                                                .choices = {"enamel", "dentine"},
                                                .answer = 1};
  lesson.notes.push_back({"How long?", "", lesson.notes[1].camera});
  lesson.notes.back().question = LessonQuestion{
      .kind = LessonQuestion::Kind::number, .ask = "How long is it?", .answer = 12.5, .within = 0.5, .unit = "mm"};
  return lesson;
}

TEST(Lesson, WithQuestionsAndPinsAreReadAsTheyWereWritten) {
  const Lesson lesson = quiz_tour();
  const std::string text = to_json(lesson);
  EXPECT_NE(text.find("\"version\": 3"), std::string::npos);
  const Lesson read = parse_lesson(text, "a");
  EXPECT_EQ(read, lesson);
  EXPECT_TRUE(read.is_quiz());
  EXPECT_FALSE(tour_with_scenes().is_quiz());
  EXPECT_NE(to_json(tour_with_scenes()).find("\"version\": 2"), std::string::npos) << "older programs read it, too";
}

Lesson tour_with_arrows() {
  Lesson lesson = quiz_tour();
  lesson.notes[0].arrows = {{{5, 6, 16}, {2.1, 2, 13.9}, "an orifice"}, {{0.1, -1, 1.0 / 3}, {0, 0, 0}}};
  lesson.translations = {{"de", {{"Three canals", "Drei Kan\xC3\xA4le"}, {"an orifice", "ein Eingang"}}}, {"pt-BR"}};
  lesson.notes[1].narration = "Look at the floor.\nThree hollows lie in it.";
  return lesson;
}

TEST(Lesson, WithArrowsAndNarrationAreReadAsTheyWereWritten) {
  const Lesson lesson = tour_with_arrows();
  const std::string text = to_json(lesson);
  EXPECT_NE(text.find("\"version\": 4"), std::string::npos);
  EXPECT_EQ(parse_lesson(text, "a"), lesson);
  Lesson spoken = some_tour();
  spoken.notes[0].narration = "Said.";
  EXPECT_NE(to_json(spoken).find("\"version\": 4"), std::string::npos) << "older programs do not know it";
}

/// A lesson of one note with this beside title, text and camera.
std::string with(const std::string& more, const std::string& top = "") {
  return R"({"format":"odontoscope.tour","version":3,"title":"",)" + top +
         R"("notes":[{"title":"","text":"","camera":{"position":[0,0,9],"target":[0,0,8],"up":[0,1,0]},)" + more +
         "}]}";
}

TEST(Lesson, RefuseQuestionsThatCannotBeAnswered) {
  const auto asked = [](const std::string& question) { return cause_of(with("\"question\":{" + question + "}")); };
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["x","y"],"answer":1)"), "read");
  EXPECT_EQ(asked(R"("choices":["x","y"],"answer":1,"ask":"a","kind":"choice")"), "read") << "keys come in any order";
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["x","y"],"answer":2)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["x","y"],"answer":-1)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["x","y"],"answer":0.5)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["x"],"answer":0)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":[],"answer":0)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["1","2","3","4","5","6","7","8","9"],"answer":0)"),
            "bad-question");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["x","y"])"), "missing-key");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","answer":0)"), "missing-key");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"","choices":["x","y"],"answer":1)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"choice","choices":["x","y"],"answer":1)"), "missing-key");
  EXPECT_EQ(asked(R"("kind":"choice","ask":"a","choices":["x","y"],"answer":1,"within":1)"), "unknown-key");
  EXPECT_EQ(asked(R"("kind":"guess","ask":"a","answer":1)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"click","ask":"a","structure":"pulp")"), "read");
  EXPECT_EQ(asked(R"("kind":"click","ask":"a","structure":"")"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"click","ask":"a","part":"distal canal")"), "missing-key");
  EXPECT_EQ(asked(R"("kind":"click","ask":"a","structure":"pulp","choices":["a","b"])"), "unknown-key");
  EXPECT_EQ(asked(R"("kind":"number","ask":"a","answer":3)"), "read");
  EXPECT_EQ(asked(R"("kind":"number","ask":"a","answer":3,"within":-1)"), "bad-question");
  EXPECT_EQ(asked(R"("kind":"number","ask":"a","answer":1e10)"), "too-large");
  EXPECT_EQ(asked(R"("kind":"number","ask":"a","answer":NaN)"), "not-finite");
  EXPECT_EQ(asked(R"("kind":"number","ask":"a","answer":3,"unit":"a unit of many letters")"), "bad-title");
  EXPECT_EQ(asked(R"("kind":"number","ask":"a","answer":"3")"), "wrong-type");
}

TEST(Lesson, RefusePinsAndTopsThatMakeNoSense) {
  std::string pins;
  for (std::size_t i = 0; i < most_marks; ++i) pins += R"({"at":[1,2,3]},)";
  EXPECT_EQ(cause_of(with("\"marks\":[" + pins.substr(0, pins.size() - 1) + "]")), "read");
  EXPECT_EQ(cause_of(with("\"marks\":[" + pins + R"({"at":[1,2,3]}])")), "too-many-marks");
  EXPECT_EQ(cause_of(with(R"("marks":[{"at":[1,2]}])")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("marks":[{"at":[1,2,1e300]}])")), "too-large");
  EXPECT_EQ(cause_of(with(R"("marks":[{"label":"x"}])")), "missing-key");
  EXPECT_EQ(cause_of(with(R"("marks":[{"at":[1,2,3],"label":"\u0007"}])")), "bad-title");
  EXPECT_EQ(cause_of(with(R"("tour":"canal 1")", R"("language":"de-AT","feedback":"at-once",)")), "read");
  EXPECT_EQ(cause_of(with(R"("tour":"canal 1")", R"("language":"",)")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("tour":"canal 1")", R"("language":"de AT",)")), "bad-value");
  EXPECT_EQ(cause_of(with(R"("tour":"canal 1")", R"("feedback":"never",)")), "bad-value");
}

TEST(Lesson, RefuseArrowsAndNarrationThatMakeNoSense) {
  const auto arrows = [](const std::string& which) { return cause_of(with("\"arrows\":[" + which + "]")); };
  const std::string one = R"({"from":[1,2,3],"to":[0,0,0]})";
  std::string many;
  for (std::size_t i = 0; i < most_arrows; ++i) many += one + ",";
  EXPECT_EQ(arrows(many.substr(0, many.size() - 1)), "read");
  EXPECT_EQ(arrows(many + one), "too-many-arrows");
  EXPECT_EQ(arrows(R"({"from":[1,2,3],"to":[1,2,3]})"), "bad-arrow");
  EXPECT_EQ(arrows(R"({"from":[1,2,3],"to":[1,2,3.0005]})"), "bad-arrow");
  EXPECT_EQ(arrows(R"({"from":[1,2,3],"to":[1,2]})"), "wrong-type");
  EXPECT_EQ(arrows(R"({"from":[1,2,3,4],"to":[1,2,0]})"), "wrong-type");
  EXPECT_EQ(arrows(R"({"from":[1,2,1e300],"to":[1,2,3]})"), "too-large");
  EXPECT_EQ(arrows(R"({"from":[1,2,NaN],"to":[1,2,3]})"), "not-finite");
  EXPECT_EQ(arrows(R"({"from":[1,2,3]})"), "missing-key");
  EXPECT_EQ(arrows(R"({"to":[1,2,3]})"), "missing-key");
  EXPECT_EQ(arrows(R"({"from":[1,2,3],"to":[0,0,0],"at":[0,0,0]})"), "unknown-key");
  EXPECT_EQ(arrows(R"({"from":[1,2,3],"to":[0,0,0],"label":"\u0007"})"), "bad-title");
  EXPECT_EQ(cause_of(with(R"("narration":"Two\nlines.")")), "read");
  EXPECT_EQ(cause_of(with(R"("narration":3)")), "wrong-type");
  EXPECT_EQ(cause_of(with(R"("narration":")" + std::string(most_text_bytes + 1, 'x') + "\"")), "bad-text");
}

TEST(Lesson, RefuseTranslationsThatMakeNoSense) {
  const auto into = [](const std::string& which) {
    return cause_of(with(R"("tour":"")", "\"translations\":[" + which + "],"));
  };
  EXPECT_EQ(into(R"({"language":"de","texts":[["a","b"]]},{"language":"fr","texts":[]})"), "read");
  EXPECT_EQ(into(R"({"language":"de","texts":[]},{"language":"de","texts":[]})"), "repeated-text");
  EXPECT_EQ(into(R"({"language":"","texts":[]})"), "bad-value");
  EXPECT_EQ(into(R"({"texts":[]})"), "missing-key");
  EXPECT_EQ(into(R"({"language":"de"})"), "missing-key");
  EXPECT_EQ(into(R"({"language":"de","texts":[["a"]]})"), "bad-text");
  EXPECT_EQ(into(R"({"language":"de","texts":[["a","b","c"]]})"), "bad-text");
  EXPECT_EQ(into(R"({"language":"de","texts":[["a","\u0007"]]})"), "bad-text");
  EXPECT_EQ(into(R"({"language":"de","texts":["a"]})"), "wrong-type");
  std::string many, pairs;
  for (std::size_t i = 0; i <= most_translations; ++i)
    many += (i ? "," : "") + std::string(R"({"texts":[],"language":"x)") + std::to_string(i) + "\"}";
  for (std::size_t i = 0; i <= most_translated_texts; ++i) pairs += i ? R"(,["a","b"])" : R"(["a","b"])";
  EXPECT_EQ(into(many), "too-many-texts");
  EXPECT_EQ(into(R"({"language":"de","texts":[)" + pairs + "]}"), "too-many-texts");
}

TEST(Lesson, OfCamerasAloneAreStillVersionOne) {
  const std::string text = to_json(some_tour());
  EXPECT_NE(text.find("\"version\": 1"), std::string::npos);
  EXPECT_EQ(text.find("scene"), std::string::npos);
}

TEST(Lesson, RefuseAScenesFaultsWithTheNotesNumber) {
  const auto cause = [](const std::string& scene) {
    Lesson lesson = some_tour();
    lesson.notes[1].scene = scene;
    try {
      parse_lesson(to_json(lesson), "a.tour.json");
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("a.tour.json, note 2"), std::string::npos) << error.what();
      return std::string(error.cause());
    }
    return std::string("read");
  };
  const std::string head = R"({"format":"odontoscope.scene","version":1,)";
  EXPECT_EQ(cause(head + R"("wire":true})"), "read");
  EXPECT_EQ(cause(head + R"("camera":{"height_mm":-1}})"), "read") << "the note has its own";
  EXPECT_EQ(cause("[]"), "wrong-format");
  EXPECT_EQ(cause(R"({"version":1})"), "wrong-format");
  EXPECT_EQ(cause(head + R"("wire":1})"), "wrong-type");
  EXPECT_EQ(cause(head + R"("structures":[{"name":"enamel","opacity":2}]})"), "bad-value");
  EXPECT_EQ(cause(head + R"("section":{"normal":[0,0,0]}})"), "bad-value");
  EXPECT_EQ(cause(head + R"("headlight":{"reach_mm":-1}})"), "bad-value");
  std::string many = R"({"name":"s0"})";
  for (int i = 1; i <= 1000; ++i) many += R"(,{"name":"s)" + std::to_string(i) + R"("})";
  EXPECT_EQ(cause(head + R"("structures":[)" + many + "]}"), "bad-value");
}

TEST(Lesson, RefuseEachWithItsCause) {
  EXPECT_EQ(cause_of(""), "unparsable");
  EXPECT_EQ(cause_of("{"), "unparsable");
  EXPECT_EQ(cause_of(changed("odontoscope.tour", "odontoscope.lesson")), "wrong-format");
  EXPECT_EQ(cause_of(changed("\"version\": 1", "\"version\": 5")), "wrong-version");
  EXPECT_EQ(cause_of(changed("\"version\": 1", "\"version\": 1.5")), "wrong-version");
  EXPECT_EQ(cause_of(changed("\"title\": \"Three canals\",", "")), "missing-key");
  EXPECT_EQ(cause_of(changed("\"inside\": true", "\"insid\": true")), "unknown-key");
  EXPECT_EQ(cause_of(changed("\"inside\": true", "\"inside\": 1")), "wrong-type");
  EXPECT_EQ(cause_of(changed("\"inside\": true", "\"inside\": true, \"inside\": true")), "repeated-key");
  EXPECT_EQ(cause_of(changed("\"height_mm\": 25.0", "\"height_mm\": -1")), "bad-camera");
  EXPECT_EQ(cause_of(changed("\"height_mm\": 25.0", "\"height_mm\": NaN")), "not-finite");
  EXPECT_EQ(cause_of(changed("\"position\": [\n          0.1,", "\"position\": [\n")), "wrong-type");
  EXPECT_EQ(cause_of(changed("\"position\": [\n          0.1,", "\"position\": [1, 2, 0.1,")), "wrong-type");
  EXPECT_EQ(cause_of(changed("\"position\": [\n          0.1,", "\"position\": [1e300,")), "too-large");
  EXPECT_EQ(cause_of(changed("The chamber", "The\\u0007 chamber")), "bad-title");
  EXPECT_EQ(cause_of(changed("The chamber", std::string(most_title_bytes + 1, 'x'))), "bad-title");
  EXPECT_EQ(cause_of(changed("Its floor", std::string(most_text_bytes + 1, 'x'))), "bad-text");
  EXPECT_EQ(cause_of("{\"format\":\"odontoscope.tour\",\"version\":1,\"title\":\"\",\"notes\":[]}"), "no-notes");
  Lesson many = some_tour();
  many.notes.resize(most_notes + 1, many.notes[0]);
  EXPECT_EQ(cause_of(to_json(many)), "too-many-notes");
  EXPECT_EQ(cause_of(changed("\"inside\": true", "\"inside\": true, \"x-by\": {\"a\": [1]}")), "read");
}

TEST(Lesson, NoChangeOfAByteDoesHarm) {
  const std::string wholes[] = {to_json(some_tour()), to_json(tour_with_scenes()), to_json(quiz_tour()),
                                to_json(tour_with_arrows())};
  RandomNumbers random(3);
  for (int i = 0; i < 6000; ++i) {
    std::string text = wholes[i % 4];
    for (int k = random.whole(1, 4); k > 0; --k) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
      if (random.chance(0.5))
        text[at] = static_cast<char>(random.below(256));
      else if (random.chance(0.5))
        text.erase(at, static_cast<std::size_t>(random.whole(1, 40)));
      else
        text.insert(at, text.substr(static_cast<std::size_t>(random.below(static_cast<int>(text.size()))), 30));
      if (text.empty()) text = " ";
    }
    try {
      const Lesson read = parse_lesson(text, "x");
      EXPECT_EQ(parse_lesson(to_json(read), "again"), read);
    } catch (const InputError&) {
    }
  }
}

TEST(Lesson, AreKnownByTheirNames) {
  EXPECT_TRUE(named_like_a_tour("a/b.tour.json"));
  EXPECT_TRUE(named_like_a_tour("B.TOUR.JSON"));
  EXPECT_FALSE(named_like_a_tour("b.json"));
  EXPECT_FALSE(named_like_a_tour(".tour.json"));
}

}  // namespace
}  // namespace odontoscope::test
