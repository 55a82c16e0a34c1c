// The section plane in the hand: its frame, who takes hold of it, and that it stays where it is let go.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "engine/headset/section_frame.h"
#include "engine/navigate/section_handle.h"
#include "tests/headset/visiting.h"

namespace odontoscope::testing_support {
namespace {

TEST(SectionFrame, LiesInThePlaneAndRoundTheModel) {
  const BallWorld& balls = BallWorld::once();
  const Stage stage = before({{0.2, 1.5, 0}, glm::angleAxis(0.4, glm::dvec3(0, 1, 0))}, balls.model);
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  for (int i = 0; i < 100; ++i) {
    const double x = any(random), y = any(random), z = any(random), offset = any(random);
    const Section section = with_offset({{}, {x, y, z}}, offset, balls.model);
    const SectionFrame frame = section_frame(section, stage, balls.model);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(glm::dot(to_model(stage, frame[k]) - section.point_mm, section.normal), 0, 1e-9);
      // Every edge is farther from the middle than the ball of 5 mm, and right angles are right.
      const glm::dvec3 edge = frame[(k + 1) % 4] - frame[k];
      const glm::dvec3 to_middle = to_room(stage, section.point_mm) - frame[k];
      EXPECT_GT(glm::length(to_middle - glm::dot(to_middle, edge) / glm::dot(edge, edge) * edge), 0.005 * 25);
      EXPECT_NEAR(glm::dot(edge, frame[(k + 2) % 4] - frame[(k + 1) % 4]), 0, 1e-9);
    }
  }
}

class SectionInHand : public VisitingBalls {
 protected:
  void SetUp() override {
    step();
    visit.panel.reset();
    visit.pending_actions = {VisitAction::toggle_section};
    step();
    ASSERT_TRUE(visit.scene.section);
  }
  SectionFrame frame() const { return section_frame(*visit.scene.section, visit.stage, balls.model); }
  void point(const glm::dvec3& place) {
    const HandInput was = input.hands[1];
    input.hands[1] = pointing_at(place, input.head.position + glm::dvec3(0.2, -0.3, -0.2));
    input.hands[1].can_grab = was.can_grab;
    step();
  }
  glm::dvec3 edge() const { return 0.5 * (frame()[0] + frame()[1]); }
};

TEST_F(SectionInHand, AGrabOnTheFrameMovesThePlaneAndNotTheTooth) {
  point(edge());
  ASSERT_TRUE(visit.hands.on_frame[1]);
  EXPECT_FALSE(visit.hands.pointed[1]);
  const Stage stage = visit.stage;
  const Section before = *visit.scene.section;
  const glm::dvec3 normal = stage.turn * glm::normalize(before.normal);
  input.hands[1].grab = 1;
  step();
  EXPECT_EQ(visit.hands.held[1], Visit::Held::section);
  const glm::dvec3 by = 0.05 * normal;
  input.hands[1].grip.position += by;
  input.hands[1].aim.position += by;
  step();
  EXPECT_EQ(visit.stage, stage);
  EXPECT_NEAR(offset_of(*visit.scene.section, balls.model) - offset_of(before, balls.model), 2,
              1e-9);  // 5 cm, 25 times enlarged
  // Turned by the hand: about the hand, and by as much.
  const glm::dquat turn = glm::angleAxis(0.1, glm::normalize(glm::dvec3(1, 2, 0)));
  const glm::dvec3 held = input.hands[1].grip.position,
                   point_before = to_room(visit.stage, visit.scene.section->point_mm),
                   normal_before = visit.stage.turn * visit.scene.section->normal;
  input.hands[1].grip.turn = glm::normalize(turn * input.hands[1].grip.turn);
  step();
  const glm::dvec3 normal_after = visit.stage.turn * visit.scene.section->normal;
  EXPECT_LT(glm::length(normal_after - turn * normal_before), 1e-9);
  EXPECT_NEAR(
      glm::dot(normal_after, held + turn * (point_before - held) - to_room(visit.stage, visit.scene.section->point_mm)),
      0, 1e-9);
  // It stays where it is let go.
  input.hands[1].grab = 0;
  step();
  const Section left = *visit.scene.section;
  input.hands[1].grip.position += glm::dvec3(0.3, 0, 0);
  step(5);
  EXPECT_EQ(*visit.scene.section, left);
}

TEST_F(SectionInHand, CannotBeCarriedOutOfTheTooth) {
  point(edge());
  input.hands[1].grab = 1;
  step();
  const glm::dvec3 normal = visit.stage.turn * visit.scene.section->normal;
  input.hands[1].grip.position += 3.0 * normal;
  step();
  EXPECT_LT(std::abs(offset_of(*visit.scene.section, balls.model)), balls.model.radius_mm);
  EXPECT_LT(glm::length(visit.scene.section->point_mm - balls.model.bounds_mm.centre()), balls.model.radius_mm);
}

TEST_F(SectionInHand, AGrabBesideTheFrameIsTheTooths) {
  point(to_room(visit.stage, balls.model.bounds_mm.centre()));
  EXPECT_FALSE(visit.hands.on_frame[1]);
  const Section before = *visit.scene.section;
  input.hands[1].grab = 1;
  step();
  EXPECT_EQ(visit.hands.held[1], Visit::Held::model);
  const Stage stage = visit.stage;
  input.hands[1].grip.position.y += 0.1;
  step();
  EXPECT_NE(visit.stage, stage);
  EXPECT_EQ(*visit.scene.section, before);  // it goes along, in the tooth
}

TEST_F(SectionInHand, AHandWithinReachTakesItAndSwitchingItOffLetsGo) {
  input.hands[1].grip.position = edge() + glm::dvec3(0.02, 0.03, 0.02);
  input.hands[1].can_grab = false;  // one button: the trigger grabs
  step();
  ASSERT_TRUE(visit.hands.on_frame[1]);
  input.hands[1].trigger = 1;
  step();
  EXPECT_EQ(visit.hands.held[1], Visit::Held::section);
  EXPECT_FALSE(visit.marks.named);
  visit.pending_actions = {VisitAction::toggle_section};
  step();
  EXPECT_EQ(visit.hands.held[1], Visit::Held::nothing);
  EXPECT_FALSE(visit.hands.on_frame[1]);
}

TEST_F(SectionInHand, WhatIsCutAwayIsNotPointedAt) {
  const glm::dvec3 front =
      visit.stage.turn * visit.scene.section->normal;  // towards the person: the buccal half is gone
  EXPECT_GT(front.z, 0.8);
  point(to_room(visit.stage, balls.model.bounds_mm.centre()));
  ASSERT_TRUE(visit.hands.pointed[1]);
  EXPECT_FALSE(visit.hands.pointed[1]->triangle) << "the cap";
  EXPECT_EQ(visit.hands.pointed[1]->structure, "pulp");
}

}  // namespace
}  // namespace odontoscope::testing_support
