// Roots whose canals part and join as Vertucci's types have them, with lengths and widths that are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "recon/cavity/anatomy.h"
#include "recon/mesh/vector.h"
#include "tests/cavity/voids.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

constexpr double percent = 0.01;

/// From the chamber's centre to the wall at the end.
double length_of(const std::vector<Point3>& axis, double radius) {
  double sum = radius;
  for (std::size_t i = 1; i < axis.size(); ++i) sum += length(axis[i] - axis[i - 1]);
  return sum;
}

/// More than a width away from chamber and end, and from where canals part or join, which is in the middle.
bool in_one_tube(const CentreLine& line, const CentrePoint& p, const test::RootShape& shape) {
  const double width = 2 * shape.radius;
  const bool meets = shape.canals.size() > 1 && std::abs(p.at.x) < width / 2 &&
                     std::any_of(shape.canals[0].begin(), shape.canals[0].end(), [&](const Point3& corner) {
                       return corner.x == 0 && std::abs(p.at.z - corner.z) < 2 * width;
                     });
  return !meets && length(p.at - Point3{}) > shape.chamber + width && length(line.end - p.at) > width;
}

/// Parts of each type, how many nodes of each kind, and that the parts of each canal make it up.
void expect_graph(const Anatomy& made, const test::RootShape& shape) {
  struct Known {
    std::size_t parts, ends, forks, joins;
  };
  static const std::map<std::string, Known> types = {
      {"I", {1, 1, 0, 0}}, {"II", {3, 1, 0, 1}}, {"III", {4, 1, 1, 1}}, {"IV", {2, 2, 0, 0}},
      {"V", {3, 2, 1, 0}}, {"VI", {5, 2, 1, 1}}, {"VII", {6, 2, 2, 1}}, {"VIII", {3, 3, 0, 0}}};
  const Known& known = types.at(shape.type);
  EXPECT_EQ(made.graph.parts.size(), known.parts);
  std::map<std::string, std::size_t> kinds;
  for (std::size_t node = 0; node < made.graph.nodes.size(); ++node) ++kinds[made.graph.kind(node)];
  EXPECT_EQ(kinds["chamber"], 1u);
  EXPECT_EQ(kinds["end"], known.ends);
  EXPECT_EQ(kinds["fork"], known.forks);
  EXPECT_EQ(kinds["join"], known.joins);
  EXPECT_EQ(kinds["crossing"], 0u);
  ASSERT_EQ(made.parts.size(), made.graph.parts.size());
  for (std::size_t c = 0; c < made.canals.size(); ++c) {
    double sum = 0;
    for (std::size_t p = 0; p < made.parts.size(); ++p) {
      const std::vector<std::size_t>& canals = made.graph.parts[p].canals;
      if (std::find(canals.begin(), canals.end(), c) != canals.end()) sum += made.parts[p].length;
    }
    EXPECT_NEAR(sum, made.canals[c].length, 2 * percent * made.canals[c].length) << made.canals[c].name;
  }
}

class RootTypes : public ::testing::TestWithParam<std::pair<std::string, double>> {};

TEST_P(RootTypes, AreToldWithTheirCanalsLengthsAndWidths) {
  const auto& [type, uneven] = GetParam();
  const test::RootShape shape = test::root_of_type(type, uneven);
  const Cavity cavity = test::void_of_root(shape);
  const SurfaceMesh block = shapes::together(shapes::cube(-10, -10, -16, 20), cavity.wall);
  const Anatomy made = measure_anatomy({{"block", &block}});
  EXPECT_EQ(made.horns + made.other_branches, 0u);
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.roots[0].sections, shape.sections);
  EXPECT_EQ(made.roots[0].vertucci, type);
  ASSERT_EQ(made.canals.size(), shape.canals.size());
  std::vector<double> known, found;
  for (const std::vector<Point3>& axis : shape.canals) known.push_back(length_of(axis, shape.radius));
  for (const MeasuredCanal& canal : made.canals) {
    found.push_back(length(canal.orifice - Point3{}) + canal.length);
    EXPECT_NEAR(length(canal.orifice - Point3{}), shape.chamber, shape.radius) << canal.name;
    // A search for the widest ball finds most of what a smooth line loses where canals meet at an angle: type III comes
    // to 2 %.
    ASSERT_TRUE(canal.narrowest);
    EXPECT_NEAR(canal.narrowest->width, 2 * shape.radius, 3 * percent * 2 * shape.radius) << canal.name;
  }
  for (const CentreLine& line : made.lines.canals)
    for (std::size_t i = line.orifice; i < line.points.size(); ++i)
      if (in_one_tube(line, line.points[i], shape)) {
        EXPECT_NEAR(line.points[i].radius, shape.radius, percent * shape.radius)
            << line.name << " at " << line.points[i].at.z;
      }
  expect_graph(made, shape);
  std::sort(known.begin(), known.end());
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < known.size(); ++i) EXPECT_NEAR(found[i], known[i], percent * known[i]);
}

TEST_P(RootTypes, AreTheSameWithTheApexUp) {
  const auto& [type, uneven] = GetParam();
  const test::RootShape shape = test::root_of_type(type, uneven);
  SurfaceMesh wall = test::void_of_root(shape).wall;
  for (Point3& p : wall.points) p.z = -p.z;
  for (Triangle& t : wall.triangles) std::swap(t[1], t[2]);
  const SurfaceMesh block = shapes::together(shapes::cube(-10, -10, -4, 20), wall);
  const Anatomy made = measure_anatomy({{"block", &block}});
  ASSERT_EQ(made.roots.size(), 1u);
  EXPECT_EQ(made.roots[0].canals.size(), shape.canals.size());
  EXPECT_EQ(made.roots[0].sections, shape.sections);
  EXPECT_EQ(made.roots[0].vertucci, type);
}

// Where both ways round are of one length, which is the second is chance.
INSTANTIATE_TEST_SUITE_P(Vertucci, RootTypes,
                         ::testing::Values(std::pair{"I", 1.15}, std::pair{"II", 1.15}, std::pair{"III", 1.15},
                                           std::pair{"IV", 1.15}, std::pair{"V", 1.15}, std::pair{"VI", 1.15},
                                           std::pair{"VII", 1.15}, std::pair{"VIII", 1.15}, std::pair{"VI", 1.0}),
                         [](const auto& shape) { return shape.param.first + (shape.param.second == 1 ? "Even" : ""); });

}  // namespace
}  // namespace odontoscope
