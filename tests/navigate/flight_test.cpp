// Flights: never through a wall, never nearer than stated, and the same at every frame rate.

#include "engine/navigate/flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/navigate/cavities.h"
#include "tests/render/shapes.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

using testing_support::ball;
using testing_support::box;

int from_environment(const char* name, int usual) {
  const char* text = std::getenv(name);
  return text && *text ? std::atoi(text) : usual;
}

Flight straight(double hertz, double seconds, const Walls& walls, const FlightRules& rules,
                const glm::dvec3& from = {0, 0, 0}) {
  Flight flight = looking(from, {1, 0, 0});
  for (int i = 0; i < static_cast<int>(std::lround(seconds * hertz)); ++i)
    flight = flight_after(flight, {{0, 0, 1}, {0.4, 0.1}}, walls, rules, 1 / hertz);
  return flight;
}

TEST(Flight, GoesTheSameWayAtEveryFrameRate) {
  const Walls walls(box({-50, -50, -50}, {50, 50, 50}));
  const FlightRules rules = rules_for(20);
  const Flight slow = straight(10, 1, walls, rules), usual = straight(60, 1, walls, rules),
               quick = straight(1000, 1, walls, rules);
  EXPECT_GT(glm::length(usual.eye), 20);
  EXPECT_LT(glm::length(slow.eye - usual.eye), 0.002 * glm::length(usual.eye));
  EXPECT_LT(glm::length(quick.eye - usual.eye), 0.01 * glm::length(usual.eye));
  EXPECT_LT(glm::degrees(std::acos(glm::dot(quick.view_direction, slow.view_direction))), 0.1);
}

TEST(Flight, StartsAndStopsSmoothly) {
  const Walls walls(box({-50, -50, -50}, {50, 50, 50}));
  const FlightRules rules = rules_for(20);
  Flight flight = looking({0, 0, 0}, {1, 0, 0});
  double before = 0;
  for (int i = 0; i < 15; ++i) {  // faster and faster
    flight = flight_after(flight, {{0, 0, 1}, {}}, walls, rules, 1.0 / 60);
    EXPECT_GT(glm::length(flight.velocity), before);
    before = glm::length(flight.velocity);
  }
  EXPECT_FALSE(resting(flight, rules));
  for (int i = 0; i < 120 && !resting(flight, rules); ++i) {
    flight = flight_after(flight, {}, walls, rules, 1.0 / 60);
    EXPECT_LT(glm::length(flight.velocity), before);
    before = glm::length(flight.velocity);
  }
  EXPECT_TRUE(resting(flight, rules));
}

TEST(Flight, IsSlowerWhereItIsNarrower) {
  const FlightRules rules = rules_for(20);
  const auto speed_in = [&](double half) {
    const Walls walls(box({-100, -half, -half}, {100, half, half}));
    Flight flight = looking({0, 0, 0}, {1, 0, 0});
    for (int i = 0; i < 60; ++i) flight = flight_after(flight, {{0, 0, 1}, {}}, walls, rules, 1.0 / 60);
    return glm::length(flight.velocity);
  };
  EXPECT_NEAR(speed_in(2) / speed_in(1), 2, 0.01);
  EXPECT_NEAR(speed_in(0.2), rules.least_speed, 0.01 * rules.least_speed);
}

TEST(Flight, SlidesAlongAWallInsteadOfStopping) {
  const Walls walls(box({-50, -2, -2}, {50, 2, 2}));
  const FlightRules rules = rules_for(10);
  Flight flight = looking({0, 0, 0}, glm::normalize(glm::dvec3(1, 1, 0)));
  for (int i = 0; i < 240; ++i) flight = flight_after(flight, {{0, 0, 1}, {}}, walls, rules, 1.0 / 60);
  EXPECT_NEAR(flight.eye.y, 2 - rules.clearance, 2e-3 * rules.clearance + 1e-9);
  EXPECT_GT(flight.eye.x, 1);
  EXPECT_NEAR(flight.velocity.y, 0, 1e-6);
}

TEST(Flight, StopsInACornerAtTheStatedDistance) {
  const Walls walls(box({-2, -2, -2}, {2, 2, 2}));
  const FlightRules rules = rules_for(10);
  Flight flight = looking({0, 0, 0}, glm::normalize(glm::dvec3(1, 1.1, 0.9)));
  for (int i = 0; i < 1200; ++i) flight = flight_after(flight, {{0, 0, 1}, {}}, walls, rules, 1.0 / 60);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(flight.eye[axis], 2 - rules.clearance, 0.1 * rules.clearance);
  EXPECT_GE(walls.nearest(flight.eye).distance, rules.clearance * (1 - 1e-12));
}

TEST(Flight, CannotTunnelHoweverFast) {
  const Walls walls(ball({{0, 0, 0}, 3}));
  for (const double length : {1.0, 100.0, 1e6, 1e15}) {
    const glm::dvec3 end = slide_along_walls({0.5, 0, 0}, glm::dvec3(0.3, -0.2, 0.9) * length, walls, 0.05);
    EXPECT_EQ(walls.locate(end), Walls::Side::inside);
    EXPECT_GE(walls.nearest(end).distance, 0.05);
  }
}

TEST(Flight, TurnsWithoutRollAndRightsItself) {
  const FlightRules rules;
  Flight flight = looking({0, 0, 0}, {1, 0, 0});
  for (int i = 0; i < 100; ++i) flight = turned(flight, {0.1, 0}, rules);
  EXPECT_NEAR(flight.up.z, 1, 1e-12);
  for (int i = 0; i < 40; ++i) flight = turned(flight, {0.05, 0.05}, rules);  // over the top and round
  for (int i = 0; i < 40; ++i) flight = turned(flight, {0.1, -0.02}, rules);
  EXPECT_NEAR(glm::length(flight.view_direction), 1, 1e-12);
  EXPECT_NEAR(glm::dot(flight.view_direction, flight.up), 0, 1e-12);
  const Flight down = looking({0, 0, 0}, {0, 0, -1});  // along the axis nothing rolls by itself
  const Flight after = turned(down, {0, 0.01}, rules);
  EXPECT_GT(glm::dot(after.up, down.up), 0.999);
}

TEST(Flight, TheNearPlanesCornersStayInTheFreeBall) {
  for (const double angle : {30.0, 70.0, 110.0})
    for (const double aspect : {0.5, 1.0, 2.4}) {
      const double near = safe_near_mm(0.03, angle, aspect), slope = std::tan(glm::radians(angle) / 2);
      EXPECT_LT(glm::length(glm::dvec3(near * slope * aspect, near * slope, near)), 0.03);
      EXPECT_GT(near, 0.003);
    }
}

// --- wild flights ----------------------------------------------------------------------------------------------------

/// What a person on a sugar rush holds: changes all the time, sometimes contradictory, sometimes far beyond what keys
/// can do.
FlightWish wild_wish(RandomNumbers& random) {
  const auto push = [&] { return random.chance(0.3) ? 0.0 : random.between(-1.5, 1.5); };
  return {{push(), push(), random.chance(0.5) ? 1.0 : push()}, {push(), push()}};
}

struct Told {
  std::size_t steps = 0;
  double nearest = 1e300;  // in clearances
  double longest_way = 0;
};

/// One of many: `number` names it for ever.
void fly_wildly(int number, const Walls& walls, const FlightRules& usual, const glm::dvec3& start, Told& told) {
  RandomNumbers random(0x0f11e5 + static_cast<std::uint64_t>(number));
  constexpr double rates[] = {10, 60, 1000};
  const double seconds = 1 / rates[number % 3];
  FlightRules rules = usual;
  rules.speed_factor = random.chance(0.3) ? random.between(5, 200) : random.between(0.3, 3);
  rules.settle_seconds = random.between(0.02, 0.5);
  Flight flight = looking(start, {random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)});
  const Walls::Side side = walls.locate(start);
  ASSERT_NE(side, Walls::Side::on_wall);
  FlightWish wish = wild_wish(random);
  for (int step = 0; step < 1000; ++step) {
    if (random.chance(0.08)) wish = wild_wish(random);
    if (random.chance(0.05)) flight = turned(flight, {random.between(-3, 3), random.between(-3, 3)}, rules);
    const glm::dvec3 before = flight.eye;
    flight = flight_after(flight, wish, walls, rules, seconds);
    const double distance = walls.nearest(flight.eye).distance;
    ASSERT_GE(distance, rules.clearance * (1 - 1e-9)) << "flight " << number << ", step " << step;
    ASSERT_EQ(walls.locate(flight.eye), side) << "flight " << number << ", step " << step;
    told.nearest = std::min(told.nearest, distance / rules.clearance);
    told.longest_way += glm::length(flight.eye - before);
    ++told.steps;
  }
}

void fly_many(const char* name, const SurfaceMesh& surface, double radius, const glm::dvec3* start, int flights) {
  const Walls walls(surface);
  const FlightRules rules = rules_for(radius);
  const auto roomiest = start ? std::nullopt : place_of_largest_clearance(walls);
  ASSERT_TRUE(start || roomiest);
  Told told;
  for (int number = 0; number < flights && !testing::Test::HasFatalFailure(); ++number)
    fly_wildly(number, walls, rules, start ? *start : roomiest->at, told);
  std::printf("%s: %d flights, %zu steps, never nearer than %.6f of the stated %.4f; %.0f of its lengths flown\n", name,
              flights, told.steps, told.nearest, rules.clearance, told.longest_way / (2 * radius));
  EXPECT_GE(told.nearest, 1 - 1e-9);
  EXPECT_LT(told.nearest, 1.1) << "none ever came to a wall: nothing was tried";
}

double radius_of(const SurfaceMesh& mesh) {
  const Walls walls(mesh);
  return 0.5 * glm::length(walls.bounds().high - walls.bounds().low);
}

/// ODONTOSCOPE_RANDOM_FLIGHTS says how many in all (issue: 10,000); a share else.
int wild_flights(int usual) { return from_environment("ODONTOSCOPE_RANDOM_FLIGHTS", usual); }

TEST(WildFlights, NeverLeaveTheSampleMolarsPulp) {
  fly_many("sample pulp", sample_molar_pulp(), radius_of(sample_molar_outside()), nullptr, wild_flights(60));
}

TEST(WildFlights, NeverLeaveTheCtMolarsPulp) {
  if (!ct_molar_pulp()) GTEST_SKIP() << "the CT molar is not there; set the CMake variable ODONTOSCOPE_DATA";
  fly_many("CT pulp", *ct_molar_pulp(), radius_of(*ct_molar_outside()), nullptr, wild_flights(60));
}

TEST(WildFlights, NeverEnterTheSampleMolarFromOutside) {
  const SurfaceMesh& outside = sample_molar_outside();
  const Walls walls(outside);
  const glm::dvec3 start =
      walls.bounds().centre() + glm::dvec3(0, 0.55, 0.1) * (walls.bounds().high - walls.bounds().low);
  fly_many("sample outside", outside, radius_of(outside), &start, wild_flights(30));
}

TEST(WildFlights, NeverLeaveABoxOfFlatWallsAndSharpCorners) {
  const glm::dvec3 start(0.1, 0.2, 0.3);
  fly_many("box", box({-1, -1, -1}, {1, 1, 1}), 8, &start, wild_flights(30));
}

}  // namespace
}  // namespace odontoscope::test
