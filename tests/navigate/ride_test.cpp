// Rides: on the line, as fast as the canal is wide, without roll; and labels that walls hide.

#include "engine/navigate/ride.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/navigate/labels.h"
#include "engine/navigate/tour.h"
#include "tests/navigate/cavities.h"
#include "tests/render/shapes.h"

namespace odontoscope::test {
namespace {

/// A quarter of a circle of radius 10 in the x-z plane, narrowing from 1 to 0.5.
CentreLine bent() {
  CentreLine line;
  line.name = "canal 1";
  constexpr int count = 101;
  for (int i = 0; i < count; ++i) {
    const double part = i / (count - 1.0), angle = part * std::numbers::pi / 2;
    line.points.push_back({{10 * std::cos(angle), 0, -10 * std::sin(angle)}, 1 - 0.5 * part, 10 * angle});
  }
  line.orifice = 20;
  line.end = {-0.5, 0, -10};
  return line;
}

TEST(Ride, FollowsTheLineAndLooksAlongIt) {
  const Track track = track_of(bent(), 0.1);
  ASSERT_GT(track.points.size(), 100u);
  EXPECT_NEAR(track.orifice, 2 * std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(track.end, 5 * std::numbers::pi + 0.5, 1e-3);
  glm::dvec3 before = flight_on(track, 0).up;
  for (double along = 0; along < 15.5; along += 0.37) {
    const Flight eye = flight_on(track, along);
    EXPECT_NEAR(std::hypot(eye.eye.x, eye.eye.z), 10, 0.01);
    const glm::dvec3 tangent(-std::sin(along / 10), 0, -std::cos(along / 10));
    EXPECT_GT(glm::dot(eye.view_direction, tangent), 0.96);
    EXPECT_NEAR(glm::dot(eye.view_direction, eye.up), 0, 1e-12);
    EXPECT_NEAR(eye.up.y, 1, 1e-9) << "a plane bend makes no roll";
    EXPECT_GT(glm::dot(eye.up, before), 0.97);
    before = eye.up;
  }
}

TEST(Ride, LeavesOutWhatTheBallDoesNotFitThrough) {
  const Track track = track_of(bent(), 0.7);
  ASSERT_FALSE(track.points.empty());
  EXPECT_GE(track.points.back().radius, 0.7);
  EXPECT_LT(track.points.back().along, 10);
  EXPECT_TRUE(track_of(bent(), 2).points.empty());
}

TEST(Ride, ALineThroughACrackOfNoWidthHasNoTrack) {
  CentreLine line = bent();
  for (CentrePoint& point : line.points) point.radius = 0;
  EXPECT_TRUE(track_of(line, 0.1).points.empty());
}

TEST(Ride, IsTheTourAndTheSameAtEveryFrameRate) {
  const FlightRules rules = rules_for(10);
  const auto ridden = [&](double hertz) {
    Ride ride{.line = 0, .track = track_of(bent(), 0.1), .playing = true};
    for (int i = 0; i < static_cast<int>(3 * hertz); ++i) advance(ride, rules, 1 / hertz);
    return ride.along;
  };
  // Late by the time in which it starts.
  EXPECT_NEAR(ridden(60), Tour(bent()).at(3 - rules.settle_seconds).along, 0.01);
  EXPECT_NEAR(ridden(10), ridden(60), 1e-3 * ridden(60));
  EXPECT_NEAR(ridden(1000), ridden(60), 1e-3 * ridden(60));
}

TEST(Ride, StopsAtItsEndsAndGoesBack) {
  const FlightRules rules = rules_for(10);
  Ride ride{.line = 0, .track = track_of(bent(), 0.1), .playing = true};
  for (int i = 0; i < 6000 && ride.playing; ++i) advance(ride, rules, 1.0 / 60);
  EXPECT_FALSE(ride.playing);
  EXPECT_DOUBLE_EQ(ride.along, ride.track.points.back().along);
  ride.back = ride.playing = true;
  for (int i = 0; i < 6000 && ride.playing; ++i) advance(ride, rules, 1.0 / 60);
  EXPECT_FALSE(ride.playing);
  EXPECT_DOUBLE_EQ(ride.along, ride.track.points.front().along);
  EXPECT_EQ(ride.pace, 0);
}

TEST(Ride, TheHandLooksAroundOnTheWay) {
  Ride ride{.line = 0, .track = track_of(bent(), 0.1), .along = 5};
  ride.look = {0.5, 0};
  const Flight straight = flight_on(ride.track, 5), aside = flight_of(ride, {});
  EXPECT_EQ(aside.eye, straight.eye);
  EXPECT_NEAR(std::acos(glm::dot(aside.view_direction, straight.view_direction)), 0.5, 1e-9);
  EXPECT_NEAR(glm::dot(aside.up, straight.up), 1, 1e-12);
}

TEST(CanalPlace, TellsDepthWidthAndWhatIsLeft) {
  CentreLines lines;
  lines.canals.push_back(bent());
  const double angle = 0.7;
  const auto place = canal_place(lines, glm::dvec3(10.2 * std::cos(angle), 0, -10.2 * std::sin(angle)));
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->along, 7, 0.01);
  EXPECT_NEAR(place->depth, 7 - std::numbers::pi, 0.01);
  EXPECT_NEAR(place->width, 2 * (1 - 0.5 * angle / (std::numbers::pi / 2)), 0.01);
  EXPECT_NEAR(place->to_end, 5 * std::numbers::pi + 0.5 - 7, 0.01);
  EXPECT_NEAR(place->off, 0.2, 0.01);
  EXPECT_FALSE(canal_place({}, {0, 0, 0}));
}

TEST(Ride, TheTeethsCanalsAreRiddenToWithinAVoxelOfTheirEndsAndNeverNearerThanStated) {
  std::vector<std::pair<const SurfaceMesh*, const SurfaceMesh*>> teeth{{&sample_molar_pulp(), &sample_molar_outside()}};
  if (ct_molar_pulp()) teeth.emplace_back(ct_molar_pulp(), ct_molar_outside());
  for (const auto& [pulp, outside] : teeth) {
    const Walls walls(*pulp), around(*outside);
    const double radius = 0.5 * glm::length(around.bounds().high - around.bounds().low), voxel = radius / 97;
    const FlightRules rules = rules_for(radius);
    const CentreLines lines = centre_lines(cavities_of("pulp", *pulp).at(0));
    EXPECT_EQ(lines.canals.size(), 3u);
    for (const CentreLine& canal : lines.canals) {
      const Track track = track_of(canal, rules.clearance);
      ASSERT_FALSE(track.points.empty()) << canal.name;
      EXPECT_LE(track.end - track.points.back().along, voxel) << canal.name;
      glm::dvec3 before = track.points.front().at;
      for (double along = track.points.front().along; along < track.points.back().along;
           along += 0.3 * rules.clearance) {
        const Flight eye = flight_on(track, along);
        ASSERT_GE(walls.nearest(eye.eye).distance, rules.clearance) << canal.name << " at " << along;
        ASSERT_FALSE(walls.crosses(before, eye.eye));
        before = eye.eye;
      }
      EXPECT_EQ(walls.locate(before), Walls::Side::inside);
    }
  }
}

TEST(Labels, HideBehindWallsAndBehindTheEye) {
  const Walls walls(testing_support::box({-1, -1, -1}, {1, 1, 1}));
  Camera camera;
  camera.position = {0, -5, 0};
  camera.target = {0, 0, 0};
  camera.field_of_view_deg = 60;
  const std::vector<FlightLabel> labels{{{0, -1, 0}, "on the near face", {}},
                                        {{0, 1, 0}, "on the far face", {}},
                                        {{0, -7, 0}, "behind the eye", {}},
                                        {{3, 2, 0}, "beside it, farther", {}},
                                        {{40, 0, 0}, "out of the picture", {}}};
  const auto seen = seen_labels(labels, camera, 1.5, walls, 0.05);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(labels[seen[0].label].words, "on the near face");
  EXPECT_EQ(labels[seen[1].label].words, "beside it, farther");
  EXPECT_LT(seen[0].distance, seen[1].distance);
}

}  // namespace
}  // namespace odontoscope::test
