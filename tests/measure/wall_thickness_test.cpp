#include "engine/measure/wall_thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

/// Looking at `model` from `from` towards `to`, what is met first.
std::optional<Hit> met(const Pickable& pickable, const Model& model, const glm::dvec3& from, const glm::dvec3& to) {
  return pick(pickable, usual_scene(model, 1), {from, glm::normalize(to - from)});
}

TEST(WallThickness, OfAPlateIsItsThickness) {
  const Model model = make_model({{"plate", box({-10, -1, -10}, {10, 0.5, 10})}});
  const Pickable pickable(model);
  const auto hit = met(pickable, model, {1, 20, 2}, {1, 0, 2});
  ASSERT_TRUE(hit);
  const auto wall = wall_thickness(pickable, *hit);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->along_normal_mm, 1.5, 1e-5);
  EXPECT_NEAR(wall->largest_ball_mm, 1.5, 1.5e-3);
  EXPECT_NEAR(glm::distance(wall->opposite_mm, {1, -1, 2}), 0, 1e-5);
  EXPECT_NEAR(glm::distance(wall->ball_centre_mm, {1, -0.25, 2}), 0, 2e-3);
}

TEST(WallThickness, OfABallIsItsDiameter) {
  const Model model = make_model({{"ball", ball({{3, -2, 7}, 5, 60})}});
  const Pickable pickable(model);
  for (const glm::dvec3 from : {glm::dvec3(3.2, 30, 7.1), glm::dvec3(40, 20, -10), glm::dvec3(-20, -30, 30)}) {
    const auto hit = met(pickable, model, from, {3, -2, 7});
    ASSERT_TRUE(hit);
    const auto wall = wall_thickness(pickable, *hit);
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->along_normal_mm, 10, 0.02);
    EXPECT_NEAR(wall->largest_ball_mm, 10, 0.03);
    EXPECT_LE(wall->largest_ball_mm, wall->along_normal_mm);
  }
}

TEST(WallThickness, OfAHollowBallIsThatOfItsShellFromBothSides) {
  const Model model = make_model(
      {{"shell", ball({{}, 5, 60}), "shell"}, {"shell cavity", reversed(ball({{}, 3.5, 60})), "shell", true}});
  const Pickable pickable(model);
  const auto outside = met(pickable, model, {20, 30, 10}, {0, 0, 0});
  ASSERT_TRUE(outside);
  EXPECT_NEAR(wall_thickness(pickable, *outside)->along_normal_mm, 1.5, 0.02);
  EXPECT_NEAR(wall_thickness(pickable, *outside)->largest_ball_mm, 1.5, 0.02);
  Scene scene = usual_scene(model, 1);
  for (Look& look : scene.looks) look.as_body = false;
  const auto inside = pick(pickable, scene, {{0.1, 0.2, 0}, glm::normalize(glm::dvec3(1, 2, 1))});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->structure, "shell cavity");
  EXPECT_NEAR(wall_thickness(pickable, *inside)->along_normal_mm, 1.5, 0.02);
}

TEST(WallThickness, AnotherSolidInsideIsNoWall) {
  const Model model = make_model({{"outer", ball({{}, 5, 60})}, {"inner", ball({{}, 2, 60})}});
  const Pickable pickable(model);
  const auto hit = met(pickable, model, {20, 30, 10}, {0, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->structure, "outer");
  EXPECT_NEAR(wall_thickness(pickable, *hit)->along_normal_mm, 10, 0.02);
}

TEST(WallThickness, InAWedgeTheBallIsSmallerThanTheStraightLine) {
  // A triangular prism along x: right angle at the origin, legs of 4 along y and 3 along z. Incircle of radius 1.
  SurfaceMesh prism;
  for (const double x : {-50.0, 50.0})
    for (const auto& [y, z] : {std::pair{0.0, 0.0}, std::pair{4.0, 0.0}, std::pair{0.0, 3.0}})
      prism.points.push_back({x, y, z});
  prism.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  const Model model = make_model({{"prism", prism}});
  const Pickable pickable(model);
  const auto hit = met(pickable, model, {0.3, 1, -20}, {0.3, 1, 0});
  ASSERT_TRUE(hit);
  const auto wall = wall_thickness(pickable, *hit);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->along_normal_mm, 3 * 0.75, 1e-4) << "the height of the slope above y = 1";
  EXPECT_NEAR(wall->largest_ball_mm, 2, 3e-3) << "the incircle stands there";
  const auto aside = wall_thickness(pickable, *met(pickable, model, {0.3, 2.4, -20}, {0.3, 2.4, 0}));
  EXPECT_NEAR(aside->along_normal_mm, 1.2, 1e-4);
  // On the line y = 2.4 the slope 3 y + 4 z = 12 is (4.8 - 4 z) / 5 away: as far as the floor where z = 4.8 / 9.
  EXPECT_NEAR(aside->largest_ball_mm, 2 * 4.8 / 9, 2e-3);
}

TEST(WallThickness, IsNothingOnACapOrAnOpenSheet) {
  SurfaceMesh sheet;
  sheet.points = {{-5, 0, -5}, {5, 0, -5}, {0, 0, 5}};
  sheet.triangles = {{0, 2, 1}};
  const Model model = make_model({{"sheet", sheet}});
  const Pickable pickable(model);
  const auto hit = met(pickable, model, {0, 20, 0}, {0, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_FALSE(wall_thickness(pickable, *hit));
  Hit cap = *hit;
  cap.triangle.reset();
  EXPECT_FALSE(wall_thickness(pickable, cap));
}

TEST(WallThickness, OfTheMolarIsBelowItsSizeEverywhere) {
  const Model& model = small_molar();
  const Pickable pickable(model);
  std::size_t measured = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.1 * i, height = 0.05 * i;
    const glm::dvec3 target =
        model.bounds_mm.low + glm::dvec3(0.5, 0.5, 0.1 + 0.08 * height) * (model.bounds_mm.high - model.bounds_mm.low);
    const auto hit = met(pickable, model, target + 50.0 * glm::dvec3(std::cos(angle), std::sin(angle), 0.1), target);
    if (!hit) continue;
    const auto wall = wall_thickness(pickable, *hit);
    ASSERT_TRUE(wall) << i;
    EXPECT_GT(wall->largest_ball_mm, 0);
    EXPECT_LE(wall->largest_ball_mm, wall->along_normal_mm * (1 + 1e-6));
    EXPECT_LT(wall->along_normal_mm, 2 * model.radius_mm);
    ++measured;
  }
  EXPECT_GT(measured, 100u);
}

}  // namespace
}  // namespace odontoscope::testing_support
