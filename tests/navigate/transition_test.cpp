#include "engine/navigate/transition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/navigate/screen.h"

namespace odontoscope {
namespace {

Camera looking_from(const glm::dvec3& side, const glm::dvec3& up, double distance) {
  Camera camera;
  camera.target = {1, 2, 3};
  camera.position = camera.target + distance * side;
  camera.up = up;
  return camera;
}

const Camera buccal = looking_from({0, 1, 0}, {0, 0, 1}, 40), lingual = looking_from({0, -1, 0}, {0, 0, 1}, 50),
             occlusal = looking_from({0, 0, 1}, {0, -1, 0}, 10);

TEST(Transition, EndsExactlyAtItsGoal) {
  for (const Camera& goal : {lingual, occlusal}) {
    Transition transition(buccal, goal);
    Camera camera;
    for (int i = 0; i < 100 && !transition.over(); ++i) camera = transition.advance(0.016);
    EXPECT_TRUE(transition.over());
    EXPECT_EQ(camera, goal);
  }
}

TEST(Transition, GoesRoundTheTargetAndNotThroughIt) {
  for (int i = 1; i < 50; ++i) {
    const Camera camera = between(buccal, lingual, i / 50.0);
    EXPECT_NO_THROW(validate(camera, "between"));
    const double distance = glm::distance(camera.position, camera.target);
    EXPECT_GE(distance, 40 - 1e-9);
    EXPECT_LE(distance, 50 + 1e-9);
  }
}

TEST(Transition, IsSmooth) {
  // No step turns the eye by more than three times its share of the way.
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 a = axes_of(between(buccal, occlusal, i / 100.0)).towards_eye, b = axes_of(between(buccal, occlusal, (i + 1) / 100.0)).towards_eye;
    EXPECT_LT(std::acos(std::min(1.0, glm::dot(a, b))), 3 * std::acos(0.0) / 100);
  }
}

TEST(Transition, ChangesTheProjectionWithoutAJump) {
  Camera parallel = occlusal;
  parallel.projection = Camera::Projection::parallel;
  const Camera first = between(buccal, parallel, 0);
  EXPECT_NEAR(half_height_at(first, 1), half_height_at(buccal, 40), 1e-9);
}

}  // namespace
}  // namespace odontoscope
