#include "engine/measure/pick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/measure/wall_thickness.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

constexpr glm::dvec2 size{200, 100};

/// From the buccal side, parallel, 20 mm from top to bottom around the origin.
Scene from_buccal(const Model& model) {
  Scene scene = usual_scene(model, 2);
  scene.camera = {Camera::Projection::parallel, {0, 60, 0}, {0, 0, 0}, {0, 0, 1}, 24, 20};
  return scene;
}

class Pick : public ::testing::Test {
 protected:
  std::optional<Hit> at(double x, double y) const {
    return pick(pickable, scene, ray_through(scene.camera, {x, y}, size));
  }
  Model model = hollow_ball_model();  // radii 5 and 2
  Pickable pickable{model};
  Scene scene = from_buccal(model);
};

TEST_F(Pick, TheMiddleOfTheBallIsItsNearestPoint) {
  const auto hit = at(100, 50);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->structure, "shell");
  EXPECT_TRUE(hit->front);
  EXPECT_NEAR(hit->point_mm.y, 5, 0.03);
  EXPECT_NEAR(hit->distance_mm, 55, 0.03);
  EXPECT_GT(hit->normal.y, 0.99);
}

TEST_F(Pick, PixelsCountFromTheUpperLeft) {
  EXPECT_NEAR(at(120, 50)->point_mm.x, -4, 1e-6) << "from buccal, +x is to the left";
  EXPECT_NEAR(at(100, 30)->point_mm.z, 4, 1e-6);
  EXPECT_FALSE(at(126, 50)) << "beside the ball";
}

TEST_F(Pick, PerspectiveRaysRunThroughWhatTheyShow) {
  scene.camera = {Camera::Projection::perspective, {3, 40, 7}, {1, 0, 2}, {0, 0.2, 1}, 31, 20};
  const View view = view_of(scene.camera, model, size.x / size.y);
  for (const glm::dvec3 target : {glm::dvec3(1, 2, 3), glm::dvec3(-4, 1, -2), glm::dvec3(0, -3, 6)}) {
    const glm::vec4 clip =
        view.eye_to_clip * view.world_to_eye * glm::vec4(glm::vec3(metres_per_mm * (target - model.origin_mm)), 1);
    const glm::dvec2 pixel{0.5 * size.x * (1 + clip.x / clip.w), 0.5 * size.y * (1 - clip.y / clip.w)};
    const Ray ray = ray_through(scene.camera, pixel, size);
    const glm::dvec3 offset = target - ray.origin_mm;
    EXPECT_NEAR(glm::length(offset - glm::dot(offset, ray.direction) * ray.direction), 0, 1e-3);
  }
}

TEST_F(Pick, WhatIsHiddenIsLookedThrough) {
  scene.look_of("shell")->visible = false;
  scene.look_of("shell cavity")->as_body = true;
  auto hit = at(100, 50);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->structure, "shell cavity");
  EXPECT_NEAR(hit->point_mm.y, 2, 0.03);
  scene.look_of("shell cavity")->as_body = false;  // its near wall now shows its back, its far wall its front
  EXPECT_NEAR(at(100, 50)->point_mm.y, -2, 0.03);
  scene.back_faces = BackFaces::show;
  hit = at(100, 50);
  EXPECT_NEAR(hit->point_mm.y, 2, 0.03);
  EXPECT_FALSE(hit->front);
  EXPECT_GT(hit->normal.y, 0.9) << "towards the eye all the same";
  scene.look_of("shell cavity")->opacity = 0;
  EXPECT_FALSE(at(100, 50));
}

TEST_F(Pick, FaintSurfacesCanBeLookedThrough) {
  scene.look_of("shell")->opacity = 0.2f;
  scene.look_of("shell cavity")->as_body = true;
  const Ray ray = ray_through(scene.camera, {100, 50}, size);
  EXPECT_EQ(pick(pickable, scene, ray)->structure, "shell");
  EXPECT_EQ(pick(pickable, scene, ray, {.least_opacity = 0.3f})->structure, "shell cavity");
}

TEST_F(Pick, TheSectionsCapIsHitAndTheHollowIsNot) {
  scene.section = Section{{0, 1, 0}, {0, 3, 0}};
  scene.look_of("shell cavity")->as_body = false;
  const auto rim = at(135 - 0.2, 50);  // z = 0, x = 3.48: in the wall
  EXPECT_FALSE(at(151, 50));
  const auto cap = at(100 - 17.5, 50);  // x = 3.5
  ASSERT_TRUE(cap);
  EXPECT_FALSE(cap->triangle) << "a cap";
  EXPECT_EQ(cap->structure, "shell");
  EXPECT_NEAR(cap->point_mm.y, 1, 1e-6);
  EXPECT_EQ(cap->normal, glm::dvec3(0, 1, 0));
  const auto hollow = at(100, 50);
  ASSERT_TRUE(hollow);
  EXPECT_TRUE(hollow->triangle);
  EXPECT_NEAR(hollow->point_mm.y, -2, 0.03) << "the far wall of the cavity";
  EXPECT_FALSE(rim);
}

TEST_F(Pick, CutOpenACavityIsItsWallWhateverItsLook) {
  scene.section = Section{{0, 1, 0}, {0, 3, 0}};
  Look& cavity = *scene.look_of("shell cavity");
  cavity.as_body = true;
  for (const auto projection : {Camera::Projection::parallel, Camera::Projection::perspective}) {
    scene.camera.projection = projection;
    const auto hit = at(100, 50);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->structure, "shell cavity");
    EXPECT_TRUE(hit->front);
    EXPECT_NEAR(hit->point_mm.y, -2, 0.03);
  }
  scene.look_of("shell")->visible = false;  // from the side that is left it is a body still
  scene.section = Section{{0, -1, 0}, {0, -3, 0}};
  EXPECT_NEAR(at(100, 50)->point_mm.y, 2, 0.03);
}

TEST_F(Pick, FromTheSideThatIsLeftThereIsNoCap) {
  scene.section = Section{{0, 1, 0}, {0, -1, 0}};
  const auto hit = at(100, 50);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point_mm.y, 5, 0.03);
}

TEST_F(Pick, FarFromTheOriginItIsAsExact) {
  const Model far = make_model({{"ball", ball({{-90'000, 500'000, 250'000}, 5})}});
  Scene there = usual_scene(far, 2);
  there.camera = {
      Camera::Projection::parallel, {-90'000, 500'060, 250'000}, {-90'000, 500'000, 250'000}, {0, 0, 1}, 24, 20};
  const auto hit = pick(Pickable(far), there, ray_through(there.camera, {100, 50}, size));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point_mm.y, 500'005, 0.03);
}

TEST(PickedDistance, IsTheStraightLine) {
  Hit a, b;
  a.point_mm = {1, 2, 3};
  b.point_mm = {4, 6, 15};
  EXPECT_DOUBLE_EQ(distance_between_mm(a, b), 13);
}

}  // namespace
}  // namespace odontoscope::testing_support
