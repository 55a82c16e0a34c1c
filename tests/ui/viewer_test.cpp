// Looking: mouse and keys to camera, scene and pixels.
#include <chrono>
#include <glm/geometric.hpp>
#include <set>
#include <thread>

#include "engine/navigate/moves.h"
#include "engine/picture/image_difference.h"
#include "engine/picture/png.h"
#include "engine/scene/scene_json.h"
#include "engine/viewer/actions.h"
#include "engine/viewer/look/annotations.h"
#include "recon/core/read_file.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

class Looking : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (!IsSkipped()) viewer_with_tooth();
  }
  const Camera& camera() { return viewer().state().scene.camera; }
  const Area& area() { return viewer().panes().front().area; }
  double middle_x() { return area().left + area().width / 2; }
  double middle_y() { return area().top + area().height / 2; }
  /// Where a point of the model is on the screen.
  glm::dvec2 pixel(const glm::dvec3& point) { return pixel_of(area(), place_of(camera(), point).value()); }
  /// Until nothing is awaited any more.
  void rest() {
    for (int i = 0; i < 3000 && viewer().wait_timeout() < 0.2; ++i) {
      frame(0.02);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
};

TEST_F(Looking, ShowsTheModelThatRenderShows) {
  // The part of the window beside the panel, away from marks, is what picture_of draws.
  keep_picture("start");
  viewer().state().settings.names = false;
  frames(2);
  const Image window = picture();
  EXPECT_TRUE(content_of(window).shows_something());
  PictureOptions options{{static_cast<int>(area().width), static_cast<int>(area().height)}, {1}};
  Renderer renderer(gl(), ShaderLibrary{});
  const GpuModel gpu_model = upload(gl(), viewer().state().shown->model);
  const Image alone =
      picture_of(gl(), renderer, gpu_model, viewer().state().shown->model, viewer().state().scene, options);
  std::size_t different = 0;
  for (int y = 150; y < 560; ++y)
    for (int x = 150; x < 500; ++x)
      different += window.pixel(static_cast<int>(area().left) + x, y) != alone.pixel(x, y) ? 1 : 0;
  EXPECT_EQ(different, 0u);
}

TEST_F(Looking, DraggingTurnsTheModelWithTheHand) {
  const Camera before = camera();
  const Image still = picture();
  drag(middle_x(), middle_y(), middle_x() + 120, middle_y());
  EXPECT_NEAR(glm::distance(camera().position, camera().target), glm::distance(before.position, before.target), 1e-9);
  EXPECT_GT(glm::distance(camera().position, before.position), 5);
  EXPECT_EQ(camera().target, before.target);
  EXPECT_GT(compare(picture(), still).share, 0.01);
}

TEST_F(Looking, RightAndShiftDragMoveWhatIsUnderThePointer) {
  for (const bool shift : {false, true}) {
    const auto hit = pick(*viewer().state().shown->pickable, viewer().state().scene,
                          {sight_line(camera(), {0, 0}).origin, sight_line(camera(), {0, 0}).direction});
    ASSERT_TRUE(hit);
    const glm::dvec2 from = pixel(hit->point_mm);
    drag(from.x, from.y, from.x + 60, from.y - 40, shift ? MouseButton::left : MouseButton::right, {.shift = shift});
    EXPECT_LT(glm::distance(pixel(hit->point_mm), from + glm::dvec2(60, -40)), 0.5);
    type(U'0');
    frames(5, 0.1);
  }
}

TEST_F(Looking, TheWheelGoesToThePointer) {
  const glm::dvec2 place(middle_x() + 40, middle_y() - 60);
  move(place.x, place.y);
  const auto hit = viewer().pointing().hit;
  ASSERT_TRUE(hit);
  const double before = glm::distance(camera().position, hit->point_mm);
  scroll(place.x, place.y, 3);
  EXPECT_LT(glm::distance(camera().position, hit->point_mm), 0.7 * before);
  EXPECT_LT(glm::distance(pixel(hit->point_mm), place), 0.5);
}

TEST_F(Looking, ADoubleClickMakesThePivot) {
  move(middle_x() + 40, middle_y() - 60);
  const glm::dvec3 point = viewer().pointing().hit.value().point_mm;
  click(middle_x() + 40, middle_y() - 60);
  EXPECT_GT(glm::distance(camera().target, point), 0.5);
  click(middle_x() + 40, middle_y() - 60);
  frames(5, 0.1);
  EXPECT_LT(glm::distance(camera().target, point), 1e-6);
  EXPECT_LT(glm::distance(pixel(point), glm::dvec2(middle_x(), middle_y())), 0.5);
}

TEST_F(Looking, TwoSlowClicksAreNoDoubleClick) {
  const Camera before = camera();
  click(middle_x(), middle_y());
  frames(10, 0.1);
  click(middle_x(), middle_y());
  frames(5, 0.1);
  EXPECT_EQ(camera(), before);
}

TEST_F(Looking, EachStandardViewIsWhereItSays) {
  const AnatomicalFrame tooth;
  const std::pair<char32_t, glm::dvec3> views[] = {{U'1', tooth.buccal},   {U'2', -tooth.buccal},
                                                   {U'3', tooth.mesial},   {U'4', -tooth.mesial},
                                                   {U'5', tooth.occlusal}, {U'6', -tooth.occlusal}};
  for (const auto& [key, side] : views) {
    type(key);
    EXPECT_EQ(viewer().wait_timeout(), 0);  // on its way
    frames(5, 0.1);
    EXPECT_NEAR(glm::dot(axes_of(camera()).towards_eye, side), 1, 1e-9);
    EXPECT_GT(content_of(picture()).colours, 100u);
  }
}

TEST_F(Looking, TheCompassLeadsToItsNames) {
  // Every name that is hit first at its own place leads there.
  const ViewPane pane = viewer().panes().front();
  int reached = 0;
  for (double y = area().top; y < area().top + 150; y += 6)
    for (double x = area().left + area().width - 150; x < area().left + area().width; x += 6) {
      if (compass_hit(pane, 1, x, y) != Action::view_mesial) continue;
      click(x, y);
      frames(5, 0.1);
      EXPECT_NEAR(axes_of(camera()).towards_eye.x, 1, 1e-9);
      ++reached;
      y = x = 1e9;
    }
  EXPECT_EQ(reached, 1);
}

TEST_F(Looking, PerspectiveAndParallelKeepTheSize) {
  const double before = half_height_at(camera(), depth_of(camera(), camera().target));
  type(U'p');
  EXPECT_EQ(camera().projection, Camera::Projection::parallel);
  EXPECT_NEAR(half_height_at(camera(), 1), before, 1e-9);
  EXPECT_EQ(viewer().state().settings.projection, Camera::Projection::parallel);
}

TEST_F(Looking, BackFacesGoRound) {
  for (const BackFaces wanted : {BackFaces::show, BackFaces::tint, BackFaces::cull}) {
    type(U'b');
    EXPECT_EQ(viewer().state().scene.back_faces, wanted);
  }
}

TEST_F(Looking, ASectionOpensTheHalfTowardsTheEye) {
  const Image whole = picture();
  type(U's');
  ASSERT_TRUE(viewer().state().scene.section);
  EXPECT_GT(glm::dot(viewer().state().scene.section->normal, axes_of(camera()).towards_eye), 0.5);
  EXPECT_GT(compare(picture(), whole).share, 0.05);
  keep_picture("section");
  type(U's');
  EXPECT_FALSE(viewer().state().scene.section);
}

TEST_F(Looking, TheSectionsHandleMovesAndTurnsIt) {
  type(U's');
  const Section before = *viewer().state().scene.section;
  const auto handle = section_handle(before, camera(), handle_reach(area(), 1)).value();
  const glm::dvec2 knob = pixel_of(area(), handle.knob), tip = pixel_of(area(), handle.tip);
  const Camera still = camera();
  drag(knob.x, knob.y, knob.x + (tip - knob).x * 0.4, knob.y + (tip - knob).y * 0.4);
  const Section moved = *viewer().state().scene.section;
  EXPECT_GT(offset_of(moved, viewer().state().shown->model), 0.3);
  EXPECT_NEAR(glm::dot(glm::normalize(moved.normal), glm::normalize(before.normal)), 1, 1e-9);
  const auto now = section_handle(moved, camera(), handle_reach(area(), 1)).value();
  const glm::dvec2 grip = pixel_of(area(), now.tip);
  drag(grip.x, grip.y, grip.x + 25, grip.y - 20);
  EXPECT_LT(glm::dot(glm::normalize(viewer().state().scene.section->normal), glm::normalize(moved.normal)), 0.99);
  EXPECT_EQ(camera(), still);  // the handle, not the tooth
  keep_picture("section-turned");
}

TEST_F(Looking, DistancesAreThoseBetweenThePoints) {
  type(U'5');
  frames(5, 0.1);
  type(U'm');
  EXPECT_EQ(mode<MeasureMode>().tool(), Tool::distance);
  click(middle_x() - 100, middle_y());
  click(middle_x() + 120, middle_y() + 30);
  const Measured& measured = mode<MeasureMode>().measured();
  ASSERT_EQ(measured.ends.size(), 2u);
  EXPECT_LT(glm::distance(pixel(measured.ends[0].point_mm), glm::dvec2(middle_x() - 100, middle_y())), 0.5);
  EXPECT_GT(distance_between_mm(measured.ends[0], measured.ends[1]), 1);
  keep_picture("distance");
  press_key(Key::escape);
  EXPECT_EQ(mode<MeasureMode>().tool(), Tool::look);
}

TEST_F(Looking, WallsAreMeasuredWhereOneClicks) {
  type(U't');
  click(middle_x() - 20, middle_y() - 60);
  ASSERT_TRUE(mode<MeasureMode>().measured().wall);
  EXPECT_GT(mode<MeasureMode>().measured().wall->along_normal_mm, 0.1);
  EXPECT_LT(mode<MeasureMode>().measured().wall->along_normal_mm, 15);
  keep_picture("wall");
}

TEST_F(Looking, DraggingWithAToolStillTurns) {
  type(U'm');
  const Camera before = camera();
  drag(middle_x(), middle_y(), middle_x() + 80, middle_y() + 10);
  EXPECT_NE(camera(), before);
  EXPECT_TRUE(mode<MeasureMode>().measured().ends.empty());
}

TEST_F(Looking, PicturesAndScenesAreSavedAndDrawnAgain) {
  const ScratchFolder scratch;
  viewer_with_tooth({.settings = {.picture = {300, 200, false, 2, true}}, .folder = scratch.path()});
  type(U's');
  press_key(Key::s, {.control = true});
  viewer().state().pending_actions = {Action::take_picture,
                                      Action::take_picture};  // the second while the first is being written
  frame();
  rest();
  EXPECT_EQ(viewer().state().trouble, "");
  const Image saved = read_png((scratch.path() / "Toy-tooth-001.png").string());
  EXPECT_EQ(saved, read_png((scratch.path() / "Toy-tooth-002.png").string()));
  EXPECT_EQ(saved.width, 300);
  EXPECT_EQ(saved.height, 200);
  EXPECT_EQ(saved.pixel(0, 0)[3], 0);  // transparent
  const Scene scene = read_scene((scratch.path() / "Toy-tooth-scene-001.json").string(), Scene{});
  EXPECT_EQ(scene, viewer().scene_of_picture());
  ASSERT_TRUE(scene.picture);
  EXPECT_EQ(*scene.picture, (PictureFormat{300, 200, 4}));
  EXPECT_EQ(scene.background.kind, Background::Kind::transparent);
  Renderer renderer(gl(), ShaderLibrary{});
  const Model& model = viewer().state().shown->model;
  EXPECT_EQ(picture_of(gl(), renderer, upload(gl(), model), model, scene, {{300, 200}, {2}}), saved);
}

TEST_F(Looking, APictureHoldsTheWindowUpForNoTime) {
  const ScratchFolder scratch;
  viewer_with_tooth({.settings = {.picture = {1500, 1000, false, 3, false}}, .folder = scratch.path()});
  const auto seconds_of = [](const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double drawn_here = seconds_of([&] { viewer().picture(); });
  frame();
  press_key(Key::f12);
  const double held_up = seconds_of([&] { frame(); });
  RecordProperty("drawn_here_ms", static_cast<int>(1000 * drawn_here));
  RecordProperty("held_up_ms", static_cast<int>(1000 * held_up));
  EXPECT_LT(held_up, 0.3 * drawn_here);
  EXPECT_LT(viewer().wait_timeout(), 0.1);        // its words are awaited
  viewer().state().scene.camera.position.z += 1;  // what is changed meanwhile is not in it
  rest();
  EXPECT_EQ(read_png((scratch.path() / "Toy-tooth-001.png").string()).width, 1500);
  EXPECT_EQ(viewer().state().trouble, "");
}

TEST_F(Looking, AFolderThatCannotBeWrittenIsSaid) {
  viewer_with_tooth({.folder = "/proc/no-such-folder"});
  press_key(Key::f12);
  frames(10);
  EXPECT_NE(viewer().state().trouble, "");
}

TEST_F(Looking, APictureThatIsTooLargeIsSaid) {
  viewer().state().settings.picture = {16384, 16384, false, 4, false};
  press_key(Key::f12);
  EXPECT_NE(viewer().state().trouble.find("picture-too-large"), std::string::npos) << viewer().state().trouble;
}

TEST_F(Looking, ThePanelGivesItsRoomAway) {
  const double with = area().width;
  press_key(Key::f9);
  frame();
  EXPECT_EQ(area().width, size.width);
  EXPECT_LT(with, size.width - 250);
  keep_picture("no-panel");
}

TEST_F(Looking, RestsWhenNothingMoves) {
  frames(10);
  EXPECT_GE(viewer().wait_timeout(), 0.2);
  const Image before = picture();
  frames(3);
  EXPECT_EQ(picture(), before);
}

TEST_F(Looking, DenseScreensGetLargeLetters) {
  size_ = {1920, 1280};
  scale_ = 2;
  frames(4);
  EXPECT_NEAR(area().left, 2 * 308, 2);
  keep_picture("dense");
}

TEST_F(Looking, SmallWindowsStillShowSomething) {
  size_ = {640, 420};
  frames(4);
  EXPECT_TRUE(content_of(picture()).shows_something());
  keep_picture("small-window");
  size_ = {3, 2};
  frames(4);
}

TEST_F(Looking, NoSequenceOfEventsBreaksIt) {
  std::uint32_t state = 12345;
  const auto random = [&state](std::uint32_t below) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % below;
  };
  size_ = {640, 420};
  constexpr const char32_t characters[] = U"123456 fpbwsrmt+-?";
  for (int i = 0; i < 600; ++i) {
    switch (random(7)) {
      case 0:
        viewer().handle(MouseMoved{static_cast<double>(random(700)), static_cast<double>(random(460))});
        break;
      case 1:
        viewer().handle(
            MouseButtonChanged{static_cast<MouseButton>(random(3)), random(2) == 0, {.shift = random(4) == 0}});
        break;
      case 2:
        viewer().handle(Scrolled{0, static_cast<double>(random(9)) - 4, {}});
        break;
      case 3:
        viewer().handle(TextTyped{characters[random(18)]});
        break;
      case 4:
        viewer().handle(KeyChanged{static_cast<Key>(1 + random(14)), random(2) == 0, {}});
        break;
      case 5:
        viewer().handle(FocusLost{});
        break;
      default:
        frame(0.05);
        break;
    }
    ASSERT_NO_THROW(validate(camera(), "after event"));
  }
  frame();
}

TEST(Actions, EveryKeyIsOneActionAndHasWords) {
  std::set<char32_t> characters;
  for (const ActionKey& key : usual_keys().keys) {
    EXPECT_FALSE(key.words.empty());
    if (key.character != 0) {
      EXPECT_TRUE(characters.insert(key.character).second) << key.printed;
    } else {
      EXPECT_NE(key.key, Key::other) << key.printed;
    }
  }
  EXPECT_EQ(action_for(TextTyped{U'W'}), Action::toggle_wire);
  EXPECT_FALSE(action_for(KeyChanged{Key::s, true, {}}));  // only with Ctrl
  EXPECT_EQ(action_for(KeyChanged{Key::z, true, {.control = true}}), Action::undo);
  EXPECT_EQ(action_for(KeyChanged{Key::z, true, {.shift = true, .control = true}}), Action::redo);
  EXPECT_EQ(action_for(KeyChanged{Key::s, true, {.shift = true, .control = true}}), Action::save_scene);
}

TEST(ScaleBars, AreRoundNumbersThatFit) {
  for (double height = 0.001; height < 1e5; height *= 1.37) {
    Camera camera;
    camera.projection = Camera::Projection::parallel;
    camera.height_mm = height;
    const ScaleBar bar = scale_bar({{0, 0, 1000, 800}, camera}, 160);
    EXPECT_LE(bar.pixels, 160.0001) << bar.words;
    EXPECT_GT(bar.pixels, 60) << bar.words;
    EXPECT_NEAR(std::stod(bar.words) * (bar.words.ends_with(" mm")  ? 1
                                        : bar.words.ends_with(" m") ? 1000
                                                                    : 0.001),
                bar.pixels * height / 800, 1e-6 * height)
        << bar.words;
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
