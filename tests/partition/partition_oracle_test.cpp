// The judge itself: it passes what is right and goes red for each fault that is planted in it.

#include "tests/partition/partition_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "recon/partition/reconstruct_partition.h"

namespace odontoscope::test {
namespace {

using Ring = std::vector<Point2>;

Ring box(Point2 low, Point2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

/// Pulp in dentine, enamel beside it with a shared border; dentine is given whole, so that pulp lies over it.
ContourStack small_tooth() {
  ContourStack stack;
  for (int k = 0; k < 3; ++k) {
    const double d = 0.1 * k;
    Slice slice{0.5 * k, {}};
    slice.contours.push_back({"dentine", box({-2, -2}, {2 + d, 2})});
    slice.contours.push_back({"pulp", box({-1 + d, -1}, {1, 1 + d})});
    slice.contours.push_back({"enamel", box({2 + d, -2}, {3, 2})});
    stack.slices.push_back(slice);
  }
  return stack;
}

const PartitionRule inner_first{{"pulp", "dentine", "enamel"}, 0};

const Reconstruction& partition_of_small_tooth() {
  static const Reconstruction result = reconstruct_partition(
      small_tooth(), {.priority = inner_first.priority, .gap = 0, .between = Between::delaunay, .threads = 1});
  return result;
}

bool red_after(const std::function<void(Reconstruction&)>& plant) {
  Reconstruction result = partition_of_small_tooth();
  plant(result);
  return !partition_faults(result, small_tooth(), inner_first).empty();
}

std::size_t point_at(const TetraMesh& mesh, const Point3& p) {
  return std::size_t(std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin());
}

TEST(PartitionOracle, PassesAPartition) {
  EXPECT_EQ(partition_faults(partition_of_small_tooth(), small_tooth(), inner_first), std::vector<std::string>{});
}

TEST(PartitionOracle, SeesAFlippedLabel) {
  const std::size_t count = partition_of_small_tooth().complex->mesh.labels.size();
  for (std::size_t t = 0; t < count; t += 7)
    EXPECT_TRUE(red_after([&](Reconstruction& r) {
      r.complex->mesh.labels[t] = Label(r.complex->mesh.labels[t] % 3 + 1);
    })) << t;
}

TEST(PartitionOracle, SeesADroppedTetrahedron) {
  EXPECT_TRUE(red_after([](Reconstruction& r) {
    r.complex->mesh.tetrahedra.pop_back();
    r.complex->mesh.labels.pop_back();
  }));
}

TEST(PartitionOracle, SeesFaultsOfTheInterfaces) {
  EXPECT_TRUE(red_after([](Reconstruction& r) { r.complex->interfaces.pop_back(); }));
  EXPECT_TRUE(red_after([](Reconstruction& r) { r.complex->interfaces.push_back(r.complex->interfaces.front()); }));
  EXPECT_TRUE(red_after([](Reconstruction& r) {
    std::swap(r.complex->interfaces.front().triangle[0], r.complex->interfaces.front().triangle[1]);
  }));
  EXPECT_TRUE(red_after(
      [](Reconstruction& r) { std::swap(r.complex->interfaces.front().inner, r.complex->interfaces.front().outer); }));
}

TEST(PartitionOracle, SeesADuplicatedTetrahedron) {
  EXPECT_TRUE(red_after([](Reconstruction& r) {
    r.complex->mesh.tetrahedra.push_back(r.complex->mesh.tetrahedra.front());
    r.complex->mesh.labels.push_back(r.complex->mesh.labels.front());
  }));
}

TEST(PartitionOracle, SeesAMovedPoint) {
  EXPECT_TRUE(red_after([](Reconstruction& r) {
    r.complex->mesh.points[point_at(r.complex->mesh, {2, 2, 0})].x += 1e-12;
  }));
  EXPECT_TRUE(red_after([](Reconstruction& r) { r.solids[0].tetrahedra.points[0].x += 1e-15; }));
  EXPECT_TRUE(red_after([](Reconstruction& r) { r.solids[0].surface.points[0].y += 1e-15; }));
}

TEST(PartitionOracle, SeesOtherContours) {
  for (const auto& change : std::vector<std::function<void(ContourStack&)>>{
           [](ContourStack& s) { s.slices[1].contours[1].points[0].x += 1e-9; },
           [](ContourStack& s) { s.slices[1].contours.pop_back(); },
           [](ContourStack& s) {
             s.slices[1].contours[0].points.insert(s.slices[1].contours[0].points.begin() + 1, {0.123, -2});
           },
           [](ContourStack& s) {
             s.slices[2].contours.push_back({"pulp", box({1.5, 1.5}, {1.7, 1.7})});
           }}) {
    ContourStack stack = small_tooth();
    change(stack);
    EXPECT_FALSE(partition_faults(partition_of_small_tooth(), stack, inner_first).empty());
  }
}

TEST(PartitionOracle, SeesAnotherPriority) {
  EXPECT_FALSE(partition_faults(partition_of_small_tooth(), small_tooth(), {{"dentine", "pulp", "enamel"}, 0}).empty());
}

TEST(PartitionOracle, SeesARefoldedLabelInTheSliceAlone) {
  // All labels of one material exchanged with another's: still a manifold partition, only the slices tell.
  Reconstruction result = partition_of_small_tooth();
  for (Label& label : result.complex->mesh.labels) label = label == 1 ? 2 : label == 2 ? 1 : label;
  EXPECT_FALSE(section_faults(*result.complex, small_tooth(), inner_first).empty());
}

}  // namespace
}  // namespace odontoscope::test
