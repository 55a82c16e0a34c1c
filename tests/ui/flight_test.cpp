// Flying in the viewer: one key in, one key out, and never a look behind the scenes.

#include <glm/geometric.hpp>

#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

constexpr char32_t outside_views[] = {U'0', U'1', U'2', U'3', U'4', U'5', U'6'};

TEST_F(FlightTest, OneKeyEntersThePulpFromTenViewsAndOneLeaves) {
  std::vector<LoadedModel> teeth{sample_tooth_loaded()};
  if (ct_molar_there()) teeth.push_back(ct_molar_loaded());
  const std::size_t from_all_sides = teeth.size();
  teeth.push_back(sample_tooth_loaded(ToothKind::premolar));
  teeth.push_back(sample_tooth_loaded(ToothKind::incisor));
  for (const LoadedModel& tooth : teeth) {
    viewer_with(tooth, {.settings = {.comfort = {.reduced_motion = true}}});
    for (Look& look : viewer().state().scene.looks) look.opacity = 1;  // quicker to draw
    const int stride = &tooth < &teeth[from_all_sides] ? 1 : 3;
    for (int view = 0; view < 10; view += stride) {
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
      const double ahead = pulp.walls.free_distance(fly().flight.eye, fly().flight.view_direction);
      EXPECT_GT(ahead, 2 * pulp.clearance_mm) << "it looks at a wall, not along the pulp";
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
  EXPECT_FALSE(mode<CompareMode>().state().on);
  EXPECT_FALSE(viewer().state().scene.wire);
  EXPECT_FALSE(viewer().state().scene.section);
  EXPECT_EQ(fly().flight, start) << "typed, not held";
  hold('w', 0.3);
  EXPECT_GT(glm::dot(fly().flight.eye - start.eye, start.view_direction), 0.05);
  const Flight ahead = fly().flight;
  hold('j', 0.3);  // the left-handed keys
  EXPECT_LT(glm::dot(fly().flight.eye - ahead.eye, glm::cross(ahead.view_direction, ahead.up)), -0.05);
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
    expect_closed_in();  // the near plane cuts nothing
  }
  EXPECT_LT(nearest, 1.1 * spaces().rules.clearance) << "it never came to a wall";
}

TEST_F(FlightTest, ItComesToRestAndThenDrawsNoMore) {
  viewer_with_tooth();
  type(U'c');
  fade();
  hold('w', 0.2);
  EXPECT_EQ(viewer().wait_timeout(), 0);
  frames(120);
  EXPECT_GT(viewer().wait_timeout(), 0.1);
}

TEST_F(FlightTest, ArrowsADragTheCaughtMouseAndAStickLookAround) {
  viewer_with_tooth();
  type(U'c');
  fade();
  const auto turned_by = [&](auto turn) {
    const Flight before = fly().flight;
    turn();
    frames(20);
    const glm::dvec3 right = glm::cross(before.view_direction, before.up);
    return glm::dvec2(glm::dot(fly().flight.view_direction, right), glm::dot(fly().flight.view_direction, before.up));
  };
  EXPECT_GT(turned_by([&] {
              viewer().handle(KeyChanged{Key::right, true});
              frames(20);
              viewer().handle(KeyChanged{Key::right, false});
            }).x,
            0.2);
  EXPECT_GT(turned_by([&] { drag(360, 200, 360, 150); }).y, 0.2);
  EXPECT_GT(turned_by([&] {
              viewer().handle(GamepadChanged{.present = true, .turn_right = 1});
              frames(20);
              viewer().handle(GamepadChanged{.present = true});
            }).x,
            0.2);
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
  EXPECT_GT(fly().habits.speed_factor, 1.4);
  const Flight before = fly().flight;
  viewer().handle(GamepadChanged{.present = true, .move_ahead = 1});
  frames(20);
  EXPECT_GT(glm::dot(fly().flight.eye - before.eye, before.view_direction), 0.05);
  EXPECT_LT(viewer().wait_timeout(), 0.1) << "a stick wakes nobody: it must be asked";
}

TEST_F(FlightTest, AKeyGoesThroughTheWallInTheDark) {
  viewer_with_tooth();
  type(U'c');
  fade();
  bool dark = false;
  viewer().handle(TextTyped{U'x'});
  for (int i = 0; i < 60; ++i) {
    frame();
    dark = dark || viewer().fade().dark() > 0.95;
    EXPECT_TRUE(fly().cavity.has_value() || dark) << "out before it was dark";
    const bool inside = spaces().cavities[0].walls.locate(fly().flight.eye) == Walls::Side::inside;
    EXPECT_EQ(inside, fly().cavity.has_value());
    EXPECT_TRUE(inside || spaces().outdoors(fly().flight.eye));
  }
  EXPECT_TRUE(dark);
  EXPECT_EQ(viewer().fade().dark(), 0);
  ASSERT_TRUE(fly().on);
  ASSERT_FALSE(fly().cavity);
  EXPECT_TRUE(std::isfinite(spaces().outside.free_distance(fly().flight.eye, fly().flight.view_direction)))
      << "the tooth must be seen";
  type(U'x');  // and back in
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
  EXPECT_LT(spaces().outside.nearest(fly().flight.eye).distance, 2 * spaces().rules.clearance)
      << "it never came to the tooth";
  press_key(Key::backspace);
  fade();
  EXPECT_FALSE(fly().on);
}

TEST_F(FlightTest, AnotherModelEndsTheFlight) {
  viewer_with_tooth();
  type(U'c');
  frame(0.1);  // in the middle of the fade
  viewer().open({});
  wait_until_loaded();
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_EQ(viewer().fade().dark(), 0);
  type(U'c');
  fade();
  EXPECT_TRUE(fly().on);
  viewer().open({});
  wait_until_loaded();
  EXPECT_FALSE(fly().on);
  EXPECT_FALSE(viewer().state().scene.headlight);
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

}  // namespace
}  // namespace odontoscope::testing_support
