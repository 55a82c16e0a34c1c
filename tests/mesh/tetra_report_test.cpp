#include "recon/mesh/tetra_report.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>
#include <utility>

#include "tests/mesh/shapes.h"

namespace odontoscope {
namespace {

TEST(TetraReport, RegularTetrahedronIsIdeal) {
  const TetraReport report = inspect(shapes::regular_tetrahedron());
  EXPECT_EQ(report.tetrahedra, 1u);
  EXPECT_EQ(report.non_positive, 0u);
  EXPECT_NEAR(report.volume, std::sqrt(2.0) / 12, 1e-15);
  EXPECT_NEAR(report.smallest_dihedral_deg.min, 70.528779, 1e-6);
  EXPECT_NEAR(report.largest_dihedral_deg.max, 70.528779, 1e-6);
  EXPECT_NEAR(report.radius_edge_ratio.mean, std::sqrt(6.0) / 4, 1e-12);
}

TEST(TetraReport, CubeOfFive) {
  const TetraReport report = inspect(shapes::cube_of_five());
  EXPECT_EQ(report.non_positive, 0u);
  EXPECT_NEAR(report.volume, 1, 1e-15);
  // Four corners: three right angles and three of atan(sqrt(2)); the middle one is regular.
  EXPECT_NEAR(report.smallest_dihedral_deg.min, 54.735610, 1e-6);
  EXPECT_NEAR(report.smallest_dihedral_deg.max, 70.528779, 1e-6);
  EXPECT_NEAR(report.largest_dihedral_deg.max, 90, 1e-6);
  EXPECT_EQ(report.radius_edge_ratio.histogram.at(0), 5u);
}

TEST(TetraReport, InvertedAndFlatElementsAreCountedExactly) {
  TetraMesh mesh = shapes::cube_of_five();
  std::swap(mesh.tetrahedra[1][0], mesh.tetrahedra[1][1]);
  EXPECT_EQ(inspect(mesh).non_positive, 1u);
  mesh.tetrahedra.push_back({0, 1, 3, 2});  // all in the bottom
  const TetraReport report = inspect(mesh);
  EXPECT_EQ(report.non_positive, 2u);
  EXPECT_NEAR(report.smallest_dihedral_deg.min, 0, 1e-5);
  EXPECT_NEAR(report.largest_dihedral_deg.max, 180, 1e-5);
  EXPECT_TRUE(std::isfinite(report.radius_edge_ratio.max));
  // Coordinates so far out that a rounded determinant has no sign.
  const TetraMesh sliver{
      {{1e6, 1e6, 1e6}, {1e6 + 1, 1e6, 1e6}, {1e6, 1e6 + 1, 1e6}, {1e6, 1e6, std::nextafter(1e6, 2e6)}},
      {{0, 1, 2, 3}},
      {1}};
  EXPECT_EQ(inspect(sliver).non_positive, 0u);
}

TEST(TetraReport, EmptyMeshIsAllZeros) {
  const TetraReport report = inspect(TetraMesh{});
  EXPECT_EQ(report.tetrahedra, 0u);
  EXPECT_EQ(report.volume, 0);
  EXPECT_EQ(report.smallest_dihedral_deg.mean, 0);
}

TEST(TetraReport, ThreadsChangeNoBit) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-10, 10);
  TetraMesh mesh;
  for (int i = 0; i < 20'000; ++i) mesh.points.push_back({coordinate(random), coordinate(random), coordinate(random)});
  for (PointIndex i = 0; i + 3 < mesh.points.size(); ++i) mesh.tetrahedra.push_back({i, i + 1, i + 2, i + 3});
  const auto with_threads = [&](std::size_t n) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, n);
    return inspect(mesh);
  };
  const TetraReport one = with_threads(1), four = with_threads(4);
  EXPECT_EQ(one.volume, four.volume);
  EXPECT_EQ(one.non_positive, four.non_positive);
  EXPECT_EQ(one.smallest_dihedral_deg.mean, four.smallest_dihedral_deg.mean);
  EXPECT_EQ(one.radius_edge_ratio.median, four.radius_edge_ratio.median);
}

}  // namespace
}  // namespace odontoscope
