// Lessons and quizzes as a student takes them: by mouse, and by the keyboard alone.

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/navigate/built_in_lessons.h"
#include "engine/navigate/screen.h"
#include "engine/viewer/look/annotations.h"
#include "tests/ui/lessons_fixture.h"

namespace odontoscope::testing_support {
namespace {

TEST_F(LessonsTest, TheMenuListsThemAndOpensOne) {
  viewer_with_tooth();
  type(U'g');
  ASSERT_TRUE(lesson().menu());
  frame();
  press_key(Key::down);
  press_key(Key::down);
  press_key(Key::up);
  press_key(Key::enter);
  wait_until_loaded();
  EXPECT_FALSE(lesson().menu());
  EXPECT_EQ(notes().lesson.title, "Down the three canals");
  EXPECT_EQ(notes().shown, std::optional<std::size_t>(0));
  EXPECT_FALSE(notes().unsaved);
  type(U'g');
  type(U'1');
  frames(3);
  EXPECT_EQ(notes().lesson.title, "The tooth and its tissues");
  type(U'g');
  press_key(Key::escape);
  EXPECT_FALSE(lesson().menu());
  EXPECT_TRUE(notes().shown) << "Esc closed the menu alone";
}

TEST_F(LessonsTest, ABuiltInLessonBringsTheSampleMolar) {
  std::vector<std::string> loaded;
  viewer_with_tooth({.load = [&loaded](const LoadRequest& request, const Progress&) {
    loaded.push_back(request.file);
    return toy_tooth();
  }});
  viewer().open({.file = "another.json"});
  wait_until_loaded();
  viewer().open({.lesson = 0});
  frame();
  wait_until_loaded();
  EXPECT_EQ(loaded, (std::vector<std::string>{"", "another.json", ""}));
  EXPECT_EQ(notes().lesson.title, built_in_lessons()[0].title);
}

TEST_F(LessonsTest, AQuizIsTakenByTheKeyboardAloneAndItsMarksAreSaved) {
  const ScratchFolder scratch;
  viewer_with(toy_tooth(), {.folder = scratch.path()});
  size_ = {960, 640};
  take(toy_quiz(viewer()));
  ASSERT_TRUE(lesson().quiz());
  EXPECT_TRUE(lesson().wants_click(notes()));
  EXPECT_FALSE(mode<NamesMode>().names_shown()) << "they would give it away";
  press_key(Key::right);  // turns the tooth
  press_key(Key::enter);  // at the cross
  EXPECT_EQ(lesson().feedback(notes()), "Right: enamel.");
  press_key(Key::enter);
  settle();
  ASSERT_EQ(notes().shown, std::optional<std::size_t>(1));
  frame(0.5);
  type(U'3');  // there is no third: from mesial, as ever
  EXPECT_TRUE(lesson().asked(notes()));
  type(U'1');
  EXPECT_EQ(lesson().feedback(notes()), "You said enamel. It is pulp.");
  type(U'2');
  EXPECT_EQ(lesson().row(notes())->given, "enamel") << "an answer stands";
  keep_picture("quiz-choice");
  press_key(Key::page_down);
  settle();
  type_all(U"x12,8");
  EXPECT_EQ(lesson().typed(), "12,8");
  press_key(Key::backspace);
  type(U'9');
  press_key(Key::enter);
  EXPECT_TRUE(lesson().row(notes())->right);
  EXPECT_EQ(lesson().row(notes())->given, "12.9 mm");
  press_key(Key::enter);
  frame();
  ASSERT_TRUE(lesson().result());
  EXPECT_EQ(lesson().quiz()->score(), 2u);
  EXPECT_GE(lesson().quiz()->rows[1].seconds, 0.5);
  frames(3);
  keep_picture("quiz-result");
  press_key(Key::enter);
  frames(2);
  const auto files = files_in(scratch.path());
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].filename(), "Toy-quiz-marks-001.csv");
  EXPECT_EQ(files[1].filename(), "Toy-quiz-marks-001.json");
  std::ifstream csv(files[0]);
  std::string head, first;
  std::getline(csv, head);
  std::getline(csv, first);
  EXPECT_EQ(head, "number,kind,question,given,right,seconds");
  EXPECT_EQ(first.substr(0, first.rfind(',')), "1,click,Click the enamel.,enamel,yes");
  std::ifstream json(files[1]);
  EXPECT_EQ(nlohmann::json::parse(json)["score"], 2);
  press_key(Key::escape);
  press_key(Key::escape);
  EXPECT_FALSE(notes().shown);
}

TEST_F(LessonsTest, AQuizIsTakenByTheMouse) {
  viewer_with_tooth();
  size_ = {960, 640};
  take(toy_quiz(viewer(), true));
  const Area& area = viewer().panes().front().area;
  click(area.left + 4, area.top + area.height - 4);  // nothing there
  EXPECT_TRUE(lesson().wants_click(notes()));
  drag(middle().x, middle().y, middle().x + 60, middle().y);
  EXPECT_TRUE(lesson().wants_click(notes())) << "a drag turns the tooth";
  click(middle().x, middle().y);
  EXPECT_NE(lesson().feedback(notes()).find("at the end"), std::string::npos) << "nothing is told yet";
  click_control("Next (Page down)", {}, "note");
  settle();
  click_control("2   pulp", {}, "note");
  EXPECT_EQ(lesson().row(notes())->given, "pulp");
  click_control("Next (Page down)", {}, "note");
  settle();
  click_control("Result (Page down)", {}, "note");  // the last one is passed over
  frames(2);
  ASSERT_TRUE(lesson().result());
  EXPECT_EQ(lesson().quiz()->score(), 2u);
  EXPECT_FALSE(lesson().quiz()->finished());
  click_control("Back (Page up)", {}, "quiz result");
  EXPECT_FALSE(lesson().result());
  EXPECT_TRUE(lesson().asked(notes())) << "it can still be answered";
  press_key(Key::page_down);
  click_control("Once more", {}, "quiz result");
  settle();
  EXPECT_EQ(notes().shown, std::optional<std::size_t>(0));
  EXPECT_EQ(lesson().quiz()->score(), 0u);
}

TEST_F(LessonsTest, WordsStandBelowThePictureAndCoverNothing) {
  viewer_with_tooth();
  size_ = {960, 640};
  frames(2);
  const double whole = viewer().panes().front().area.height;
  EXPECT_EQ(whole, 640);
  take(toy_quiz(viewer()));
  const Area area = viewer().panes().front().area;
  EXPECT_LT(area.height, whole - 60);
  for (const Interface::Place& place : viewer().interface().places)
    if (place.window == control_id("", {}, "note")) {
      EXPECT_GE(place.top, area.top + area.height - 1);
    }
  press_key(Key::escape);
  frames(3);
  EXPECT_EQ(viewer().panes().front().area.height, whole);
}

TEST_F(LessonsTest, ANoteRidesDownTheCanalThatItNames) {
  viewer_with(sample_tooth_loaded());
  Lesson lesson = built_in_lesson(1);
  take(lesson);
  notes().go_to = 2;
  frames(2);
  settle();
  ASSERT_TRUE(fly().on);
  ASSERT_TRUE(fly().ride);
  const auto lines = rideable(spaces().cavities.at(*fly().cavity).lines);
  EXPECT_EQ(lines[fly().ride->line]->name, "mesiobuccal canal");
  EXPECT_TRUE(fly().ride->playing);
  viewer().state().settings.comfort.reduced_motion = true;  // to where the ride ends, without riding
  notes().go_to = 4;
  frames(2);
  settle();
  ASSERT_TRUE(fly().on);
  EXPECT_FALSE(fly().ride && fly().ride->playing);
  ASSERT_TRUE(fly().place);
  EXPECT_EQ(lines[fly().place->line]->name, "distal canal");
  EXPECT_LT(fly().place->to_end, 1.5);
}

TEST_F(LessonsTest, ANoteTakenInACanalCanRideDownIt) {
  viewer_with(sample_tooth_loaded());
  size_ = {1280, 800};
  type(U'c');
  fade();
  type(U'3');
  fade();
  type(U'n');
  frames(3);
  ASSERT_TRUE(notes().draft);
  const std::string canal = rideable(spaces().cavities.at(*fly().cavity).lines)[fly().place->line]->name;
  click_control("Ride down the " + canal, {}, "note draft");
  EXPECT_EQ(notes().draft->tour, canal);
}

/// A window at rest draws twice a second and cuts its frames short; the pupil's time goes on.
TEST_F(LessonsTest, TimeIsTheClocks) {
  viewer_with_tooth();
  take(toy_quiz(viewer()));
  frame(0);
  const double before = lesson().row(notes())->seconds;
  std::this_thread::sleep_for(std::chrono::milliseconds(120));
  frame(0.01);
  EXPECT_GE(lesson().row(notes())->seconds - before, 0.12);
}

TEST_F(LessonsTest, EveryBuiltInLessonIsTrueOfTheSampleMolar) {
  viewer_with(sample_tooth_loaded(), {.settings = {.panel = false}});
  for (std::size_t number = 0; number < built_in_lessons().size(); ++number) {
    const Lesson lesson = built_in_lesson(number);
    for (const LessonNote& note : lesson.notes) {
      if (note.inside) {
        const auto inside = [&](const FlightSpace& space) {
          return space.walls.locate(note.camera.position) == Walls::Side::inside &&
                 space.walls.nearest(note.camera.position).distance >= spaces().rules.clearance;
        };
        EXPECT_TRUE(std::any_of(spaces().cavities.begin(), spaces().cavities.end(), inside)) << note.title;
      }
      for (const LessonPin& mark : note.marks) {
        const Box& box = viewer().state().shown->model.bounds_mm;
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_TRUE(mark.at[axis] >= box.low[axis] - 0.3 && mark.at[axis] <= box.high[axis] + 0.3)
              << note.title << ": " << mark.label;
      }
    }
  }
}

/// Somewhere in the picture each of the quiz's questions to click can be answered rightly.
TEST_F(LessonsTest, WhatIsToBeClickedCanBeClicked) {
  viewer_with(sample_tooth_loaded(), {.settings = {.panel = false}});
  const Lesson quiz = built_in_lesson(4);
  std::size_t clicks = 0;
  take(quiz);
  for (std::size_t i = 0; i < quiz.notes.size(); ++i) {
    if (!quiz.notes[i].question || quiz.notes[i].question->kind != LessonQuestion::Kind::click) continue;
    ++clicks;
    notes().go_to = i;
    frame();
    for (int wait = 0; wait < 4; ++wait) frame(0.5);
    glm::dvec3 at{0, 4.5, 17};  // the crown's buccal side
    for (const CentreLine* line : rideable(spaces().cavities.front().lines))
      if (line->name == quiz.notes[i].question->part) {
        const Point3& half_way = line->points[line->points.size() / 2].at;
        at = {half_way.x, half_way.y, half_way.z};
      }
    const ViewPane& pane = viewer().panes().front();
    const auto place = place_of(pane.camera, at);
    ASSERT_TRUE(place);
    const glm::dvec2 pixel = pixel_of(pane.area, *place);
    click(pixel.x, pixel.y);
    ASSERT_TRUE(lesson().row(notes()));
    EXPECT_TRUE(lesson().row(notes())->right) << quiz.notes[i].question->ask << " " << lesson().row(notes())->given;
  }
  EXPECT_GE(clicks, 3u);
}

TEST_F(LessonsTest, ArrowsAreSeenInALessonAndHiddenByWalls) {
  viewer_with(toy_tooth(), {.settings = {.panel = false}});
  const auto picture_with = [&](const std::vector<LessonArrow>& arrows, bool inside) {
    LessonNote note = note_of(viewer().state().scene, inside ? TakenFrom::inside : TakenFrom::outside);
    note.title = "Here";
    note.arrows = arrows;
    Lesson lesson{"Arrows", "", {note}};
    take(lesson);
    return picture();
  };
  const Image none = picture_with({}, false);
  EXPECT_FALSE(picture_with({{{0, -9, 4}, {0, 0, 4}, "pulp"}}, false) == none);
  keep_picture("arrow-lesson");
  take({"None", "", {}});
  type(U'c');
  fade();
  ASSERT_TRUE(fly().on);
  const Image within = picture_with({}, true);
  EXPECT_TRUE(picture_with({{{0, -9, 4}, {0, -9, 5}, "outside"}}, true) == within) << "its head lies behind a wall";
  const glm::dvec3 eye = fly().flight.eye, ahead = eye + 0.3 * fly().flight.view_direction;
  EXPECT_FALSE(picture_with({{eye - ahead, ahead, ""}}, true) == within) << "it begins behind the eye";
}

TEST_F(LessonsTest, NarrationIsFoldedUntilSomebodyWantsIt) {
  viewer_with(toy_tooth(), {.settings = {.panel = false}});
  LessonNote note = note_of(viewer().state().scene, TakenFrom::outside);
  note.title = "Here";
  note.text = "Short.";
  note.narration = "What is said at length, of all that can be seen here.";
  take(Lesson{"Said", "", {note, note}});
  EXPECT_FALSE(lesson().narration_open);
  const double folded = lesson().dock_height;
  click_control("Narration", {}, "note");
  frames(4);
  EXPECT_TRUE(lesson().narration_open);
  EXPECT_GT(lesson().dock_height, folded + 10);
  keep_picture("narration");
  press_key(Key::page_down);
  EXPECT_TRUE(lesson().narration_open) << "at the next note, too";
}

}  // namespace
}  // namespace odontoscope::testing_support
