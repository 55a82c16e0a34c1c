// A teacher's notes in the viewer: written, saved, played, and never lost without a question.

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <thread>

#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

class NotesTest : public FlightTest {
 protected:
  NotesState& notes() { return mode<NotesMode>().notes(); }
  void write_note(const std::string& title) {
    notes().write = true;
    frame();
    notes().draft->title = title;
    keep_draft(notes());
  }
  /// The tour that is in this folder.
  static std::filesystem::path tour_in(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (named_like_a_tour(entry.path().string())) return entry.path();
    return {};
  }
  /// Without the lesson's dialog, and at rest.
  Image view_alone() {
    notes().shown.reset();
    viewer().state().notices.clear();
    for (int i = 0; i < 6; ++i) frame(0.3);
    return picture();
  }
};

constexpr bool no_panel = false;

TEST_F(NotesTest, ANoteBringsBackTheWholeViewPixelByPixel) {
  const ScratchFolder scratch;
  const auto start = [&] { viewer_with(toy_tooth(), {.settings = {.panel = no_panel}, .folder = scratch.path()}); };
  start();
  type(U'2');
  frames(60);
  Scene& scene = viewer().state().scene;
  type(U's');
  scene.look_of("enamel")->opacity = 0.4f;
  scene.look_of("dentine")->colour = colour_of(0x3366aa);
  scene.look_of("dentine")->opacity = 1;
  scene.look_of("pulp")->visible = false;
  scene.back_faces = BackFaces::tint;
  scene.wire = true;
  scene.overlays.edges = true;
  scene.occlusion = {.on = true, .strength = 1.5f, .reach = 0.2f};
  const Image as_noted = view_alone();
  const Scene scene_noted = scene;
  write_note("Cut open");
  notes().save = true;
  frame();
  type(U'c');
  fade();
  const Image inside = view_alone();
  write_note("Inside");
  notes().save = true;
  frame();

  start();
  const Image fresh = view_alone();
  EXPECT_FALSE(fresh == as_noted);
  viewer().handle(FilesDropped{{(scratch.path() / "Toy-tooth-002.tour.json").string()}});
  frame();
  EXPECT_EQ(notes().shown, std::optional<std::size_t>(0));
  for (int i = 0; i < 12; ++i) frame(0.1);
  press_key(Key::page_down);
  fade();
  EXPECT_TRUE(fly().on);
  EXPECT_EQ(viewer().state().scene.headlight.has_value(), true);
  press_key(Key::page_up);  // out of the pulp, by a fade
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_EQ(viewer().state().scene, scene_noted);
  EXPECT_TRUE(view_alone() == as_noted);
  notes().go_to = 1;
  frame();
  fade();
  EXPECT_TRUE(view_alone() == inside);
}

TEST_F(NotesTest, ALessonLeadsSmoothlyFromNoteToNote) {
  viewer_with_tooth();
  Scene& scene = viewer().state().scene;
  scene.look_of("enamel")->opacity = 1;
  write_note("Whole");
  scene.look_of("enamel")->opacity = 0.2f;
  write_note("Translucent");
  scene.look_of("enamel")->visible = false;
  write_note("Bare");
  notes().go_to = 0;
  frame();
  frames(90);
  const auto shown = [&] {
    const Look& look = *viewer().state().scene.look_of("enamel");
    return look.visible ? look.opacity : 0;
  };
  EXPECT_EQ(shown(), 1);
  for (const bool with_pad : {false, true}) {
    float before = shown();
    if (with_pad) {
      viewer().handle(GamepadChanged{.present = true, .next_note = true});
      viewer().handle(GamepadChanged{.present = true});
    } else {
      viewer().handle(KeyChanged{Key::page_down, true});
    }
    int steps = 0;
    for (int i = 0; i < 70; ++i) {
      frame();
      EXPECT_LE(shown(), before + 1e-6f);
      EXPECT_LT(before - shown(), 0.05f) << "a jump";
      steps += shown() != before ? 1 : 0;
      before = shown();
    }
    EXPECT_GT(steps, 20);
    EXPECT_EQ(shown(), with_pad ? 0 : 0.2f);
  }
  EXPECT_FALSE(viewer().state().scene.look_of("enamel")->visible);
  viewer().handle(GamepadChanged{.present = true, .previous_note = true});
  frame();
  viewer().handle(MouseButtonChanged{MouseButton::left, true});  // a person who takes over finds what was on its way
  frame();
  EXPECT_EQ(shown(), 0.2f);
}

TEST_F(NotesTest, AnotherModelAsksBeforeNotesAreLost) {
  const ScratchFolder scratch;
  viewer_with(toy_tooth(), {.folder = scratch.path()});
  const auto tooth = viewer().state().shown;
  const auto drop_another = [&] {
    viewer().handle(FilesDropped{{"another.json"}});
    frames(3);
  };
  write_note("Mine");
  drop_another();
  ASSERT_TRUE(notes().leaving);
  keep_picture("notes-leaving");
  EXPECT_FALSE(viewer().loading());
  press_key(Key::escape);
  EXPECT_FALSE(notes().leaving);
  EXPECT_EQ(viewer().state().shown, tooth);
  EXPECT_EQ(notes().lesson.notes.size(), 1u);

  drop_another();
  click_control("Save them, then open", {}, "leaving");
  wait_until_loaded();
  EXPECT_NE(viewer().state().shown, tooth);
  EXPECT_TRUE(notes().lesson.notes.empty());
  const auto saved = tour_in(scratch.path());
  ASSERT_FALSE(saved.empty());
  EXPECT_EQ(read_lesson(saved.string()).notes.at(0).title, "Mine");

  notes().write = true;  // only begun, and yet somebody's words
  frame();
  notes().draft->text = "Half a thought";
  drop_another();
  ASSERT_TRUE(notes().leaving);
  click_control("Open without saving", {}, "leaving");
  wait_until_loaded();
  EXPECT_FALSE(notes().draft);
  drop_another();
  EXPECT_FALSE(notes().leaving) << "there is nothing to lose";
}

TEST_F(NotesTest, NotesWrittenWhileAModelIsMadeAreSavedByThemselves) {
  const ScratchFolder scratch;
  std::atomic<bool> may_end = true;
  const auto load = [&](const LoadRequest&, const Progress&) {
    while (!may_end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return toy_tooth();
  };
  viewer_with_tooth({.load = load, .folder = scratch.path()});
  may_end = false;
  viewer().open({});
  ASSERT_TRUE(viewer().loading());
  write_note("In between");
  may_end = true;
  wait_until_loaded();
  EXPECT_FALSE(tour_in(scratch.path()).empty());
}

TEST_F(NotesTest, ClosingAsksToo) {
  const ScratchFolder scratch;
  viewer_with(toy_tooth(), {.folder = scratch.path()});
  EXPECT_TRUE(viewer().may_close());
  write_note("Mine");
  EXPECT_FALSE(viewer().may_close());
  frames(2);
  click_control("Stay (Esc)", {}, "leaving");
  EXPECT_FALSE(viewer().state().close);
  EXPECT_FALSE(viewer().may_close());
  frames(2);
  click_control("Save them, then close", {}, "leaving");
  EXPECT_TRUE(viewer().state().close);
  EXPECT_FALSE(tour_in(scratch.path()).empty());
}

TEST_F(NotesTest, WhereNothingCanBeSavedNothingIsLost) {
  viewer_with(toy_tooth(), {.folder = "/no/such/folder"});
  write_note("Mine");
  EXPECT_FALSE(viewer().may_close());
  frames(2);
  click_control("Save them, then close", {}, "leaving");
  EXPECT_FALSE(viewer().state().close);
  EXPECT_FALSE(viewer().state().trouble.empty());
  EXPECT_EQ(notes().lesson.notes.size(), 1u);
}

TEST_F(NotesTest, OverAVolumeNameNoFileThatWouldBeAskedAbout) {
  const ScratchFolder scratch;
  make_viewer({.load = [](const LoadRequest&, const Progress&) { return toy_tooth(); },
               .wants_level =
                   [](const LoadRequest& request) {
                     return !request.from_command_line && request.file.ends_with(".nrrd");
                   },  // the command line said it
               .folder = scratch.path()});
  for (const char* file : {"tooth.nrrd", "tooth.json"}) {
    viewer().open({.file = file, .volume = {}, .from_command_line = true});
    wait_until_loaded();
    write_note("Mine");
    notes().save = true;
    frame();
    EXPECT_EQ(notes().lesson.model.empty(), std::string(file).ends_with(".nrrd")) << file;
  }
}

TEST_F(FlightTest, NotesAreWrittenSavedOpenedAndPlayedAsALesson) {
  const ScratchFolder scratch;
  viewer_with(toy_tooth(), {.folder = scratch.path()});
  type(U'c');
  fade();
  hold('w', 0.2);
  frames(60);
  const Flight inside = fly().flight;
  const double inside_deg = viewer().state().scene.camera.field_of_view_deg;
  type(U'n');
  NotesState& notes = mode<NotesMode>().notes();
  ASSERT_TRUE(notes.draft);
  for (const char32_t letter : std::u32string(U"wwww")) type(letter);  // into the title, not into the wall
  press_key(Key::enter);
  frames(2);
  ASSERT_EQ(notes.lesson.notes.size(), 1u);
  EXPECT_EQ(notes.lesson.notes[0].title, "wwww");
  EXPECT_LT(glm::length(fly().flight.eye - inside.eye), 1e-4) << "the letters flew";
  press_key(Key::escape);
  fade();
  ASSERT_FALSE(fly().on);
  type(U'2');
  frames(40);
  const Camera lingual = viewer().state().scene.camera;
  notes.write = true;
  frames(2);
  notes.draft->title = "From lingual";
  notes.lesson.notes.push_back(*notes.draft);
  notes.draft.reset();
  notes.save = true;
  frames(2);
  std::filesystem::path file;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) file = entry.path();
  ASSERT_TRUE(named_like_a_tour(file.string())) << file;

  viewer_with(toy_tooth(), {.folder = scratch.path()});
  viewer().state().settings.comfort.field_of_view_deg = inside_deg - 20;
  viewer().handle(FilesDropped{{file.string()}});
  frame();
  fade();
  EXPECT_EQ(viewer().state().scene.camera.field_of_view_deg, inside_deg) << "as it was seen by who wrote it";
  NotesState& opened = mode<NotesMode>().notes();
  ASSERT_EQ(opened.shown, std::optional<std::size_t>(0));
  ASSERT_TRUE(fly().on);
  EXPECT_LT(glm::length(fly().flight.eye - inside.eye), 1e-4);
  EXPECT_GT(glm::dot(fly().flight.view_direction, inside.view_direction), 1 - 1e-9);
  press_key(Key::page_down);
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_EQ(opened.shown, std::optional<std::size_t>(1));
  EXPECT_LT(glm::length(viewer().state().scene.camera.position - lingual.position), 1e-9);
  press_key(Key::page_up);
  fade();
  EXPECT_TRUE(fly().on);
  press_key(Key::escape);
  EXPECT_FALSE(opened.shown);
  EXPECT_TRUE(fly().on) << "the first Esc only closes the lesson";
}

TEST_F(FlightTest, ABrokenTourIsToldAndNothingElseChanges) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "broken.tour.json";
  std::ofstream(file) << "{\"format\":\"odontoscope.tour\"";
  viewer_with_tooth();
  const auto shown = viewer().state().shown;
  viewer().handle(FilesDropped{{file.string()}});
  frames(3);
  EXPECT_NE(viewer().state().trouble.find("broken.tour.json"), std::string::npos);
  EXPECT_EQ(viewer().state().shown, shown);
  EXPECT_FALSE(viewer().loading());
}

TEST_F(FlightTest, ANoteFromAnotherToothIsToldOf) {
  viewer_with_tooth();
  NotesState& notes = mode<NotesMode>().notes();
  LessonNote elsewhere{"Elsewhere", "", {}, true};
  elsewhere.camera.position = {500, 0, 0};
  notes.lesson.notes.push_back(elsewhere);
  notes.go_to = 0;
  frames(2);
  EXPECT_FALSE(fly().on);
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("another tooth"), std::string::npos);
}

}  // namespace
}  // namespace odontoscope::testing_support
