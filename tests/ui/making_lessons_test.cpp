// Lessons and quizzes as a teacher makes them.

#include <filesystem>
#include <fstream>

#include "engine/navigate/screen.h"
#include "engine/viewer/look/annotations.h"
#include "tests/ui/lessons_fixture.h"

namespace odontoscope::testing_support {
namespace {

TEST_F(LessonsTest, ATeacherMakesAQuizAndAStudentOpensIt) {
  const ScratchFolder scratch;
  size_ = {1280, 800};
  viewer_with(toy_tooth(), {.folder = scratch.path()});
  notes().write = true;
  frames(3);
  ASSERT_TRUE(notes().draft);
  type_all(U"Look");
  click_control("Place a pin", {}, "note draft");
  ASSERT_EQ(notes().placing, NotesState::Placing::pin);
  frames(2);
  click(middle().x, middle().y);
  ASSERT_EQ(notes().draft->marks.size(), 1u);
  notes().draft->marks[0].label = "here";
  frames(2);
  click_control("Click", {"question"}, "note draft");
  ASSERT_TRUE(notes().draft->question);
  EXPECT_FALSE(fault_of(*notes().draft->question).empty());
  notes().draft->question->ask = "Click the enamel.";
  frames(2);
  keep_picture("note-editor");
  click_control("Show what is right", {}, "note draft");
  frames(2);
  press_key(Key::enter);  // at the cross
  EXPECT_EQ(notes().draft->question->structure.empty(), false);
  frames(2);
  click_control("Keep the note", {}, "note draft");
  ASSERT_EQ(notes().lesson.notes.size(), 1u);
  notes().save = true;
  frames(2);
  const auto files = files_in(scratch.path());
  ASSERT_EQ(files.size(), 1u);
  const Lesson saved = read_lesson(files[0].string());
  EXPECT_EQ(saved.notes[0].title, "Look");
  EXPECT_EQ(saved.notes[0].marks.at(0).label, "here");
  EXPECT_TRUE(saved.is_quiz());

  viewer_with(toy_tooth());
  viewer().handle(FilesDropped{{files[0].string()}});
  frames(2);
  settle();
  EXPECT_TRUE(lesson().wants_click(notes()));
}

TEST_F(LessonsTest, NotesAreChangedMovedRemovedAndBroughtBack) {
  viewer_with_tooth();
  Lesson lesson = toy_quiz(viewer());
  take(lesson);
  move_note(notes(), 0, 1);
  EXPECT_EQ(notes().lesson.notes[0].title, "Choose");
  EXPECT_EQ(notes().shown, std::optional<std::size_t>(1)) << "the same note is still shown";
  move_note(notes(), 0, -1);
  EXPECT_EQ(notes().lesson.notes[0].title, "Choose") << "there is nothing above the first";
  frames(2);
  remove_note(notes(), 0);
  frames(2);
  ASSERT_EQ(notes().lesson.notes.size(), 2u);
  remove_note(notes(), 1);
  frames(2);
  undo();
  undo();
  settle();  // it led to what came back
  ASSERT_EQ(notes().lesson.notes.size(), 3u);
  EXPECT_EQ(notes().lesson.notes[0].title, "Choose");
  EXPECT_TRUE(notes().unsaved);
  edit_note(notes(), 1);
  frames(3);
  notes().draft->title = "Click it";
  const Camera before = notes().draft->camera;
  press_key(Key::escape);
  EXPECT_EQ(notes().lesson.notes[1].title, "Click") << "Esc changes nothing";
  edit_note(notes(), 1);
  notes().draft->title = "Click it";  // before the field has the keyboard
  frames(2);
  viewer().state().scene.camera.position.x += 3;
  notes().retake = true;
  frames(2);
  EXPECT_NE(notes().draft->camera, before);
  keep_draft(notes());
  EXPECT_EQ(notes().lesson.notes.size(), 3u);
  EXPECT_EQ(notes().lesson.notes[1].title, "Click it");
  EXPECT_TRUE(notes().lesson.notes[1].question) << "it is still what it was otherwise";
}

TEST_F(LessonsTest, EveryChangeIsUndoneAndDoneAgain) {
  const ScratchFolder scratch;
  viewer_with_tooth();
  const std::filesystem::path file = scratch.path() / "toy.tour.json";
  std::ofstream(file) << to_json(toy_quiz(viewer()));
  viewer().handle(FilesDropped{{file.string()}});
  frames(2);
  press_key(Key::escape);
  frames(2);
  std::vector<Lesson> states{notes().lesson};
  const auto changed = [&](auto&& change) {
    change();
    frames(2);
    EXPECT_NE(notes().lesson, states.back());
    states.push_back(notes().lesson);
  };
  const auto edited = [&](auto&& change) {
    changed([&] {
      edit_note(notes(), 1);
      frames(2);
      press_key(Key::escape);  // out of the title
      edit_note(notes(), 1);
      notes().fresh_draft = false;
      frames(2);
      change(*notes().draft);
      frames(2);
      keep_draft(notes());
    });
  };
  changed([&] { notes().lesson.title = "Another title"; });
  changed([&] { move_note(notes(), 0, 1); });
  changed([&] { notes().lesson.feedback_at_end = true; });
  edited([](LessonNote& note) { note.text = "Look."; });
  edited([](LessonNote& note) { note.narration = "Look well."; });
  edited([](LessonNote& note) { note.marks.push_back({{0, 0, 4}, "here"}); });
  edited([](LessonNote& note) { note.arrows.push_back({{0, 9, 4}, {0, 0, 4}, "there"}); });
  edited([](LessonNote& note) { note.question.reset(); });
  edited([&](LessonNote& note) {
    note.camera.position.x += 3;
    note.text = "Another view.";  // two changes while it is written, one of the lesson
  });
  edited([](LessonNote& note) { note.scene = ""; });
  changed([&] { remove_note(notes(), 0); });
  changed([&] {
    notes().write = true;
    frames(2);
    notes().draft->text = "New.";
    frames(2);
    keep_draft(notes());
  });
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    undo();
    EXPECT_EQ(notes().lesson, states[i - 1]) << i;
    EXPECT_FALSE(notes().draft);
  }
  EXPECT_FALSE(notes().unsaved) << "it is as it was opened";
  undo();
  EXPECT_EQ(notes().lesson, states[0]) << "there is nothing before the first";
  for (std::size_t i = 1; i < states.size(); ++i) {
    redo();
    EXPECT_EQ(notes().lesson, states[i]) << i;
  }
  redo();
  EXPECT_EQ(notes().lesson, states.back());
  undo();
  changed([&] { notes().lesson.title = "Elsewhere"; });
  const Lesson now = notes().lesson;
  redo();
  EXPECT_EQ(notes().lesson, now) << "what was undone is gone after another change";
}

TEST_F(LessonsTest, ANoteBeingWrittenIsUndoneStepByStep) {
  viewer_with_tooth();
  frames(2);
  notes().write = true;
  frames(3);
  type_all(U"Cusp");              // one change, of four letters
  click(middle().x, middle().y);  // the picture: the field lets go
  frames(2);
  notes().draft->marks.push_back({{0, 0, 4}, "here"});
  frames(2);
  notes().retake = true;
  viewer().state().scene.camera.position.x += 3;
  frames(2);
  const LessonNote whole = *notes().draft;
  undo();
  EXPECT_NE(notes().draft->camera, whole.camera);
  undo();
  EXPECT_TRUE(notes().draft->marks.empty());
  EXPECT_EQ(notes().draft->title, "Cusp");
  undo();
  ASSERT_TRUE(notes().draft);
  EXPECT_EQ(notes().draft->title, "");
  redo();
  redo();
  redo();
  EXPECT_EQ(*notes().draft, whole);
  press_key(Key::escape);
  frames(2);
  EXPECT_FALSE(notes().draft);
  undo();
  ASSERT_TRUE(notes().draft) << "cancelled by mistake";
  EXPECT_EQ(*notes().draft, whole);
}

TEST_F(LessonsTest, AnArrowIsDrawnByTwoClicksAndPointsAtTheSameFromAnySide) {
  size_ = {1280, 800};
  viewer_with_tooth();
  notes().write = true;
  frames(3);
  click_control("Draw an arrow", {}, "note draft");
  ASSERT_EQ(notes().placing, NotesState::Placing::arrow_tail);
  frames(2);
  const Area area = viewer().panes().front().area;
  const glm::dvec2 beside(area.left + 0.1 * area.width, area.top + 0.2 * area.height);
  const Camera first = viewer().panes().front().camera;
  click(beside.x, beside.y);
  ASSERT_EQ(notes().placing, NotesState::Placing::arrow_head);
  frames(2);
  keep_picture("arrow-begun");
  click(beside.x, beside.y);  // nothing is there
  EXPECT_EQ(notes().placing, NotesState::Placing::arrow_head);
  frames(2);
  click(middle().x, middle().y);
  ASSERT_EQ(notes().draft->arrows.size(), 1u);
  EXPECT_EQ(notes().placing, NotesState::Placing::none);
  const LessonArrow drawn = notes().draft->arrows[0];
  const auto pixel = [&](const glm::dvec3& at) { return pixel_of(area, *place_of(first, at)); };
  EXPECT_LT(glm::distance(pixel(drawn.from), beside), 1e-6);
  EXPECT_LT(glm::distance(pixel(drawn.to), glm::dvec2(area.left + area.width / 2, area.top + area.height / 2)), 1);
  EXPECT_NEAR(depth_of(first, drawn.from), depth_of(first, drawn.to), 1e-6) << "both in the picture's plane";

  notes().draft->arrows[0].label = "the crown";
  frames(2);
  keep_picture("arrow-editor");
  notes().redrawn = 0;
  notes().placing = NotesState::Placing::arrow_tail;
  frames(2);
  press_key(Key::enter);  // at the cross
  click(middle().x + 60, middle().y);
  ASSERT_EQ(notes().draft->arrows.size(), 1u);
  EXPECT_NE(notes().draft->arrows[0].to, drawn.to);
  EXPECT_EQ(notes().draft->arrows[0].label, "the crown") << "drawn anew, it says the same";
}

TEST_F(LessonsTest, WhileANoteIsWrittenLettersAndTabStayWithIt) {
  viewer_with_tooth();
  notes().write = true;
  frames(3);
  for (int i = 0; i < 40; ++i) {
    press_key(Key::tab);
    for (const Interface::Place& place : viewer().interface().places)
      if (viewer().interface().on_control(place.id)) {
        EXPECT_NE(place.window, control_id("", {}, "panel")) << "the panel lies behind";
      }
    type(U's');  // into a field, or nowhere
  }
  EXPECT_FALSE(viewer().state().scene.section);
  EXPECT_TRUE(notes().draft);
}

}  // namespace
}  // namespace odontoscope::testing_support
