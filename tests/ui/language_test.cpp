// The viewer in another language: chosen, said everywhere that is looked at, and nothing of it cut off.
#include "engine/language/language.h"

#include <algorithm>

#include "engine/navigate/built_in_lessons.h"
#include "engine/viewer/notes/lesson_words.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

class LanguageInTheWindow : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    size_ = {1280, 1700};  // all of the panel
  }

  Viewer& german() {
    ViewerOptions options;
    options.language = known_language("de");
    options.load = [](const LoadRequest&, const Progress&) {
      LoadedModel loaded = toy_tooth();
      loaded.tooth = "lower left first molar: FDI 36, Universal 19";
      return loaded;
    };
    return viewer_with_tooth(std::move(options));
  }
  void expect_all_fits(const char* where) {
    frames(3);
    std::string cut;
    for (const std::string& words : viewer().interface().cut_off) cut += "\n  " + words;
    EXPECT_EQ(cut, "") << where;
  }
};

TEST_F(LanguageInTheWindow, IsChosenInThePanelAndRemembered) {
  if (!viewer_with_tooth().state().shown) GTEST_SKIP();
  EXPECT_EQ(viewer().interface().language().tag, "en");
  EXPECT_EQ(viewer().interface().say("Fly inside (C)"), "Fly inside (C)");
  click_control("Deutsch", {"language"});
  frames(2);
  EXPECT_EQ(viewer().state().settings.language, "de");
  EXPECT_EQ(viewer().interface().say("Fly inside (C)"), "Hinein (C)");
  click_control("Structures");  // controls keep their names for keyboard and scripts
  const ReadSettings read = settings_from_json(to_json(viewer().state().settings));
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.settings.language, "de");
  click_control("English", {"language"});
  frames(2);
  EXPECT_EQ(viewer().interface().language().tag, "en");
}

TEST_F(LanguageInTheWindow, ChangesThePictureAndTheTitle) {
  viewer_with_tooth();
  const Image english = picture();
  german();
  EXPECT_NE(viewer().title().find("unterer linker erster Molar"), std::string::npos) << viewer().title();
  EXPECT_NE(picture(), english);
}

TEST_F(LanguageInTheWindow, HasRoomForItsWords) {
  german();
  for (const char* section : {"Report", "Overlays", "Picture", "Notes"}) click_control(section);
  expect_all_fits("the panel");
  keep_picture("german_panel");
  type('?');
  expect_all_fits("the keys");
  keep_picture("german_keys");
  press_key(Key::escape);
  type('g');
  expect_all_fits("the lessons");
  press_key(Key::escape);
  press_key(Key::o, {.control = true});
  expect_all_fits("the files");
  press_key(Key::escape);
  viewer().state().pending_actions.push_back(Action::write_note);
  mode<NotesMode>().notes().write = true;
  expect_all_fits("a note");
  keep_picture("german_note");
  NotesState& notes = mode<NotesMode>().notes();
  notes.draft->arrows.push_back({{0, 9, 4}, {0, 0, 4}, ""});
  expect_all_fits("a note's arrows");
  notes.placing = NotesState::Placing::arrow_tail;
  expect_all_fits("where an arrow begins");
  press_key(Key::escape);
  keep_draft(notes);
  expect_all_fits("undo and redo");
  keep_picture("german_undo");
  press_key(Key::z, {.control = true});
  type('c');
  frames(30, 0.1);
  expect_all_fits("in flight");
  type('?');
  expect_all_fits("the keys of flight");
  keep_picture("german_flight");
}

TEST_F(LanguageInTheWindow, TellsWhyAFileCannotBeReadAndBelowPreciselyInEnglish) {
  german();
  const std::string trouble =
      "squares.json: slice 1 (z = 1), contour 0, point 2 at (1, 2): the edge after this point crosses contour 1 after "
      "its point 3; both belong to \"tooth\". Merge the two contours, or give them different structures. "
      "[contours-cross]";
  viewer().state().trouble = trouble;
  expect_all_fits("an error");
  keep_picture("german_error");
  const Image told = picture();
  ViewerOptions without;
  without.language = known_language("de");
  without.language.errors.clear();
  viewer_with_tooth(std::move(without));
  viewer().state().trouble = trouble;
  frames(3);
  EXPECT_NE(picture(), told);
}

TEST_F(LanguageInTheWindow, WhatHasNoRoomIsNoticed) {
  ViewerOptions options;
  options.language = known_language("de");
  options.language.texts["Triangle edges"] = "Dreieckskanten sämtlicher Oberflächen aller Strukturen";
  viewer_with_tooth(std::move(options));
  click_control("Overlays");
  frames(2);
  EXPECT_EQ(viewer().interface().cut_off.size(), 1u);
}

TEST(LessonWords, AreTranslatedAndAnswersStay) {
  const Language german = known_language("de");
  for (std::size_t i = 0; i < built_in_lessons().size(); ++i) {
    const Lesson english = built_in_lesson(i), tour = translated(english, german);
    EXPECT_NE(tour.title, english.title);
    EXPECT_EQ(tour.language, "de");
    for (std::size_t k = 0; k < tour.notes.size(); ++k) {
      EXPECT_EQ(tour.notes[k].tour, english.notes[k].tour);
      EXPECT_TRUE(english.notes[k].text.empty() || tour.notes[k].text != english.notes[k].text);
      if (!tour.notes[k].question) continue;
      EXPECT_EQ(tour.notes[k].question->structure, english.notes[k].question->structure);
      EXPECT_EQ(tour.notes[k].question->part, english.notes[k].question->part);
      EXPECT_NE(tour.notes[k].question->ask, english.notes[k].question->ask);
      EXPECT_EQ(fault_of(*tour.notes[k].question), "");
    }
    EXPECT_EQ(translated(english, Language{}), english);
    EXPECT_EQ(parse_lesson(to_json(tour), "again"), tour);
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
