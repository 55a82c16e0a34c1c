// A person in the headset, scripted: no runtime, no picture, the same values that both would give.
#include "engine/headset/visit.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/headset/visiting.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

class VisitTest : public VisitingBalls {
 protected:
  void SetUp() override { step(); }
  double wall_metres() const {
    return balls.cavities[0].walls.nearest(visit.eye_mm).distance / mm_per_metre(visit.stage);
  }
  /// As a person does it: point at the pulp, pull the trigger, let go.
  void enter(bool one_button = false) {
    input.hands[1] = pointing_at(centre(), input.hands[1].grip.position);
    input.hands[1].can_grab = !one_button;
    step();
    input.hands[1].trigger = 1;
    step();
    input.hands[1].trigger = 0;
    seconds(2.2 * rules.fade_seconds);
    ASSERT_TRUE(visit.cavity);
  }
};

TEST_F(VisitTest, KnowsThePulpAsACavity) {
  ASSERT_EQ(balls.cavities.size(), 1u);
  EXPECT_EQ(balls.cavities[0].structure, "pulp");
  EXPECT_TRUE(balls.cavities[0].body);
  EXPECT_NEAR(balls.cavities[0].clearance_mm, 2, 0.1);
  const Scene inside = seen_within(balls.scene, balls.model, balls.cavities[0].wall(), 1);
  EXPECT_TRUE(inside.look_of("pulp")->as_body);
  EXPECT_FALSE(inside.look_of("dentine")->visible);
}

TEST_F(VisitTest, TheToothIsBeforeThePersonEnlarged) {
  EXPECT_DOUBLE_EQ(visit.stage.magnification, usual_magnification);
  EXPECT_LT(glm::dot(centre() - input.head.position, glm::dvec3(0, 0, 1)), -0.6);
  // It stays in the world when the head moves.
  const Stage stage = visit.stage;
  input.head.position += glm::dvec3(0.1, 0.05, 0);
  step(10);
  EXPECT_EQ(visit.stage, stage);
}

TEST_F(VisitTest, NothingHappensWithoutAHeadOrFocus) {
  Visit waiting;
  input.head_tracked = false;
  waiting = advance_visit(waiting, input, balls.world(), rules, tick);
  EXPECT_FALSE(waiting.placed);
  input.head_tracked = true;
  input.hands[0].grab = 1;
  step();
  EXPECT_EQ(visit.hands.held[0], Visit::Held::model);
  input.focused = false;
  const Stage stage = visit.stage;
  input.hands[0].grip.position.x += 0.3;
  input.hands[1].stick = {1, 1};
  input.hands[1].menu = true;
  step(5);
  EXPECT_EQ(visit.stage, stage);
  // A button that is still held when the focus comes back is no press. The hand is where it is, and nothing jumps.
  input.focused = true;
  input.hands[1] = {};
  input.hands[0].grab = 0;
  step(5);
  EXPECT_EQ(visit.stage, stage);
}

TEST_F(VisitTest, OneHandCarries) {
  const glm::dvec3 before = centre();
  input.hands[0].grip.position.x += 0.3;  // empty-handed
  step();
  EXPECT_EQ(centre(), before);
  input.hands[0].grab = 1;
  step();
  EXPECT_EQ(centre(), before);
  input.hands[0].grip.position += glm::dvec3(0.1, 0.2, -0.3);
  step();
  EXPECT_LT(glm::length(centre() - before - glm::dvec3(0.1, 0.2, -0.3)), 1e-9);
  input.hands[0].grab = 0;
  step();
  input.hands[0].grip.position.x += 1;
  step();
  EXPECT_LT(glm::length(centre() - before - glm::dvec3(0.1, 0.2, -0.3)), 1e-9);
}

TEST_F(VisitTest, TwoHandsScaleAndTrueSizeComesBack) {
  for (HandInput& hand : input.hands) hand.grab = 1;
  step();
  const double apart = glm::length(input.hands[1].grip.position - input.hands[0].grip.position);
  input.hands[1].grip.position += glm::normalize(input.hands[1].grip.position - input.hands[0].grip.position) * apart;
  step();
  EXPECT_NEAR(visit.stage.magnification, 2 * usual_magnification, 1e-9);
  for (HandInput& hand : input.hands) hand.grab = 0;
  input.hands[0].menu = true;
  seconds(3 * rules.menu_seconds);  // held on it does it once
  EXPECT_EQ(visit.stage.magnification, 1);
  input.hands[0].menu = false;
  step();
  input.hands[0].menu = true;
  seconds(rules.menu_seconds + tick);
  EXPECT_EQ(visit.stage.magnification, usual_magnification);
}

TEST_F(VisitTest, AHandThatVanishesLetsGoAndComesBackEmpty) {
  input.hands[0].grab = 1;
  step();
  input.hands[0].tracked = false;
  step();
  const Stage stage = visit.stage;
  input.hands[0].tracked = true;
  input.hands[0].grip.position += glm::dvec3(0.5, 0, 0);
  step(3);
  EXPECT_EQ(visit.stage, stage);
}

TEST_F(VisitTest, ASnapTurnIsSuddenAndSingle) {
  const glm::dvec3 pole = visit.stage.turn * glm::dvec3(0, 1, 0);
  input.hands[1].stick = {1, 0};
  step(30);
  const glm::dvec3 turned = visit.stage.turn * glm::dvec3(0, 1, 0);
  EXPECT_NEAR(glm::degrees(std::acos(glm::dot(pole, turned))), rules.snap_turn_deg, 1e-6);
  EXPECT_GT(turned.x, 0);  // what is near goes to the right, as the stick did
  EXPECT_NEAR(visit.seen.vignette, 0, 1e-9);
}

TEST_F(VisitTest, AStickBringsItNearerButNotIntoTheFace) {
  input.hands[0].stick = {0, -1};
  seconds(5);
  EXPECT_NEAR(glm::length(centre() - input.head.position), 0.25, 0.02);
}

TEST_F(VisitTest, RecentringPutsItBeforeThePersonAgain) {
  input.head.position = {5, 1.6, 5};
  input.head.turn = glm::angleAxis(2.0, glm::dvec3(0, 1, 0));
  input.recentred = true;
  step();
  EXPECT_LT(glm::length(centre() - input.head.position), 0.8);
}

TEST_F(VisitTest, ATriggerOnThePulpLeadsInside) {
  const double outside = visit.stage.magnification;
  enter();
  EXPECT_GT(visit.stage.magnification, outside);
  EXPECT_NEAR(wall_metres(), rules.roomy, 0.1);
  EXPECT_NEAR(visit.seen.dark, 0, 1e-9);
  // Up is up.
  EXPECT_LT(glm::length(visit.stage.turn * glm::dvec3(0, 0, 1) - glm::dvec3(0, 1, 0)), 1e-9);
  input.hands[0].menu = true;
  seconds(rules.menu_seconds + tick);
  input.hands[0].menu = false;
  seconds(2.2 * rules.fade_seconds);
  EXPECT_FALSE(visit.cavity);
  EXPECT_NEAR(visit.stage.magnification, outside, 1e-9);
}

// The sample molar's void belongs to the dentine, and a pulp fills it: what one points at is the pulp.
TEST(Visit, TheSampleMolarsPulpLeadsIntoTheDentinesVoid) {
  const VisitWorld world = MolarWorld::once().world();
  const auto& cavities = world.cavities;
  ASSERT_FALSE(cavities.empty());
  HeadsetInput input = person();
  Visit visit = advance_visit({}, input, world, {}, tick);
  input.hands[1] = pointing_at(to_room(visit.stage, cavities[0].middle), input.hands[1].grip.position);
  visit = advance_visit(visit, input, world, {}, tick);
  ASSERT_TRUE(visit.hands.pointed[1]);
  EXPECT_EQ(visit.hands.pointed[1]->structure, "pulp");
  input.hands[1].trigger = 1;
  for (int i = 0; i < 60; ++i) visit = advance_visit(visit, input, world, {}, tick);
  EXPECT_TRUE(visit.cavity);
}

TEST_F(VisitTest, ItIsDarkWhileThePlaceChanges) {
  input.hands[1] = pointing_at(centre(), input.hands[1].grip.position);
  step();
  input.hands[1].trigger = 1;
  double jump_at = -1, before = visit.stage.magnification;
  for (int i = 0; i < 200; ++i) {
    step();
    if (visit.stage.magnification != before) jump_at = visit.seen.dark;
    before = visit.stage.magnification;
  }
  EXPECT_EQ(jump_at, 1);
}

TEST_F(VisitTest, ATriggerBesideThePulpDoesNothing) {
  input.hands[1] = pointing_at(centre() + glm::dvec3(0.09, 0, 0),
                               input.hands[1].grip.position);  // the pulp is 0.05 m here, the dentine 0.125
  step();
  input.hands[1].trigger = 1;
  const Stage stage = visit.stage;
  seconds(1);
  EXPECT_FALSE(visit.cavity);
  EXPECT_EQ(visit.stage, stage);
}

TEST_F(VisitTest, WithOneButtonTheTriggerGrabsWhereThereIsNoPulp) {
  input.hands[1].can_grab = false;
  step();
  input.hands[1].trigger = 1;
  step();
  const glm::dvec3 before = centre();
  input.hands[1].grip.position.y += 0.1;
  step();
  EXPECT_NEAR(centre().y, before.y + 0.1, 1e-9);
  input.hands[1].trigger = 0;
  step();
  enter(true);
}

TEST_F(VisitTest, NeitherTriggerNorStickNorHeadGetsThroughTheWall) {
  enter();
  const auto check_wall = [&] {
    ASSERT_EQ(balls.cavities[0].walls.locate(visit.eye_mm), Walls::Side::inside);
    ASSERT_GE(wall_metres(), rules.clearance * (1 - 1e-6));
    // The middle of the eyes is where the head is.
    ASSERT_LT(glm::length(to_room(visit.stage, visit.eye_mm) - input.head.position), 1e-9);
  };
  input.hands[1].trigger = 1;  // glides where the hand points
  input.hands[1].aim.turn = glm::angleAxis(1.0, glm::dvec3(0, 1, 0));
  for (int i = 0; i < 400; ++i) {
    step();
    check_wall();
  }
  EXPECT_LT(wall_metres(), rules.clearance + 0.05) << "it did not get to the wall";
  input.hands[1].trigger = 0;
  input.hands[0].stick = {1, 1};
  for (int i = 0; i < 300; ++i) {
    step();
    check_wall();
  }
  input.hands[0].stick = {0, 0};
  input.head.position += glm::dvec3(3, 0, 0);  // a leap of the tracking
  step();
  check_wall();
}

TEST_F(VisitTest, GlidingIsNoFasterThanTheLimitAndDarkensTheEdges) {
  enter();
  input.hands[1].aim = input.head;
  input.hands[1].trigger = 1;
  double fastest = 0, darkest = 0;
  for (int i = 0; i < 90; ++i) {
    const glm::dvec3 before = visit.eye_mm;
    step();
    fastest = std::max(fastest, glm::length(visit.eye_mm - before) / mm_per_metre(visit.stage) / tick);
    darkest = std::max(darkest, visit.seen.vignette);
  }
  EXPECT_LE(fastest, rules.most_speed * 1.001);
  EXPECT_GT(fastest, 0.3);
  EXPECT_GT(darkest, 0.2);
  input.hands[1].trigger = 0;
  seconds(2);
  EXPECT_LT(visit.seen.vignette, 0.01);
}

TEST_F(VisitTest, TheWayDoesNotDependOnTheFrameRate) {
  enter();
  input.hands[1].aim = input.head;
  input.hands[1].trigger = 1;
  Visit slow = visit;
  for (int i = 0; i < 40; ++i) slow = advance_visit(slow, input, balls.world(), rules, tick);
  Visit fast = visit;
  for (int i = 0; i < 160; ++i) fast = advance_visit(fast, input, balls.world(), rules, tick / 4);
  EXPECT_LT(glm::length(slow.eye_mm - fast.eye_mm), 0.02);
}

TEST_F(VisitTest, InsideASnapTurnLeavesTheEyeWhereItIs) {
  enter();
  const glm::dvec3 eye = visit.eye_mm;
  const double heading = visit.stage.turn.y;
  input.hands[1].stick = {1, 0};
  step(5);
  EXPECT_LT(glm::length(visit.eye_mm - eye), 1e-9);
  EXPECT_NE(visit.stage.turn.y, heading);
}

}  // namespace
}  // namespace odontoscope::testing_support
