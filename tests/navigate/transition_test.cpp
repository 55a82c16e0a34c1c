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
    const glm::dvec3 a = axes_of(between(buccal, occlusal, i / 100.0)).towards_eye,
                     b = axes_of(between(buccal, occlusal, (i + 1) / 100.0)).towards_eye;
    EXPECT_LT(std::acos(std::min(1.0, glm::dot(a, b))), 3 * std::acos(0.0) / 100);
  }
}

TEST(Transition, ChangesTheProjectionWithoutAJump) {
  Camera parallel = occlusal;
  parallel.projection = Camera::Projection::parallel;
  const Camera first = between(buccal, parallel, 0);
  EXPECT_NEAR(half_height_at(first, 1), half_height_at(buccal, 40), 1e-9);
}

Model ten_mm_wide() {
  Model model;
  model.bounds_mm = {{-5, -5, -5}, {5, 5, 5}};
  model.radius_mm = 5 * std::sqrt(3.0);
  return model;
}

TEST(LookTransition, FadesStructuresAndMovesTheSection) {
  Scene from, to;
  from.looks = {{"enamel", colour_of(0x000000), 1},
                {"pulp", colour_of(0xff0000), 1},
                {"dentine", colour_of(0xffffff), 0.5f, false}};
  to.looks = {{"enamel", colour_of(0xffffff), 0.2f},
              {"pulp", colour_of(0xff0000), 1, false},
              {"dentine", colour_of(0xffffff), 0.5f}};
  to.section = Section{{0, 1, 0}, {0, 2, 0}};
  const Model model = ten_mm_wide();
  const Scene half = looks_between(from, to, 0.5, model);
  EXPECT_FLOAT_EQ(half.look_of("enamel")->opacity, 0.6f);
  EXPECT_FLOAT_EQ(half.look_of("enamel")->colour.red, 0.5f * to.looks[0].colour.red);
  EXPECT_TRUE(half.look_of("pulp")->visible);
  EXPECT_FLOAT_EQ(half.look_of("pulp")->opacity, 0.5f);
  EXPECT_FLOAT_EQ(half.look_of("dentine")->opacity, 0.25f);
  double before = 0.98 * model.radius_mm + 1e-9;
  for (int i = 0; i < 50; ++i) {
    const double offset = looks_between(from, to, i / 50.0, model).section->point_mm.y;
    EXPECT_LE(offset, before);
    EXPECT_LT(before - offset, 0.25);
    before = offset;
  }
  EXPECT_EQ(looks_between(from, to, 1, model), to);
  EXPECT_EQ(looks_between(to, from, 1, model), from) << "the section is gone";
  Scene turned = to;
  turned.section->normal = {0, -1, 0};
  EXPECT_EQ(looks_between(to, turned, 0.5, model).section, turned.section)
      << "opposite planes: no way between is the right one";
}

TEST(LookTransition, EndsExactlyAtItsGoalUnderTheCameraOfTheMoment) {
  Scene goal;
  goal.wire = true;
  LookTransition transition(Scene{}, goal);
  Scene scene;
  for (int i = 0; i < 100 && !transition.over(); ++i) scene = transition.advance(0.016, lingual, ten_mm_wide());
  EXPECT_TRUE(transition.over());
  goal.camera = lingual;
  EXPECT_EQ(scene, goal);
}

}  // namespace
}  // namespace odontoscope
