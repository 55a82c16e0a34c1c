// Naming and measuring by a hand's ray, and what is written in the room.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/headset/billboards.h"
#include "engine/measure/wall_thickness.h"
#include "tests/headset/visiting.h"

namespace odontoscope::testing_support {
namespace {

class Tools : public VisitingBalls {
 protected:
  void SetUp() override {
    step();
    visit.panel.reset();
  }
  void pull_at(const glm::dvec3& place, std::size_t hand = 1) {
    input.hands[hand] = pointing_at(place, input.head.position + glm::dvec3(0, -0.1, -0.05));
    step();
    input.hands[hand].trigger = 1;
    step();
    input.hands[hand].trigger = 0;
    step();
  }
};

TEST_F(Tools, ATriggerNamesWhatItMeets) {
  pull_at(centre() + glm::dvec3(0.09, 0, 0));  // beside the pulp, on the translucent dentine
  ASSERT_TRUE(visit.marks.named);
  EXPECT_EQ(visit.marks.named->structure, "dentine");
  EXPECT_FALSE(visit.way);
  const auto written = billboards(visit, input, balls.world());
  ASSERT_EQ(written.size(), 1u);
  EXPECT_EQ(written[0].words, "dentine");
  // At the spot, and before it.
  EXPECT_LT(glm::length(written[0].of - to_room(visit.stage, visit.marks.named->point_mm)), 1e-12);
  const double there = glm::length(written[0].of - input.head.position),
               label = glm::length(written[0].at - input.head.position);
  EXPECT_LT(label, there);
  EXPECT_LT(glm::length(written[0].at - written[0].of), 0.06 * there);
  // It goes along with the tooth.
  visit.stage = moved(visit.stage, {0, 0.1, 0});
  EXPECT_NEAR(billboards(visit, input, balls.world())[0].of.y, written[0].of.y + 0.1, 1e-12);
  visit.pending_actions = {VisitAction::forget_marks};
  step();
  EXPECT_TRUE(billboards(visit, input, balls.world()).empty());
}

TEST_F(Tools, TwoTriggersMeasureAStraightDistance) {
  visit.chosen.tool = HandTool::distance;
  pull_at(centre() + glm::dvec3(0.08, 0, 0));
  ASSERT_EQ(visit.marks.ends.size(), 1u);
  EXPECT_TRUE(billboards(visit, input, balls.world()).empty());
  pull_at(centre() - glm::dvec3(0.08, 0, 0));
  ASSERT_EQ(visit.marks.ends.size(), 2u);
  // On a ball of 5 mm, 25 times enlarged, seen from before it: two places of the front, level.
  const glm::dvec3 between = visit.marks.ends[0].point_mm - visit.marks.ends[1].point_mm;
  for (const Hit& end : visit.marks.ends) EXPECT_NEAR(glm::length(end.point_mm - glm::dvec3(1, 2, 30)), 5, 0.05);
  const auto written = billboards(visit, input, balls.world());
  ASSERT_EQ(written.size(), 1u);
  EXPECT_NEAR(std::stod(written[0].words), glm::length(between), 0.0051);
  EXPECT_NE(written[0].words.find(" mm"), std::string::npos);
  pull_at(centre());  // the next one begins anew, and the pulp is no way in now
  EXPECT_EQ(visit.marks.ends.size(), 1u);
  EXPECT_FALSE(visit.way);
  EXPECT_FALSE(visit.cavity);
}

TEST_F(Tools, InsideItMeasuresFromWallToWallAndDoesNotGlide) {
  visit.pending_actions = {VisitAction::enter};
  step(80);
  ASSERT_TRUE(visit.cavity);
  visit.panel.reset();
  visit.chosen.tool = HandTool::distance;
  const glm::dvec3 eye = visit.eye_mm;
  pull_at(input.head.position + glm::dvec3(4, -0.1, -0.05));
  pull_at(input.head.position + glm::dvec3(-4, -0.1, -0.05));
  ASSERT_EQ(visit.marks.ends.size(), 2u);
  EXPECT_NEAR(distance_between_mm(visit.marks.ends[0], visit.marks.ends[1]), 4, 0.1);  // across a ball of 2 mm
  EXPECT_LT(glm::length(visit.eye_mm - eye), 1e-9);
  visit.pending_actions = {VisitAction::leave};
  step(80);
  EXPECT_TRUE(visit.marks.ends.empty());
}

TEST(BillboardShape, IsReadFromTheEyesUprightAndEquallyLargeEverywhere) {
  const Pose head{{0.3, 1.6, 0.2}, {1, 0, 0, 0}};
  for (const glm::dvec3& at : {glm::dvec3(1, 1, -2), glm::dvec3(-0.2, 1.9, 0.6), glm::dvec3(0.3, 1.1, -0.4)}) {
    const BillboardShape shape = shape_of({"x", at, at}, head, 3);
    EXPECT_NEAR(shape.size.x, 3 * shape.size.y, 1e-12);
    EXPECT_NEAR(glm::degrees(2 * std::atan(shape.size.y / 2 / glm::length(head.position - at))), 2.1, 1e-9);
    EXPECT_LT(glm::length(shape.pose.turn * glm::dvec3(0, 0, 1) - glm::normalize(head.position - at)), 1e-9);
    EXPECT_NEAR((shape.pose.turn * glm::dvec3(1, 0, 0)).y, 0, 1e-12);
    EXPECT_GT((shape.pose.turn * glm::dvec3(0, 1, 0)).y, 0);
    // `at` is the middle of the lower edge.
    EXPECT_LT(glm::length(shape.pose.position + shape.pose.turn * glm::dvec3(0, -0.5 * shape.size.y, 0) - at), 1e-12);
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
