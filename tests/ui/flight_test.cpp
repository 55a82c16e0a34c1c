// Flying in the viewer: one key in, one key out, and never a look behind the scenes.

#include <glm/geometric.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "engine/navigate/screen.h"
#include "engine/render/face_count.h"
#include "engine/ui/fly_marks.h"
#include "engine/ui/marks.h"
#include "tests/ui/driver.h"
#include "tests/ui/teeth.h"

namespace odontoscope::testing_support {
namespace {

class FlightTest : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    size_ = {480, 320};   // frames are many
  }
  Viewer& viewer_with(LoadedModel model, ViewerOptions options = {}) {
    options.load = [model](const LoadRequest&, const Progress&) { return model; };
    return viewer_with_tooth(std::move(options));
  }
  FlyState& fly() { return viewer().state().fly; }
  const FlightSpaces& spaces() { return *viewer().state().shown->flight; }
  /// Until the fade is over.
  void fade() {
    for (int i = 0; i < 6; ++i) frame(0.2);
  }
  void hold(char place, double seconds, double hertz = 60) {
    viewer().handle(KeyChanged{Key::other, true, {}, place});
    frames(static_cast<int>(seconds * hertz), 1 / hertz);
    viewer().handle(KeyChanged{Key::other, false, {}, place});
    frame(1 / hertz);
  }
  /// Every pixel covered, every nearest face a front.
  void expect_closed_in() {
    const ViewerState& state = viewer().state();
    constexpr PixelSize pixels{240, 180};
    const GpuModel model = upload(gl(), state.shown->model);
    const FaceCounter counter(gl(), ShaderLibrary{});
    // With all of the solid each line of sight meets as many fronts as backs, which tells ties at folds from wrong sides.
    Scene scene = state.scene;
    std::string solid;
    for (const ModelPart& part : state.shown->model.parts)
      if (part.structure == spaces().cavities.at(fly().cavity.value()).structure) solid = part.solid;
    for (const ModelPart& part : state.shown->model.parts) scene.look_of(part.structure)->visible = part.solid == solid;
    const FaceVerdict verdict = judge(counter.count(model, scene, view_of(state.scene.camera, state.shown->model, 4.0 / 3), pixels));
    EXPECT_EQ(verdict.covered, static_cast<std::size_t>(pixels.width) * pixels.height) << "background seen";
    // A body that fills the void is shown inside out: its backs are the wall's fronts.
    const bool body = spaces().cavities.at(fly().cavity.value()).body;
    EXPECT_EQ(verdict.back_nearest - verdict.ties, body ? verdict.covered : 0u) << "the wrong side of a wall is seen";
  }
};

constexpr char32_t outside_views[] = {U'0', U'1', U'2', U'3', U'4', U'5', U'6'};

TEST_F(FlightTest, OneKeyEntersThePulpFromTenViewsAndOneLeaves) {
  std::vector<LoadedModel> teeth{sample_tooth_loaded()};
  if (ct_molar_there()) teeth.push_back(ct_molar_loaded());
  for (const LoadedModel& tooth : teeth) {
    viewer_with(tooth, {.settings = {.comfort = {.reduced_motion = true}}});
    for (Look& look : viewer().state().scene.looks) look.opacity = 1;   // quicker to draw
    for (int view = 0; view < 10; ++view) {
      SCOPED_TRACE(tooth.title + ", view " + std::to_string(view));
      type(outside_views[view % 7]);
      for (int i = 0; i < 3; ++i) frame(0.3);
      if (view == 7) type(U'p');
      if (view == 8) scroll(300, 160, 4);
      if (view == 9) drag(300, 160, 380, 220);
      const Scene outside = viewer().state().scene;
      type(U'c');
      fade();
      ASSERT_TRUE(fly().on);
      const FlightSpace& pulp = spaces().cavities.at(fly().cavity.value());
      EXPECT_EQ(pulp.walls.locate(fly().flight.eye), Walls::Side::inside);
      EXPECT_GE(pulp.walls.nearest(fly().flight.eye).distance, spaces().rules.clearance);
      const double ahead = pulp.walls.free_distance(fly().flight.eye, fly().flight.sight);
      EXPECT_GT(ahead, 2 * pulp.room_mm) << "it looks at a wall, not along the pulp";
      expect_closed_in();
      if (view == 0) keep_picture("flight-" + tooth.title);
      type(U'c');
      fade();
      EXPECT_FALSE(fly().on);
      EXPECT_EQ(viewer().state().scene, outside);
    }
  }
}

TEST_F(FlightTest, LettersFlyInsideAndKeepTheirMeaningOutside) {
  viewer_with_tooth();
  type(U'c');
  fade();
  ASSERT_TRUE(fly().on);
  const Flight start = fly().flight;
  for (const char32_t letter : {U'w', U's', U'd', U'e', U'b', U'f', U'g', U'0', U'p'}) type(letter);
  EXPECT_FALSE(viewer().state().lab.on);
  EXPECT_FALSE(viewer().state().scene.wire);
  EXPECT_FALSE(viewer().state().scene.section);
  EXPECT_EQ(fly().flight, start) << "typed, not held";
  hold('w', 0.3);
  EXPECT_GT(glm::dot(fly().flight.eye - start.eye, start.sight), 0.05);
  const Flight ahead = fly().flight;
  hold('j', 0.3);   // the left-handed keys
  EXPECT_LT(glm::dot(fly().flight.eye - ahead.eye, glm::cross(ahead.sight, ahead.up)), -0.05);
  press_key(Key::escape);
  fade();
  EXPECT_FALSE(fly().on);
  type(U'w');
  EXPECT_TRUE(viewer().state().scene.wire);
}

TEST_F(FlightTest, HoldingAgainstAWallStopsAtTheStatedDistanceAndTheWallStaysWhole) {
  viewer_with_tooth();
  type(U'c');
  fade();
  const FlightSpace& pulp = spaces().cavities.at(0);
  double nearest = 1e9;
  for (const char key : {'w', 'a', 'e', 's'}) {
    hold(key, 6, 10);
    EXPECT_EQ(pulp.walls.locate(fly().flight.eye), Walls::Side::inside);
    const double distance = pulp.walls.nearest(fly().flight.eye).distance;
    EXPECT_GE(distance, spaces().rules.clearance);
    nearest = std::min(nearest, distance);
    expect_closed_in();   // the near plane cuts nothing
  }
  EXPECT_LT(nearest, 1.1 * spaces().rules.clearance) << "it never came to a wall";
}

TEST_F(FlightTest, ItComesToRestAndThenDrawsNoMore) {
  viewer_with_tooth();
  type(U'c');
  fade();
  hold('w', 0.2);
  EXPECT_EQ(viewer().patience(), 0);
  frames(120);
  EXPECT_GT(viewer().patience(), 0.1);
}

TEST_F(FlightTest, ArrowsADragTheCaughtMouseAndAStickLookAround) {
  viewer_with_tooth();
  type(U'c');
  fade();
  const auto turned_by = [&](auto turn) {
    const Flight before = fly().flight;
    turn();
    frames(20);
    const glm::dvec3 right = glm::cross(before.sight, before.up);
    return glm::dvec2(glm::dot(fly().flight.sight, right), glm::dot(fly().flight.sight, before.up));
  };
  EXPECT_GT(turned_by([&] {
              viewer().handle(KeyChanged{Key::right, true});
              frames(20);
              viewer().handle(KeyChanged{Key::right, false});
            }).x, 0.2);
  EXPECT_GT(turned_by([&] { drag(360, 200, 360, 150); }).y, 0.2);
  EXPECT_GT(turned_by([&] {
              viewer().handle(GamepadChanged{.present = true, .turn_right = 1});
              frames(20);
              viewer().handle(GamepadChanged{.present = true});
            }).x, 0.2);
  type(U'm');
  frame();
  EXPECT_EQ(viewer().pointer(), Pointer::caught);
  EXPECT_GT(turned_by([&] { move(380, 150), move(430, 150); }).x, 0.2);
  viewer().handle(FocusLost{});
  frame();
  EXPECT_NE(viewer().pointer(), Pointer::caught);
}

TEST_F(FlightTest, TheWheelSetsTheSpeedAndAStickFlies) {
  viewer_with_tooth();
  type(U'c');
  fade();
  scroll(360, 150, 3);
  EXPECT_GT(fly().haste, 1.4);
  const Flight before = fly().flight;
  viewer().handle(GamepadChanged{.present = true, .move_ahead = 1});
  frames(20);
  EXPECT_GT(glm::dot(fly().flight.eye - before.eye, before.sight), 0.05);
  EXPECT_LT(viewer().patience(), 0.1) << "a stick wakes nobody: it must be asked";
}

TEST_F(FlightTest, AKeyGoesThroughTheWallInTheDark) {
  viewer_with_tooth();
  type(U'c');
  fade();
  bool dark = false;
  viewer().handle(TextTyped{U'x'});
  for (int i = 0; i < 60; ++i) {
    frame();
    dark = dark || fly().dark > 0.95;
    EXPECT_TRUE(fly().cavity.has_value() || dark) << "out before it was dark";
    const bool inside = spaces().cavities[0].walls.locate(fly().flight.eye) == Walls::Side::inside;
    EXPECT_EQ(inside, fly().cavity.has_value());
    EXPECT_TRUE(inside || spaces().outdoors(fly().flight.eye));
  }
  EXPECT_TRUE(dark);
  EXPECT_EQ(fly().dark, 0);
  ASSERT_TRUE(fly().on);
  ASSERT_FALSE(fly().cavity);
  fly().flight = looking(fly().flight.eye, -fly().flight.sight);
  type(U'x');   // and back in
  fade();
  EXPECT_EQ(fly().cavity, std::optional<std::size_t>(0));
}

TEST_F(FlightTest, OutdoorsOneCannotFlyIntoTheTooth) {
  viewer_with_tooth();
  type(U'a');
  fade();
  ASSERT_TRUE(fly().on);
  ASSERT_FALSE(fly().cavity);
  EXPECT_TRUE(spaces().outdoors(fly().flight.eye));
  hold('w', 8, 10);
  EXPECT_TRUE(spaces().outdoors(fly().flight.eye));
  EXPECT_GE(spaces().outside.nearest(fly().flight.eye).distance, spaces().rules.clearance);
  EXPECT_LT(spaces().outside.nearest(fly().flight.eye).distance, 2 * spaces().rules.clearance) << "it never came to the tooth";
  press_key(Key::backspace);
  fade();
  EXPECT_FALSE(fly().on);
}

TEST_F(FlightTest, WithoutACavityItSaysSo) {
  LoadedModel solid = toy_tooth();
  auto none = std::make_shared<FlightSpaces>(*solid.flight);
  none->cavities.clear();
  solid.flight = none;
  viewer_with(solid);
  type(U'c');
  fade();
  EXPECT_FALSE(fly().on);
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("no cavity"), std::string::npos);
}

TEST_F(FlightTest, AnotherModelEndsTheFlight) {
  viewer_with_tooth();
  type(U'c');
  frame(0.1);   // in the middle of the fade
  viewer().open({});
  wait_until_loaded();
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_EQ(fly().dark, 0);
  type(U'c');
  fade();
  EXPECT_TRUE(fly().on);
  viewer().open({});
  wait_until_loaded();
  EXPECT_FALSE(fly().on);
  EXPECT_FALSE(viewer().state().scene.headlight);
}

TEST_F(FlightTest, ARideLeadsAlongACanalAndStopsAtItsEnd) {
  viewer_with(sample_tooth_loaded());
  type(U'c');
  fade();
  type(U'1');
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_TRUE(fly().ride->playing);
  const FlightSpace& pulp = spaces().cavities.at(0);
  EXPECT_NE(where_in_words(viewer().state()).find("pulp chamber"), std::string::npos);
  press_key(Key::space);
  EXPECT_FALSE(fly().ride->playing);
  frames(90);
  const double stopped = fly().ride->along;
  frames(5);
  EXPECT_EQ(fly().ride->along, stopped);
  EXPECT_GT(viewer().patience(), 0.1) << "nothing moves, so nothing is drawn";
  press_key(Key::end);
  EXPECT_EQ(fly().ride->along, fly().ride->track.points.back().along);
  EXPECT_GE(pulp.walls.nearest(fly().flight.eye).distance, spaces().rules.clearance);
  ASSERT_TRUE(fly().place);
  EXPECT_GT(fly().place->depth, 0);
  EXPECT_NE(measured_in_words(viewer().state()).find("to the apex"), std::string::npos);
  type(U'r');
  frames(40);
  EXPECT_LT(fly().ride->along, fly().ride->track.points.back().along);
  hold('w', 0.1);   // flying ends the ride where it is
  EXPECT_FALSE(fly().ride);
  EXPECT_EQ(pulp.walls.locate(fly().flight.eye), Walls::Side::inside);
  type(U'9');
  EXPECT_FALSE(fly().ride) << "there are not so many";
}

TEST_F(FlightTest, ReducedMotionLeavesTheRideToThePerson) {
  viewer_with(sample_tooth_loaded(), {.settings = {.comfort = {.reduced_motion = true}}});
  type(U'c');
  fade();
  type(U't');
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_FALSE(fly().ride->playing);
  const double start = fly().ride->along;
  type(U'.');
  EXPECT_GT(fly().ride->along, start);
}

TEST_F(FlightTest, AClickOnACanalsNameBeginsTheRide) {
  viewer_with(sample_tooth_loaded());
  size_ = {960, 640};
  type(U'c');
  fade();
  const FlightSpace& pulp = spaces().cavities.at(0);
  const FlightLabel* orifice = nullptr;
  for (const FlightLabel& label : fly().labels)
    if (label.line == 1u && label.words.find("apex") == std::string::npos) orifice = &label;
  ASSERT_NE(orifice, nullptr);
  const Track track = track_of(*rideable(pulp.lines)[1], spaces().rules.clearance);
  fly().flight = flight_on(track, track.orifice - 2 * place_on(track, track.orifice).radius);
  frames(3);
  const auto seen = seen_labels(fly().labels, viewer().state().scene.camera, viewer().panes().front().area.aspect(), pulp.walls, 3 * spaces().rules.clearance);
  ASSERT_FALSE(seen.empty());
  for (const SeenLabel& label : seen) {
    if (&fly().labels[label.label] != orifice) continue;
    const glm::dvec2 pixel = pixel_of(viewer().panes().front().area, label.place);
    click(pixel.x + 20, pixel.y);
  }
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_EQ(fly().ride->line, 1u);
}

TEST_F(FlightTest, NotesAreWrittenSavedOpenedAndPlayedAsALesson) {
  const ScratchFolder scratch;
  viewer_with(toy_tooth(), {.folder = scratch.path()});
  type(U'c');
  fade();
  hold('w', 0.2);
  frames(60);
  const Flight inside = fly().flight;
  type(U'n');
  NotesState& notes = viewer().state().notes;
  ASSERT_TRUE(notes.draft);
  for (const char32_t letter : std::u32string(U"wwww")) type(letter);   // into the title, not into the wall
  press_key(Key::enter);
  frames(2);
  ASSERT_EQ(notes.tour.notes.size(), 1u);
  EXPECT_EQ(notes.tour.notes[0].title, "wwww");
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
  notes.tour.notes.push_back(*notes.draft);
  notes.draft.reset();
  notes.save = true;
  frames(2);
  std::filesystem::path file;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) file = entry.path();
  ASSERT_TRUE(named_like_a_tour(file.string())) << file;

  viewer_with(toy_tooth(), {.folder = scratch.path()});
  viewer().handle(FilesDropped{{file.string()}});
  frame();
  fade();
  NotesState& opened = viewer().state().notes;
  ASSERT_EQ(opened.shown, std::optional<std::size_t>(0));
  ASSERT_TRUE(fly().on);
  EXPECT_LT(glm::length(fly().flight.eye - inside.eye), 1e-4);
  EXPECT_GT(glm::dot(fly().flight.sight, inside.sight), 1 - 1e-9);
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
  NotesState& notes = viewer().state().notes;
  TourNote elsewhere{"Elsewhere", "", {}, true};
  elsewhere.camera.position = {500, 0, 0};
  notes.tour.notes.push_back(elsewhere);
  notes.go_to = 0;
  frames(2);
  EXPECT_FALSE(fly().on);
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("another tooth"), std::string::npos);
}

TEST_F(FlightTest, TheVignetteDarkensTheRimWhileItTurnsIfWanted) {
  const auto rim_while_turning = [&](bool vignette) {
    viewer_with_tooth({.settings = {.panel = false, .comfort = {.vignette = vignette}}});
    type(U'c');
    fade();
    viewer().handle(KeyChanged{Key::right, true});
    frames(30);
    viewer().handle(KeyChanged{Key::right, false});
    const Image image = picture();
    const auto light = [&](int x, int y) {
      const auto pixel = image.pixel(x, y);
      return pixel[0] + pixel[1] + pixel[2];
    };
    return std::pair(light(4, 316), light(240, 120));
  };
  const auto with = rim_while_turning(true), without = rim_while_turning(false);
  EXPECT_LT(with.first, 0.5 * without.first);
  EXPECT_NEAR(with.second, without.second, 0.05 * without.second);
}

/// What a frame costs besides the picture of the model: printed, since a time is no test.
TEST_F(FlightTest, DISABLED_FrameCost) {
  size_ = {1280, 800};
  viewer_with(ct_molar_there() ? ct_molar_loaded() : sample_tooth_loaded());
  const auto milliseconds = [&] {
    constexpr int count = 40;
    frames(5);
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < count; ++i) frame(1e-6);
    gl().Finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / count;
  };
  const double outside = milliseconds();
  type(U'c');
  fade();
  const double inside = milliseconds();
  fly().show_labels = fly().show_where = false;
  const double bare = milliseconds();
  std::printf("a frame that redraws nothing of the model: %.2f ms outside, %.2f ms in flight, %.2f ms of them names and small pictures\n", outside, inside, inside - bare);
}

/// To be looked at: run with --gtest_also_run_disabled_tests.
TEST_F(FlightTest, DISABLED_Gallery) {
  size_ = {1280, 800};
  for (const LoadedModel& tooth : {sample_tooth_loaded(), ct_molar_loaded()}) {
    viewer_with(tooth, {});
    type(U'c');
    fade();
    keep_picture("gallery-" + tooth.title + "-0enter");
    fly().flight = looking(fly().flight.eye, {0.1, 0.1, -1});
    frames(3, 0.05);
    keep_picture("gallery-" + tooth.title + "-1floor");
    type(U'?');
    keep_picture("gallery-" + tooth.title + "-help");
    press_key(Key::escape);
    type(U'n');
    keep_picture("gallery-" + tooth.title + "-note");
    press_key(Key::escape);
    const CentreLines& lines = spaces().cavities[0].lines;
    ASSERT_FALSE(lines.canals.empty());
    for (const double part : {0.1, 0.5, 0.8}) {
      const CentreLine& canal = lines.canals[0];
      const auto i = static_cast<std::size_t>(part * static_cast<double>(canal.points.size() - 1));
      if (!fly().ride) {
        type(U'1');
        fade();
        press_key(Key::space);
      }
      fly().ride->along = canal.points[i].along;
      frames(3, 0.05);
      keep_picture("gallery-" + tooth.title + "-canal-" + std::to_string(static_cast<int>(10 * part)));
    }
    type(U'c');
    fade();
    type(U'a');
    fade();
    keep_picture("gallery-" + tooth.title + "-outdoors");
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
