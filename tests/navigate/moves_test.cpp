// What a hand does to a camera, from 200 cameras around the model in both projections.
#include "engine/navigate/moves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "engine/navigate/screen.h"

namespace odontoscope {
namespace {

/// A box of 10 x 8 x 20 mm, far from zero.
Model box_model() {
  const glm::dvec3 low{95, -4, 30}, high{105, 4, 50};
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  for (const auto& [a, b, c] : {std::array{0u, 2u, 1u}, {1u, 2u, 3u}, {4u, 5u, 6u}, {5u, 7u, 6u}})
    mesh.triangles.push_back({a, b, c});
  return make_model({{"box", mesh}});
}

std::vector<Camera> cameras() {
  std::vector<Camera> all;
  for (int i = 0; i < 100; ++i) {
    const double round = glm::radians(37.0 * i), up = glm::radians(-85 + 1.7 * i);
    Camera camera;
    camera.target = {100 + std::sin(i), std::cos(i), 40};
    camera.position = camera.target + (30 + 0.5 * i) * glm::dvec3(std::cos(up) * std::cos(round),
                                                                  std::cos(up) * std::sin(round), std::sin(up));
    camera.height_mm = 12 + 0.2 * i;
    for (const auto projection : {Camera::Projection::perspective, Camera::Projection::parallel}) {
      camera.projection = projection;
      all.push_back(camera);
    }
  }
  return all;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double slack = 1e-9) {
  EXPECT_LT(glm::distance(a, b), slack);
}
void expect_near(const glm::dvec2& a, const glm::dvec2& b, double slack = 1e-9) {
  EXPECT_LT(glm::distance(a, b), slack);
}

TEST(Screen, PlacesAndSightLinesAgree) {
  for (const Camera& camera : cameras())
    for (const glm::dvec2 place : {glm::dvec2(0, 0), glm::dvec2(1.2, -0.4), glm::dvec2(-0.3, 0.9)}) {
      const SightLine line = sight_line(camera, place);
      expect_near(place_of(camera, line.origin + 17.0 * line.direction).value(), place);
    }
}

TEST(Screen, AgreesWithWhatIsDrawn) {
  const Model model = box_model();
  for (const Camera& camera : cameras()) {
    const View view = view_of(camera, model, 1.5);
    const glm::dvec3 point{101, 1, 37};
    const glm::vec4 clip =
        view.eye_to_clip * view.world_to_eye * glm::vec4(glm::vec3(metres_per_mm * (point - model.origin_mm)), 1);
    const auto place = place_of(camera, point);
    ASSERT_TRUE(place);
    EXPECT_NEAR(clip.x / clip.w, place->x / 1.5, 1e-4);
    EXPECT_NEAR(clip.y / clip.w, place->y, 1e-4);
  }
}

TEST(Screen, SaysWhatIsBehindTheEye) {
  Camera camera;
  EXPECT_FALSE(place_of(camera, camera.position + (camera.position - camera.target)));
}

TEST(Orbit, KeepsDistanceAndPivotAndNeverTipsOver) {
  for (const Camera& camera : cameras()) {
    Camera now = camera;
    for (int i = 0; i < 60; ++i) {
      now = orbit(now, {13, i < 30 ? 7.0 : -11.0, camera.target});
      EXPECT_NEAR(glm::distance(now.position, now.target), glm::distance(camera.position, camera.target), 1e-9);
      expect_near(now.target, camera.target);
      EXPECT_GE(axes_of(now).up.z, -1e-7);
      EXPECT_NO_THROW(validate(now, "orbit"));
    }
  }
}

TEST(Orbit, OverThePoleIsAllowedUpToThePole) {
  Camera camera;
  camera = orbit(camera, {0, 500, camera.target});
  expect_near(axes_of(camera).towards_eye, {0, 0, 1}, 1e-7);
  camera = orbit(camera, {0, -90, camera.target});
  EXPECT_NEAR(axes_of(camera).towards_eye.z, 0, 1e-7);
}

TEST(Orbit, TheModelFollowsTheHand) {
  Camera camera;  // at +y, looking at the origin: +x is at the left
  const glm::dvec3 nearest{0, 5, 0};
  const Camera turned = orbit(camera, {10, 0, camera.target});
  EXPECT_GT(place_of(turned, nearest)->x, 0.01);  // to the right, as the hand went
  const Camera lifted = orbit(camera, {0, 10, camera.target});
  EXPECT_LT(place_of(lifted, nearest)->y, -0.01);  // the eye rose, so the front sinks
}

TEST(Orbit, ThereAndBackIsNoMove) {
  for (const Camera& camera : cameras()) {
    const Camera back = orbit(orbit(camera, {25, 0, {1, 2, 3}}), {-25, 0, {1, 2, 3}});
    expect_near(back.position, camera.position, 1e-8);
    expect_near(axes_of(back).up, axes_of(camera).up, 1e-8);
  }
}

TEST(Pan, WhatWasUnderTheHandStaysUnderIt) {
  for (const Camera& camera : cameras()) {
    const glm::dvec3 anchor{103, -2, 45};
    const glm::dvec2 from = place_of(camera, anchor).value(), to = from + glm::dvec2(0.31, -0.2);
    const Camera moved = pan(camera, from, to, anchor);
    expect_near(place_of(moved, anchor).value(), to);
    expect_near(axes_of(moved).towards_eye, axes_of(camera).towards_eye);
  }
}

TEST(Zoom, TheAnchorStaysInThePicture) {
  for (const Camera& camera : cameras()) {
    const glm::dvec3 anchor{98, 1, 33};
    const Camera nearer = zoom(camera, 1.7, anchor);
    expect_near(place_of(nearer, anchor).value(), place_of(camera, anchor).value());
    EXPECT_NEAR(glm::distance(nearer.position, nearer.target) * 1.7, glm::distance(camera.position, camera.target),
                1e-9);
    EXPECT_NEAR(nearer.height_mm * 1.7, camera.height_mm, 1e-9);
  }
}

TEST(Zoom, NeverLeavesReach) {
  const Model model = box_model();
  for (Camera camera : cameras()) {
    for (int i = 0; i < 100; ++i) camera = within_reach(zoom(camera, 2, camera.target), model);
    EXPECT_NO_THROW(validate(camera, "in"));
    EXPECT_GT(glm::distance(camera.position, camera.target), 1e-3 * model.radius_mm);
    for (int i = 0; i < 100; ++i) camera = within_reach(zoom(camera, 0.5, {1e3, 0, 0}), model);
    EXPECT_NO_THROW(validate(camera, "out"));
    EXPECT_LT(glm::distance(camera.position, model.bounds_mm.centre()), 100 * model.radius_mm);
  }
}

TEST(Projection, TheTargetKeepsItsSize) {
  for (const Camera& camera : cameras()) {
    const auto other = camera.projection == Camera::Projection::parallel ? Camera::Projection::perspective
                                                                         : Camera::Projection::parallel;
    const Camera changed = with_projection(camera, other);
    EXPECT_NEAR(half_height_at(changed, depth_of(changed, changed.target)),
                half_height_at(camera, depth_of(camera, camera.target)), 1e-9);
    expect_near(axes_of(with_projection(changed, camera.projection)).towards_eye, axes_of(camera).towards_eye);
  }
}

TEST(Centred, ThePivotComesToTheMiddle) {
  for (const Camera& camera : cameras()) {
    const glm::dvec3 pivot{104, 3, 31};
    const Camera centred = centred_on(camera, pivot);
    expect_near(place_of(centred, pivot).value(), {0, 0}, 1e-8);
    expect_near(axes_of(centred).towards_eye, axes_of(camera).towards_eye, 1e-8);
    expect_near(centred.target, pivot);
  }
}

TEST(Fit, HoldsEveryVertexAlongAnyLineOfSight) {
  const Model model = box_model();
  for (const Camera& camera : cameras())
    for (const double aspect : {0.5, 1.0, 2.1}) {
      const Camera fitted = fit(camera, model, aspect);
      double fullest = 0;
      for (const glm::vec3& position : model.parts[0].positions) {
        const glm::dvec2 place = place_of(fitted, model.origin_mm + glm::dvec3(position) / metres_per_mm).value();
        EXPECT_LE(std::abs(place.x), aspect);
        EXPECT_LE(std::abs(place.y), 1);
        fullest = std::max({fullest, std::abs(place.x) / aspect, std::abs(place.y)});
      }
      EXPECT_GT(fullest, 0.85);
    }
}

}  // namespace
}  // namespace odontoscope
