// A surface cut by planes, above all by those in which vertices, edges and faces lie.

#include "recon/mesh/plane_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/core/polygon.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

std::vector<std::uint32_t> crossing(const SurfaceMesh& mesh, double height, Side side) {
  std::vector<std::uint32_t> crossed;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    int above = 0;
    for (const PointIndex v : mesh.triangles[t]) above += lies_above(mesh.points[v], height, side);
    if (above != 0 && above != 3) crossed.push_back(t);
  }
  return crossed;
}

/// The loops of both ways of joining, and the segments: one section told three times.
void expect_one_section(const SurfaceMesh& mesh, double height, Side side, double area, std::size_t loops) {
  const std::vector<Polygon> rings = section_loops(mesh, height, side);
  EXPECT_EQ(rings.size(), loops);
  double by_loops = 0, by_traces = 0, by_segments = 0;
  for (const Polygon& ring : rings) by_loops -= signed_area(ring);
  const EdgeMates mates = edge_mates(mesh);
  const std::vector<SectionTrace> traces = section_traces(mesh, mates, crossing(mesh, height, side), height, side);
  EXPECT_EQ(traces.size(), loops);
  for (const SectionTrace& trace : traces) {
    EXPECT_TRUE(trace.closed);
    Polygon ring;
    for (const HalfEdge edge : trace.edges) ring.push_back(crossing_point(mesh, edge, height));
    by_traces += signed_area(ring);
  }
  const PlaneSection both = sections(mesh, {height})[0];
  for (const SectionSegment& s : side == Side::below ? both.below : both.above) {
    // Loose segments have no order: each is turned so that the middle of the shape, (0.5, 0.5), lies on its left.
    by_segments += std::abs((s.from.x - 0.5) * (s.to.y - 0.5) - (s.to.x - 0.5) * (s.from.y - 0.5)) / 2;
  }
  EXPECT_NEAR(by_loops, area, 1e-12);
  EXPECT_NEAR(by_traces, area, 1e-12);
  EXPECT_NEAR(by_segments, area, 1e-12);
}

TEST(PlaneSection, VerticesInThePlaneAreTreatedAlikeInEveryForm) {
  const SurfaceMesh cube = shapes::cube();
  expect_one_section(cube, 0.5, Side::below, 1, 1);
  expect_one_section(cube, 0.5, Side::above, 1, 1);
  expect_one_section(cube, 0, Side::below, 0, 0);  // its bottom: there is nothing below
  expect_one_section(cube, 0, Side::above, 1, 1);
  expect_one_section(cube, 1, Side::below, 1, 1);
  expect_one_section(cube, 1, Side::above, 0, 0);
}

TEST(PlaneSection, ThroughVerticesPointsAreThoseVertices) {
  SurfaceMesh octahedron = shapes::sphere(1, 0);
  for (Point3& p : octahedron.points) p = {p.x + 0.1, p.y + 0.7, p.z + 0.3};
  for (const Side side : {Side::below, Side::above}) {
    const std::vector<Polygon> rings = section_loops(octahedron, 0.3, side);
    ASSERT_EQ(rings.size(), 1u);
    for (const Point2& p : rings[0]) {
      EXPECT_TRUE(std::any_of(octahedron.points.begin(), octahedron.points.end(),
                              [&](const Point3& v) { return v.z == 0.3 && v.x == p.x && v.y == p.y; }));
    }
    EXPECT_NEAR(signed_area(rings[0]), -2, 1e-12);
  }
}

TEST(PlaneSection, ATipThatTouchesThePlaneIsNoSection) {
  const SurfaceMesh octahedron = shapes::sphere(1, 0);
  EXPECT_TRUE(section_loops(octahedron, 1, Side::above).empty());
  EXPECT_TRUE(section_loops(octahedron, -1, Side::below).empty());
  const std::vector<Polygon> tip = section_loops(octahedron, 1, Side::below);  // just below it: a loop of one place
  ASSERT_EQ(tip.size(), 1u);
  for (const Point2& p : tip[0]) EXPECT_EQ(p, (Point2{0, 0}));
  EXPECT_TRUE(sections(octahedron, {1})[0].below.empty());
}

TEST(PlaneSection, CrossingIsTheSameFromEitherEnd) {
  const Point3 a{0.1, 0.2, 0.3}, b{7, -3, 1.1};
  for (const double height : {0.3, 0.31, 0.7, 1.1})
    EXPECT_EQ(crossing_point(a, b, height), crossing_point(b, a, height));
  for (int i = 1; i < 100; ++i) {  // numbers that rounding would change on the way
    const Point3 low{0.1 * i, 1.0 / i, 0}, high{i / 7.0, -3.3 / i, 1};
    EXPECT_EQ(crossing_point(low, high, 0), (Point2{low.x, low.y}));
    EXPECT_EQ(crossing_point(low, high, 1), (Point2{high.x, high.y}));
  }
}

TEST(PlaneSection, OfAnOpenSurfaceTracesAreOpen) {
  const SurfaceMesh open = shapes::holed(shapes::sphere(1, 2), 5);
  const EdgeMates mates = edge_mates(open);
  bool seen_open = false;
  for (double height = -0.95; height < 1; height += 0.1)
    for (const SectionTrace& trace :
         section_traces(open, mates, crossing(open, height, Side::below), height, Side::below))
      seen_open = seen_open || !trace.closed;
  EXPECT_TRUE(seen_open);
}

}  // namespace
}  // namespace odontoscope
