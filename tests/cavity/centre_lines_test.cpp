// Centre lines of voids whose lines are known.

#include "recon/cavity/centre_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/core/error.h"
#include "recon/mesh/vector.h"
#include "tests/cavity/voids.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

constexpr double percent = 0.01;

/// From the start to the wall at the end.
double whole_length(const CentreLine& line) {
  return line.points.back().along + length(line.end - line.points.back().at);
}

/// Of a tube from wall to wall: its first point lies on the way from the ball before it to the wall.
double length_of_tube(const CentreLine& line) { return line.points.front().radius + whole_length(line); }

/// Off the ends: where the wall ahead is farther than that beside.
bool in_the_middle(const CentreLine& line, const CentrePoint& p, double radius) {
  return length(line.end - p.at) > 1.5 * radius && length(line.points.front().at - p.at) > 1.5 * radius;
}

void expect_sound(const CentreLine& line) {
  ASSERT_GE(line.points.size(), 2u);
  double along = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    along += length(line.points[i].at - line.points[i - 1].at);
    EXPECT_NEAR(line.points[i].along, along, 1e-9);
    EXPECT_GT(line.points[i].radius, 0);
    // Within the balls at its ends, so within the void.
    EXPECT_LE(length(line.points[i].at - line.points[i - 1].at), line.points[i].radius + line.points[i - 1].radius);
  }
}

TEST(CentreLines, OfAStraightTubeRunFromTopToEnd) {
  const double tube = 10, radius = 0.5;
  const CentreLines lines = centre_lines(test::straight_tube(tube, radius));
  EXPECT_FALSE(lines.has_chamber);
  ASSERT_EQ(lines.canals.size(), 1u);
  EXPECT_TRUE(lines.horns.empty() && lines.others.empty() && lines.loops.empty());
  const CentreLine& line = lines.canals[0];
  expect_sound(line);
  EXPECT_EQ(line.name, "canal 1");
  EXPECT_NEAR(line.points.front().at.z + line.points.front().radius, radius, percent * tube);
  EXPECT_NEAR(line.end.z, -tube - radius, percent * tube);
  EXPECT_NEAR(length_of_tube(line), tube + 2 * radius, percent * tube);
  for (const CentrePoint& p : line.points) {
    EXPECT_LT(std::hypot(p.at.x, p.at.y), 2 * percent * radius);
    if (in_the_middle(line, p, radius)) {
      EXPECT_NEAR(p.radius, radius, percent * radius);
    }
  }
}

TEST(CentreLines, OfABentTubeFollowTheBend) {
  const double bend = 4, angle = 2, radius = 0.5;
  const CentreLines lines = centre_lines(test::bent_tube(bend, angle, radius));
  ASSERT_EQ(lines.canals.size(), 1u);
  const CentreLine& line = lines.canals[0];
  expect_sound(line);
  EXPECT_NEAR(length_of_tube(line), bend * angle + 2 * radius, percent * bend * angle);
  for (const CentrePoint& p : line.points) {
    if (!in_the_middle(line, p, radius)) continue;
    EXPECT_NEAR(p.radius, radius, percent * radius);
    EXPECT_NEAR(std::hypot(p.at.x, p.at.z), bend, percent * bend);
  }
}

TEST(CentreLines, OfATorusIsALoop) {
  const double bend = 3, radius = 0.6;
  const CentreLines lines = centre_lines(test::ring(bend, radius));
  EXPECT_TRUE(lines.canals.empty() && lines.horns.empty() && lines.others.empty());
  ASSERT_EQ(lines.loops.size(), 1u);
  const CentreLine& loop = lines.loops[0];
  expect_sound(loop);
  EXPECT_EQ(loop.points.front().at, loop.points.back().at);
  EXPECT_NEAR(loop.points.back().along, 2 * std::numbers::pi * bend, percent * 2 * std::numbers::pi * bend);
  for (const CentrePoint& p : loop.points) {
    EXPECT_NEAR(p.radius, radius, percent * radius);
    EXPECT_NEAR(std::hypot(p.at.x, p.at.y), bend, percent * bend);
  }
}

TEST(CentreLines, OfAYLeadFromTheForkToEachEnd) {
  const double leg = 6, radius = 0.5;
  const CentreLines lines = centre_lines(test::y_shape(leg, radius), {.axis = std::nullopt});
  ASSERT_EQ(lines.canals.size(), 3u);
  EXPECT_TRUE(lines.horns.empty() && lines.others.empty() && lines.loops.empty());
  EXPECT_NEAR(length(lines.chamber - Point3{}), 0, 0.1 * radius);
  for (const CentreLine& line : lines.canals) {
    expect_sound(line);
    EXPECT_EQ(line.points.front().at, lines.chamber);
    EXPECT_NEAR(whole_length(line), leg + radius, percent * leg);
    EXPECT_NEAR(length(line.end - Point3{}), leg + radius, percent * leg);
    for (const CentrePoint& p : line.points)
      if (in_the_middle(line, p, 1.5 * radius)) {
        EXPECT_NEAR(p.radius, radius, percent * radius);
      }
  }
  // Seen along z, the leg that goes up is a horn.
  const CentreLines upright = centre_lines(test::y_shape(leg, radius));
  EXPECT_EQ(upright.canals.size() + upright.horns.size(), 3u);
  EXPECT_EQ(upright.horns.size() == 1, upright.canals.size() == 2);
}

TEST(CentreLines, OfAChamberWithThreeCanalsKnowEachOne) {
  const test::ThreeCanals shape;
  const CentreLines lines = centre_lines(test::three_canals(shape));
  EXPECT_TRUE(lines.has_chamber);
  EXPECT_NEAR(length(lines.chamber - Point3{}), 0, 0.2 * shape.chamber);
  EXPECT_NEAR(lines.chamber_radius, shape.chamber, 0.05 * shape.chamber);
  ASSERT_EQ(lines.canals.size(), 3u);
  EXPECT_TRUE(lines.horns.empty() && lines.others.empty() && lines.loops.empty());
  for (std::size_t i = 0; i < 3; ++i) {  // the shape has its longest first, too
    const CentreLine& line = lines.canals[i];
    expect_sound(line);
    const double radius = shape.radii[i], far = length(shape.ends[i] - Point3{}),
                 leaves = std::sqrt(shape.chamber * shape.chamber - radius * radius);
    EXPECT_NEAR(length(line.end - Point3{}), far + radius, percent * far);
    const double canal = whole_length(line) - line.points[line.orifice].along;
    EXPECT_NEAR(length(line.points[line.orifice].at - Point3{}), leaves, radius);
    EXPECT_NEAR(canal, far + radius - length(line.points[line.orifice].at - Point3{}), percent * far);
    for (std::size_t k = line.orifice; k < line.points.size(); ++k) {
      const CentrePoint& p = line.points[k];
      if (in_the_middle(line, p, radius) && p.along > line.points[line.orifice].along + radius) {
        EXPECT_NEAR(p.radius, radius, percent * radius);
      }
    }
  }
}

TEST(CentreLines, OfABallAreNone) {
  const CentreLines lines = centre_lines(voids_filled_by("ball", shapes::sphere(2, 4)).at(0));
  EXPECT_TRUE(lines.canals.empty() && lines.horns.empty() && lines.others.empty() && lines.loops.empty());
  EXPECT_NEAR(lines.chamber_radius, 2, percent * 2);
}

TEST(CentreLines, OfTheSmallestVoidDoNotCrash) {
  const CentreLines lines = centre_lines(voids_filled_by("tetrahedron", shapes::tetrahedron()).at(0));
  EXPECT_NEAR(lines.chamber_radius, 1 / (3 + std::sqrt(3.0)), 1e-3);  // the insphere of the corner of a unit cube
  for (const CentreLine& line : lines.canals) expect_sound(line);
}

TEST(CentreLines, AreRefusedForAnOpenWall) {
  EXPECT_THROW(centre_lines({"open", shapes::holed(shapes::inside_out(shapes::sphere(1, 2))), 1}), UsageError);
  EXPECT_THROW(centre_lines({"two", shapes::together(shapes::cube(), shapes::cube(3)), 2}), UsageError);
}

TEST(CentreLines, StopWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(centre_lines(test::straight_tube(5, 0.5), {}, {{}, source.get_token()}), Cancelled);
}

}  // namespace
}  // namespace odontoscope
