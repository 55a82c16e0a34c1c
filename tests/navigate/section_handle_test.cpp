#include "engine/navigate/section_handle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace odontoscope {
namespace {

constexpr double reach = 0.3;

Model cube() {
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back({i & 1 ? 5.0 : -5.0, i & 2 ? 5.0 : -5.0, i & 4 ? 5.0 : -5.0});
  mesh.triangles = {{0, 2, 1}, {5, 7, 6}};
  return make_model({{"cube", mesh}});
}

Camera eye_at(const glm::dvec3& position) {
  Camera camera;
  camera.position = position;
  return camera;
}

const Section facing_x{{0, 0, 0}, {2, 0, 0}};

TEST(SectionHandle, IsAsLargeFromNearAndFar) {
  for (const double distance : {20.0, 60.0, 400.0}) {
    const auto handle = section_handle(facing_x, eye_at({0, distance, 0}), reach);
    ASSERT_TRUE(handle);
    EXPECT_NEAR(glm::distance(handle->knob, handle->tip), reach, 1e-9);
  }
}

TEST(SectionHandle, IsHitWhereItIsDrawn) {
  const auto handle = section_handle(facing_x, eye_at({10, 50, 20}), reach).value();
  EXPECT_EQ(grip_at(handle, handle.tip, 0.02), SectionGrip::turn);
  EXPECT_EQ(grip_at(handle, handle.knob + glm::dvec2(0.01, 0), 0.02), SectionGrip::slide);
  EXPECT_FALSE(grip_at(handle, handle.knob + glm::dvec2(0, 0.2), 0.02));
}

TEST(SectionHandle, TheKnobFollowsTheHandAlongTheNormal) {
  const Model model = cube();
  Camera camera = eye_at({0, 60, 0});
  camera.projection = Camera::Projection::parallel;
  const auto before = section_handle(facing_x, camera, reach).value();
  const glm::dvec2 hand = before.knob + glm::dvec2(-0.1, 0.05);  // +x is at the left
  const Section moved = dragged(facing_x, SectionGrip::slide, camera, reach, before.knob, hand, model);
  EXPECT_NEAR(section_handle(moved, camera, reach)->knob.x, hand.x, 1e-9);
  EXPECT_GT(offset_of(moved, model), 0.5);
  EXPECT_NEAR(glm::dot(glm::normalize(moved.normal), glm::dvec3(1, 0, 0)), 1, 1e-12);
}

TEST(SectionHandle, StaysInTheModelAndFiniteHoweverFarTheHandGoes) {
  const Model model = cube();
  for (const glm::dvec3& eye : {glm::dvec3(0, 60, 0), glm::dvec3(60, 0.001, 0), glm::dvec3(-30, 30, 10)})
    for (const glm::dvec2& hand : {glm::dvec2(50, 0), glm::dvec2(-50, 80), glm::dvec2(0, -1e6)})
      for (const SectionGrip grip : {SectionGrip::slide, SectionGrip::turn}) {
        const Section moved = dragged(facing_x, grip, eye_at(eye), reach, {0, 0}, hand, model);
        EXPECT_LE(std::abs(offset_of(moved, model)), model.radius_mm);
        EXPECT_GT(glm::length(moved.normal), 0.5);
        EXPECT_LT(glm::length(moved.normal), 3);
      }
}

TEST(SectionHandle, TheTipFollowsTheHand) {
  const Camera camera = eye_at({20, 60, 10});
  const Section start{{0, 0, 0}, glm::normalize(glm::dvec3(1, 1, 0.2))};
  const auto handle = section_handle(start, camera, reach).value();
  const glm::dvec2 hand = handle.tip + glm::dvec2(-0.06, 0.04);
  const Section turned = dragged(start, SectionGrip::turn, camera, reach, handle.tip, hand, cube());
  EXPECT_LT(glm::distance(section_handle(turned, camera, reach)->tip, hand), 1e-6);
  EXPECT_EQ(turned.point_mm, start.point_mm);
  EXPECT_GT(glm::dot(turned.normal, axes_of(camera).towards_eye), 0);  // on the side where it was
}

TEST(SectionAngles, GoThereAndBack) {
  for (double round = -175; round < 180; round += 35)
    for (double up = -80; up <= 80; up += 20) {
      const SectionAngles angles = angles_of({{}, normal_of({round, up})});
      EXPECT_NEAR(angles.round_deg, round, 1e-9);
      EXPECT_NEAR(angles.up_deg, up, 1e-9);
    }
  EXPECT_NEAR(angles_of({{}, {0, 0, 3}}).up_deg, 90, 1e-9);
}

}  // namespace
}  // namespace odontoscope
