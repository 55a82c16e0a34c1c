// Leaping inside instead of gliding, and what the hands feel.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "engine/headset/visit_steps.h"
#include "tests/headset/visiting.h"

namespace odontoscope::testing_support {
namespace {

TEST(FreeWay, EndsWhereTheBallTouchesTheWallAndNoSooner) {
  const FlightSpace& ball = BallWorld::once().cavities[0];
  constexpr double clearance = 0.2;
  std::mt19937 random(11);
  std::normal_distribution<double> any;
  for (int i = 0; i < 50; ++i) {
    const double x = any(random), y = any(random), z = any(random);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(x, y, z));
    const double way = visit_steps::free_way(ball.walls, ball.middle, direction, 10, clearance);
    const double there = ball.walls.nearest(ball.middle + way * direction).distance;
    EXPECT_GE(there, clearance);
    EXPECT_LE(there, clearance * 1.002);
    EXPECT_NEAR(way, 1.8, 0.06);
    EXPECT_EQ(visit_steps::free_way(ball.walls, ball.middle, direction, 0.5, clearance), 0.5);
  }
  // All along the way, in a canal's bends.
  const FlightSpace& canals = MolarWorld::once().cavities[0];
  for (int i = 0; i < 50; ++i) {
    const double x = any(random), y = any(random), z = any(random);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(x, y, z));
    const double way = visit_steps::free_way(canals.walls, canals.middle, direction, 10, 0.1);
    for (int k = 0; k <= 40; ++k)
      ASSERT_GE(canals.walls.nearest(canals.middle + way * k / 40.0 * direction).distance, 0.1 * (1 - 1e-9));
  }
}

class Leap : public VisitingMolar {
 protected:
  void SetUp() override {
    step();
    visit.pending_actions = {VisitAction::enter};
    step(80);
    ASSERT_TRUE(visit.cavity);
    visit.panel.reset();
    visit.chosen.travel = Travel::leap;
  }
  void point(const glm::dvec3& direction) {
    const double trigger = input.hands[1].trigger;
    input.hands[1] =
        pointing_at(input.head.position + 3.0 * direction, input.head.position + glm::dvec3(0.1, -0.2, -0.1));
    input.hands[1].trigger = trigger;
    step();
  }
};

TEST_F(Leap, LettingTheTriggerGoLeadsThereInTheDark) {
  point({1, 0, 0});
  EXPECT_FALSE(visit.hands.leap_mm[1]);
  const glm::dvec3 eye = visit.eye_mm;
  input.hands[1].trigger = 1;
  step(40);
  ASSERT_TRUE(visit.hands.leap_mm[1]);
  EXPECT_LT(glm::length(visit.eye_mm - eye), 1e-9) << "it only shows where";
  EXPECT_FALSE(visit.way);
  const glm::dvec3 there = *visit.hands.leap_mm[1];
  EXPECT_FALSE(cavity.walls.crosses(eye, there));
  EXPECT_GE(cavity.walls.nearest(there).distance / mm_per_metre(visit.stage), rules.clearance);
  EXPECT_GT(glm::length(there - eye) / mm_per_metre(visit.stage), 0.3);
  const double magnification = visit.stage.magnification;
  input.hands[1].trigger = 0;
  double dark_at_jump = -1;
  glm::dvec3 before = visit.eye_mm;
  for (int i = 0; i < 90; ++i) {
    step();
    if (glm::length(visit.eye_mm - before) > 1e-3) dark_at_jump = visit.seen.dark;
    before = visit.eye_mm;
  }
  EXPECT_EQ(dark_at_jump, 1);
  EXPECT_LT(glm::length(visit.eye_mm - there), 1e-6);
  EXPECT_LT(glm::length(to_room(visit.stage, visit.eye_mm) - input.head.position), 1e-9);
  EXPECT_EQ(visit.stage.magnification, magnification);
  EXPECT_TRUE(visit.cavity);
  EXPECT_EQ(visit.seen.vignette < 0.01, true);
  // And out again to where the tooth stood, not to where the leap began.
  visit.pending_actions = {VisitAction::leave};
  step(80);
  EXPECT_NEAR(visit.stage.magnification, usual_magnification, 1e-9);
}

TEST_F(Leap, NeitherTriggerNorStickGlides) {
  const glm::dvec3 eye = visit.eye_mm;
  point({0, 0, -1});
  input.hands[1].trigger = 1;
  input.hands[0].stick = {0, 1};
  step(90);
  EXPECT_LT(glm::length(visit.eye_mm - eye), 1e-9);
  // The left stick turns, since it does not go sideways.
  const glm::dquat turn = visit.stage.turn;
  input.hands[0].stick = {1, 0};
  step();
  EXPECT_NE(visit.stage.turn, turn);
}

TEST_F(Leap, WhereThereIsNoWayItDoesNotGrowDark) {
  visit.chosen.travel = Travel::glide;
  point({1, 0, 0});
  input.hands[1].trigger = 1;
  step(500);
  input.hands[1].trigger = 0;
  step(50);
  visit.chosen.travel = Travel::leap;
  input.hands[1].trigger = 1;
  step(5);
  input.hands[1].trigger = 0;
  step(2);
  EXPECT_FALSE(visit.way);
}

TEST_F(Leap, NoLeapEverGetsThroughAWall) {
  std::mt19937 random(2);
  std::normal_distribution<double> any;
  for (int i = 0; i < 25; ++i) {
    const double x = any(random), y = any(random), z = any(random);
    point(glm::normalize(glm::dvec3(x, y, z)));
    input.hands[1].trigger = 1;
    step(2);
    input.hands[1].trigger = 0;
    step(1);
    for (int k = 0; k < 70; k += 10) step(10);
    ASSERT_EQ(cavity.walls.locate(visit.eye_mm), Walls::Side::inside);
    ASSERT_GE(wall_metres(), rules.clearance * (1 - 1e-6));
  }
}

TEST_F(Leap, HandsFeelWhatTheyDidAndTheWallOnce) {
  visit.chosen.travel = Travel::glide;
  point({1, 0, 0});
  EXPECT_EQ(visit.hands.pulse, (std::array<double, 2>{0, 0}));
  input.hands[1].trigger = 1;
  int knocks = 0;
  for (int i = 0; i < 500; ++i) {
    step();
    knocks += visit.hands.pulse[1] > 0 ? 1 : 0;
  }
  EXPECT_LT(wall_metres(), 1.06 * rules.clearance);
  EXPECT_EQ(knocks, 1) << "it knocks, it does not rattle";
  input.hands[1].trigger = 0;
  visit.chosen.tool = HandTool::distance;
  point({-1, 0, 0});  // back: before it the hand may reach through the wall
  step(20);
  input.hands[1].trigger = 1;
  step();
  EXPECT_GT(visit.hands.pulse[1], 0);
  EXPECT_EQ(visit.hands.pulse[0], 0);
  step();
  EXPECT_EQ(visit.hands.pulse[1], 0);
}

}  // namespace
}  // namespace odontoscope::testing_support
