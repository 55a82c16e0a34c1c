// Where the model stands in the room: similarities that keep what they promise.
#include "engine/headset/stage.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "engine/headset/scale_mark.h"
#include "tests/headset/worlds.h"

namespace odontoscope::testing_support {
namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
  EXPECT_LE(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

glm::dvec3 any_place(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-2, 2);
  const double x = number(random), y = number(random), z = number(random);
  return {x, y, z};
}

Pose any_pose(std::mt19937& random) {
  const glm::dvec3 position = any_place(random);
  return {position, glm::angleAxis(any_place(random).x, glm::normalize(any_place(random)))};
}

Stage any_stage(std::mt19937& random) { return {any_place(random), any_pose(random).turn, 25}; }

TEST(Stage, GoesToTheRoomAndBack) {
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    const Stage stage = any_stage(random);
    const glm::dvec3 point = 100.0 * any_place(random);
    expect_near(to_model(stage, to_room(stage, point)), point, 1e-9);
    expect_near(to_room(stage, point + glm::dvec3(1, 0, 0)) - to_room(stage, point),
                0.025 * (stage.turn * glm::dvec3(1, 0, 0)));
  }
}

TEST(Stage, StandsUprightAtArmsLengthWithItsBuccalSideToTheEyes) {
  const BallWorld& balls = BallWorld::once();
  Pose head{{0.5, 1.7, -0.3}, glm::angleAxis(0.7, glm::dvec3(0, 1, 0)) * glm::angleAxis(-0.4, glm::dvec3(1, 0, 0))};
  const Stage stage = before(head, balls.model);
  const glm::dvec3 centre = to_room(stage, balls.model.bounds_mm.centre());
  const glm::dvec3 away = centre - head.position;
  EXPECT_NEAR(std::hypot(away.x, away.z), arms_length, 1e-9);
  EXPECT_LT(away.y, 0);
  expect_near(stage.turn * glm::dvec3(0, 0, 1), {0, 1, 0});
  expect_near(stage.turn * glm::dvec3(0, 1, 0), -glm::normalize(glm::dvec3(away.x, 0, away.z)));
  // Straight up or down there is a heading, too.
  for (const double tilt : {1.5707, -1.5707}) {
    head.turn = glm::angleAxis(0.7, glm::dvec3(0, 1, 0)) * glm::angleAxis(tilt, glm::dvec3(1, 0, 0));
    expect_near(heading_of(head) * glm::dvec3(0, 0, -1),
                glm::angleAxis(0.7, glm::dvec3(0, 1, 0)) * glm::dvec3(0, 0, -1), 1e-3);
  }
}

TEST(Stage, TurnsTheWantedSideToTheEyes) {
  const BallWorld& balls = BallWorld::once();
  const Pose head{{0, 1.6, 0}, {1, 0, 0, 0}};
  for (const glm::dvec3& facing : {glm::dvec3(1, 0, 0), glm::dvec3(-3, 1, 2), glm::dvec3(0, -1, 0.5)}) {
    const Stage stage = before(head, balls.model, 25, facing);
    const glm::dvec3 shown = stage.turn * glm::normalize(glm::dvec3(facing.x, facing.y, 0));
    expect_near(shown, {0, 0, 1});
    expect_near(stage.turn * glm::dvec3(0, 0, 1), {0, 1, 0});
  }
  EXPECT_EQ(before(head, balls.model, 25, {0, 0, 1}), before(head, balls.model));
}

TEST(ScaleMark, IsWrittenBelowTheToothForWhoeverLooksAtIt) {
  const BallWorld& balls = BallWorld::once();
  const Pose head{{0.4, 1.6, -0.2}, glm::angleAxis(1.1, glm::dvec3(0, 1, 0))};
  const Stage stage = before(head, balls.model);
  EXPECT_EQ(strokes("8").size(), 14u);
  EXPECT_EQ(strokes("1").size(), 4u);
  std::set<std::size_t> lit;
  for (const char* digit : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"}) {
    std::size_t code = 0;
    for (const glm::dvec3& point : strokes(digit))
      code = 31 * code + static_cast<std::size_t>(4 * point.x + 16 * point.y);
    EXPECT_TRUE(lit.insert(code).second) << digit << " looks like another";
  }
  const std::vector<glm::dvec3> mark = scale_mark(stage, balls.model, head.position);
  ASSERT_EQ(mark.size(), strokes("25x").size());
  const glm::dvec3 right = head.turn * glm::dvec3(1, 0, 0);
  const double lowest = to_room(stage, balls.model.bounds_mm.centre()).y - balls.model.radius_mm * 0.025;
  for (const glm::dvec3& point : mark) EXPECT_LT(point.y, lowest);
  // Begins on the left and ends on the right.
  EXPECT_LT(glm::dot(mark.front() - mark.back(), right), -0.02);
}

TEST(Stage, OneHandCarriesItRigidly) {
  std::mt19937 random(8);
  for (int i = 0; i < 100; ++i) {
    const Stage stage = any_stage(random);
    const Pose from = any_pose(random), to = any_pose(random);
    const Stage after = carried(stage, from, to);
    EXPECT_DOUBLE_EQ(after.magnification, stage.magnification);
    // What the hand holds stays where it is in the hand.
    const glm::dvec3 point = 30.0 * any_place(random);
    expect_near(glm::conjugate(to.turn) * (to_room(after, point) - to.position),
                glm::conjugate(from.turn) * (to_room(stage, point) - from.position));
  }
}

TEST(Stage, TwoHandsHoldTheirPointsAndScale) {
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i) {
    const Stage stage = any_stage(random);
    const glm::dvec3 middle = any_place(random), half = 0.2 * glm::normalize(any_place(random));
    const glm::dvec3 other_middle = any_place(random), other_half = 0.3 * glm::normalize(any_place(random));
    const glm::dvec3 from[2] = {middle - half, middle + half},
                     to[2] = {other_middle - other_half, other_middle + other_half};
    const Stage after = carried(stage, from, to);
    EXPECT_NEAR(after.magnification, 1.5 * stage.magnification, 1e-9);
    for (int hand = 0; hand < 2; ++hand) expect_near(to_room(after, to_model(stage, from[hand])), to[hand]);
  }
}

TEST(Stage, TwoHandsStopAtTheLimitsOfMagnification) {
  Stage stage;
  stage.magnification = most_magnification / 2;
  const glm::dvec3 near_each_other[2] = {{0, 0, 0}, {0.1, 0, 0}}, apart[2] = {{0, 0, 0}, {1, 0, 0}},
                   opposite[2] = {{0.1, 0, 0}, {0, 0, 0}}, together[2] = {{0, 0, 0}, {0, 0, 0}};
  EXPECT_DOUBLE_EQ(carried(stage, near_each_other, apart).magnification, most_magnification);
  stage.magnification = 2 * least_magnification;
  EXPECT_DOUBLE_EQ(carried(stage, apart, near_each_other).magnification, least_magnification);
  EXPECT_EQ(carried(stage, near_each_other, together), stage);
  expect_near(carried(stage, near_each_other, opposite).turn * glm::dvec3(1, 0, 0), {-1, 0, 0});
}

TEST(Stage, TurnsAboutTheVertical) {
  std::mt19937 random(10);
  const Stage stage = any_stage(random);
  const glm::dvec3 axis = any_place(random), point{3, 4, 5};
  const Stage after = turned_about(stage, axis, 0.5);
  EXPECT_NEAR(to_room(after, point).y, to_room(stage, point).y, 1e-12);
  expect_near(to_room(after, to_model(stage, axis)), axis);
  expect_near(to_room(turned_about(after, axis, -0.5), point), to_room(stage, point));
}

// The view that an eye gets is the one that geometry demands: where a point of the model appears between the tangents
// of the eye's field.
TEST(Stage, EyesSeeThePointsWhereTheyAre) {
  const BallWorld& balls = BallWorld::once();
  std::mt19937 random(11);
  for (int i = 0; i < 100; ++i) {
    Stage stage = any_stage(random);
    stage.magnification = i % 2 == 0 ? 25 : 1400;
    const Pose head = any_pose(random);
    for (const EyeView& eye : eyes_of(head)) {
      const glm::dvec3 in_eye{0.3, -0.2, -1.1};  // metres before the eye
      const glm::dvec3 point = to_model(stage, eye.pose.position + eye.pose.turn * in_eye);
      const View view = view_of(stage, eye, balls.model);
      const glm::dvec4 clip = glm::dmat4(view.eye_to_clip) * glm::dmat4(view.world_to_eye) *
                              glm::dvec4(metres_per_mm * (point - balls.model.origin_mm), 1);
      const FieldOfView& field = eye.field;
      const double across =
          (in_eye.x / -in_eye.z - std::tan(field.left)) / (std::tan(field.right) - std::tan(field.left));
      const double along = (in_eye.y / -in_eye.z - std::tan(field.down)) / (std::tan(field.up) - std::tan(field.down));
      EXPECT_NEAR(0.5 + 0.5 * clip.x / clip.w, across, 2e-4);
      EXPECT_NEAR(0.5 + 0.5 * clip.y / clip.w, along, 2e-4);
    }
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
