// Interfaces of several materials become fewer triangles and stay what they were: closed, shared, with the same pieces,
// handles, cavities and neighbours.

#include "recon/mesh/simplify_interfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>

#include "recon/mesh/complex_parts.h"
#include "recon/mesh/self_intersection.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

constexpr int side = 12;  // cells of the block
using LabelAt = std::function<Label(int, int, int)>;

/// A block of cells with labels, its points moved a little so that nothing is flat; interfaces only. Labels may not
/// meet across an edge or a corner alone.
LabelledComplex block(const LabelAt& label, int labels) {
  LabelledComplex made;
  for (int l = 1; l <= labels; ++l) made.structures.push_back("material " + std::to_string(l));
  std::map<std::array<int, 3>, PointIndex> numbers;
  const auto number = [&](std::array<int, 3> at) {
    const auto [entry, fresh] = numbers.try_emplace(at, static_cast<PointIndex>(made.mesh.points.size()));
    if (fresh) {
      const auto off = [&](int a) { return 0.1 * ((at[0] * 7 + at[1] * 13 + at[2] * 29 + a * 5) % 11 - 5) / 5; };
      made.mesh.points.push_back({at[0] + off(0), at[1] + off(1), at[2] + off(2)});
    }
    return entry->second;
  };
  const auto labelled = [&](std::array<int, 3> c) {
    const bool inside = c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < side && c[1] < side && c[2] < side;
    return inside ? label(c[0], c[1], c[2]) : void_label;
  };
  for (int x = -1; x < side; ++x)
    for (int y = -1; y < side; ++y)
      for (int z = -1; z < side; ++z)
        for (int axis = 0; axis < 3; ++axis) {
          const std::array<int, 3> low{x, y, z};
          std::array<int, 3> high = low;
          ++high[axis];
          Label inner = labelled(low), outer = labelled(high);
          if (inner == outer) continue;
          const int u = (axis + 1) % 3, v = (axis + 2) % 3;
          std::array<std::array<int, 3>, 4> corners{high, high, high, high};  // counter-clockwise seen from above
          ++corners[1][u], ++corners[2][u], ++corners[2][v], ++corners[3][v];
          std::array<PointIndex, 4> q{number(corners[0]), number(corners[1]), number(corners[2]), number(corners[3])};
          if (inner == void_label || (outer != void_label && outer < inner)) {
            std::swap(inner, outer);
            std::swap(q[1], q[3]);
          }
          made.interfaces.push_back({{q[0], q[1], q[2]}, inner, outer});
          made.interfaces.push_back({{q[0], q[2], q[3]}, inner, outer});
        }
  return made;
}

/// Enamel over dentine, whose pulp opens below.
Label tooth(int x, int y, int z) {
  const int off = std::max(std::abs(2 * x - 11), std::abs(2 * y - 11));
  if (z < 8 && off < 5) return 3;
  if (z < 10 && off < 9) return 2;
  return z > 5 ? 1 : void_label;
}
/// Three materials round one line.
Label wedges(int x, int y, int) { return x < 6 ? 1 : y < 6 ? 2 : 3; }
/// A ring in a block: both have a handle.
Label ring(int x, int y, int z) {
  const int off = std::max(std::abs(2 * x - 11), std::abs(2 * y - 11));
  return off > 4 && off < 10 && z > 3 && z < 8 ? 1 : 2;
}
/// Four materials meet in points, two of them in a plate.
Label corners(int x, int y, int z) { return z < 4 ? 1 : z < 5 ? 2 : x < 5 ? 3 : y < 7 ? 4 : void_label; }

using KindAndGenus = std::pair<Shell::Kind, long>;

std::multiset<KindAndGenus> shells_of(const SurfaceReport& report) {
  std::multiset<KindAndGenus> shells;
  for (const Shell& shell : report.shells) shells.emplace(shell.kind, shell.genus);
  return shells;
}

double volume_of(const SurfaceReport& report) {
  double sum = 0;
  for (const Shell& shell : report.shells) sum += shell.volume;  // of a cavity: negative
  return sum;
}

std::set<std::pair<Label, Label>> neighbours_in(const LabelledComplex& complex) {
  std::set<std::pair<Label, Label>> pairs;
  for (const InterfaceTriangle& face : complex.interfaces) pairs.emplace(face.inner, face.outer);
  return pairs;
}

void expect_the_same_materials(const LabelledComplex& before, const LabelledComplex& after) {
  EXPECT_EQ(neighbours_in(after), neighbours_in(before));
  double sum = 0;
  for (std::size_t l = 0; l <= before.structures.size(); ++l) {
    SCOPED_TRACE(l);
    const SurfaceMesh full = surface_of(before, static_cast<Label>(l)),
                      simple = surface_of(after, static_cast<Label>(l));
    const SurfaceReport was = inspect(full), is = inspect(simple);
    ASSERT_TRUE(was.closed_oriented_manifold());
    EXPECT_TRUE(is.closed_oriented_manifold());
    EXPECT_EQ(shells_of(is), shells_of(was));
    EXPECT_TRUE(self_intersections(simple).empty());
    if (l == void_label) {
      EXPECT_NEAR(volume_of(is), volume_of(was), 0.05 * volume_of(was));
      sum -= volume_of(is);
    } else {
      sum += volume_of(is);
    }
  }
  EXPECT_NEAR(sum, 0, 1e-9 * side * side * side);  // so nothing gapes and nothing overlaps
}

struct Case {
  const char* name;
  LabelAt label;
  int labels;
  std::size_t least;  // triangles that are always reached
};

class SimplifyInterfaces : public testing::TestWithParam<Case> {};

TEST_P(SimplifyInterfaces, KeepsWhatMaterialsAre) {
  const LabelledComplex full = block(GetParam().label, GetParam().labels);
  for (const std::size_t aim : {std::size_t{400}, GetParam().least}) {
    SCOPED_TRACE(aim);
    const SimplifiedInterfaces simple = simplify_interfaces(full, aim);
    EXPECT_TRUE(simple.reached);
    EXPECT_LE(simple.triangles, aim);
    EXPECT_TRUE(simple.complex.mesh.tetrahedra.empty());
    expect_the_same_materials(full, simple.complex);
  }
}

TEST_P(SimplifyInterfaces, StopsWhereTopologyAsksForMore) {
  const LabelledComplex full = block(GetParam().label, GetParam().labels);
  const SimplifiedInterfaces simple = simplify_interfaces(full, 1);
  EXPECT_FALSE(simple.reached);
  EXPECT_GT(simple.triangles, 1u);
  EXPECT_GT(simple.obstacles.topology, 0u);
  double sum = 0;
  for (Label l = 1; l <= GetParam().labels; ++l) {
    const SurfaceReport was = inspect(surface_of(full, l)), is = inspect(surface_of(simple.complex, l));
    EXPECT_TRUE(is.closed_oriented_manifold());
    EXPECT_EQ(shells_of(is), shells_of(was));
    sum += volume_of(is);
  }
  EXPECT_NEAR(sum, volume_of(inspect(surface_of(simple.complex, void_label))), 1e-9 * side * side * side);
}

INSTANTIATE_TEST_SUITE_P(Blocks, SimplifyInterfaces,
                         testing::Values(Case{"tooth", tooth, 3, 100}, Case{"wedges", wedges, 3, 60},
                                         Case{"ring", ring, 2, 80}, Case{"corners", corners, 4, 90}),
                         [](const auto& one) { return one.param.name; });

TEST(SimplifyInterfacesOnce, GivesTheSameEachTime) {
  const LabelledComplex full = block(tooth, 3);
  const SimplifiedInterfaces one = simplify_interfaces(full, 200), other = simplify_interfaces(full, 200);
  EXPECT_EQ(one.complex.mesh.points, other.complex.mesh.points);
}

TEST(SimplifyInterfacesOnce, LeavesWhatIsFewEnough) {
  const LabelledComplex full = block(wedges, 3);
  const SimplifiedInterfaces simple = simplify_interfaces(full, 1'000'000);
  EXPECT_EQ(simple.complex.interfaces.size(), full.interfaces.size());
  EXPECT_EQ(simple.complex.mesh.points, full.mesh.points);
}

}  // namespace
}  // namespace odontoscope
