#pragma once
// Visits by script, step by step at a headset's beat: what the fixtures of this folder begin with.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/headset/worlds.h"

namespace odontoscope::testing_support {

constexpr double tick = 1.0 / 90;

class Visiting : public ::testing::Test {
 protected:
  explicit Visiting(const VisitWorld& visited) : world(visited) {}

  const VisitWorld world;
  const ComfortRules rules;
  HeadsetInput input = person();
  Visit visit;

  void step(int times = 1, double seconds = tick) {
    for (int i = 0; i < times; ++i) visit = advance_visit(std::move(visit), input, world, rules, seconds);
  }
  void seconds(double time) { step(static_cast<int>(std::ceil(time / tick))); }
};

class VisitingBalls : public Visiting {
 protected:
  VisitingBalls() : Visiting(BallWorld::once().world()) {}

  const BallWorld& balls = BallWorld::once();
  glm::dvec3 centre() const { return to_room(visit.stage, balls.model.bounds_mm.centre()); }
};

class VisitingMolar : public Visiting {
 protected:
  VisitingMolar() : Visiting(MolarWorld::once().world()) {}

  const FlightSpace& cavity = world.cavities[0];
  double wall_metres() const { return cavity.walls.nearest(visit.eye_mm).distance / mm_per_metre(visit.stage); }
};

}  // namespace odontoscope::testing_support
