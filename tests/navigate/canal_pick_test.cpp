// Canals pointed at from outside: through walls that let light through, in sections, and just beside.

#include "engine/navigate/canal_pick.h"

#include <gtest/gtest.h>

#include "tests/render/shapes.h"

namespace odontoscope::test {
namespace {

using testing_support::ball;

CentreLine straight(const std::string& name, const Point3& from, const Point3& to, std::size_t orifice) {
  CentreLine line;
  line.name = name;
  constexpr int count = 11;
  for (int i = 0; i < count; ++i) {
    const double part = i / (count - 1.0);
    line.points.push_back(
        {{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y), from.z + part * (to.z - from.z)},
         0.2,
         part * 3});
  }
  line.orifice = orifice;
  line.end = to;
  return line;
}

/// Two balls far apart along y, each a void; in the nearer one two canals from its middle: down, and to the right.
FlightSpaces two_voids() {
  FlightSpaces spaces;
  FlightSpace& near = spaces.cavities.emplace_back();
  near.walls = Walls(ball({{0, 0, 0}, 2}));
  near.lines.canals = {straight("down", {0, 0, 0}, {0, 0, -1.8}, 5), straight("right", {0, 0, 0}, {1.8, 0, 0}, 5)};
  FlightSpace& far = spaces.cavities.emplace_back();
  far.walls = Walls(ball({{0, -10, 0}, 4}));
  far.lines.canals = {straight("behind", {0, -10, 0}, {0, -10, -3.8}, 0)};
  return spaces;
}

const FlightSpaces& spaces() {
  static const FlightSpaces made = two_voids();
  return made;
}

/// From y = 20 towards -y.
SightLine along_y(double x, double z) { return {{x, 20, z}, {0, -1, 0}}; }

TEST(CanalPick, TakesTheNearestLineInTheFirstVoid) {
  const auto down = pick_canal(spaces(), along_y(0.2, -1.5));
  ASSERT_TRUE(down);
  EXPECT_EQ(down->cavity, 0u);
  EXPECT_EQ(down->line, 0u);
  EXPECT_FALSE(down->in_chamber);
  EXPECT_NEAR(down->at.z, -1.5, 1e-9);
  const auto right = pick_canal(spaces(), along_y(1.5, -0.3));
  ASSERT_TRUE(right);
  EXPECT_EQ(right->line, 1u);
  EXPECT_NEAR(right->at.x, 1.5, 1e-9);
  const auto chamber = pick_canal(spaces(), along_y(0.1, -0.4));
  ASSERT_TRUE(chamber);
  EXPECT_TRUE(chamber->in_chamber);
  EXPECT_EQ(pick_canal(spaces(), along_y(0, -3))->cavity, 1u) << "past the first void into the second";
  EXPECT_FALSE(pick_canal(spaces(), along_y(0, -5)));
}

TEST(CanalPick, WhatIsOpaqueHides) {
  EXPECT_FALSE(pick_canal(spaces(), along_y(0, -1.5), {.sight_mm = 10}));
  EXPECT_TRUE(pick_canal(spaces(), along_y(0, -1.5), {.sight_mm = 20}));
  const double wall = spaces().cavities[0].walls.free_distance({0.2, 20, -1.5}, {0, -1, 0});
  EXPECT_TRUE(pick_canal(spaces(), along_y(0.2, -1.5), {.sight_mm = wall})) << "the void's own wall does not";
}

TEST(CanalPick, AMissByTheSlackIsNone) {
  FlightSpaces thin = two_voids();
  thin.cavities.resize(1);
  thin.cavities[0].lines.canals = {
      straight("outside its walls", {0, 0, -3}, {0, 0, -6}, 0)};  // so that only the slack can find it
  EXPECT_TRUE(pick_canal(thin, along_y(0.19, -4)));
  EXPECT_FALSE(pick_canal(thin, along_y(0.25, -4)));
  EXPECT_TRUE(pick_canal(thin, along_y(0.25, -4), {.slack_mm = 0.1}));
  EXPECT_FALSE(pick_canal(thin, along_y(0.25, -4), {.sight_mm = 15, .slack_mm = 0.1}));
}

TEST(CanalPick, WhatASectionCutAwayIsNotThere) {
  const Section from_above{{0, 0, -1}, {0, 0, 1}}, towards_eye{{0, 0.5, 0}, {0, 1, 0}},
      all_of_it{{0, -3, 0}, {0, 1, 0}};
  EXPECT_TRUE(pick_canal(spaces(), along_y(0.1, -1.5), {.section = from_above}));
  EXPECT_NE(pick_canal(spaces(), along_y(1.5, -0.3), {.section = from_above}).value_or(CanalPick{9}).cavity, 0u);
  EXPECT_TRUE(pick_canal(spaces(), along_y(0.1, -1.5), {.sight_mm = 19.5, .section = towards_eye}))
      << "the cut is opaque, but the void is open there";
  EXPECT_EQ(pick_canal(spaces(), along_y(0.1, -1.5), {.section = all_of_it})->cavity, 1u);
}

TEST(CanalPick, NothingIsPickedWhereThereAreNoLines) {
  FlightSpaces bare = two_voids();
  for (FlightSpace& space : bare.cavities) space.lines = {};
  EXPECT_FALSE(pick_canal(bare, along_y(0, 0)));
  EXPECT_FALSE(pick_canal(FlightSpaces{}, along_y(0, 0)));
}

}  // namespace
}  // namespace odontoscope::test
