// Voxels are what their centres say, to the last tie.

#include "recon/segmentation/rasterise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/mesh/tetra_report.h"
#include "tests/segmentation/made.h"

namespace odontoscope {
namespace {

using made::polygon;
using made::Ring;

ContourStack two_slices(const std::vector<std::pair<std::string, Ring>>& contours) {
  ContourStack stack;
  for (const double z : {0.0, 1.0}) {
    Slice slice{z, {}};
    for (const auto& [structure, points] : contours) slice.contours.push_back({structure, points});
    stack.slices.push_back(slice);
  }
  return stack;
}

const VoxelGrid unit_grid{{6, 6, 2}, {1, 1, 1}, {0, 0, 0}};

/// Rows of the first slice, the first being y = 0.
std::vector<std::string> rows(const Segmentation& voxels, std::size_t segment = 0, std::size_t k = 0) {
  std::vector<std::string> text;
  for (std::size_t j = 0; j < voxels.grid.size[1]; ++j) {
    text.emplace_back();
    for (std::size_t i = 0; i < voxels.grid.size[0]; ++i)
      text.back() += voxels.segments[segment].voxels.at(i, j, k) ? '#' : '.';
  }
  return text;
}

TEST(Voxels, OnABorderBelongToWhatLiesBeyondAlongXAndY) {
  const Segmentation voxels = rasterised(two_slices({{"tooth", {{1, 1}, {4, 1}, {4, 3}, {1, 3}}}}), unit_grid);
  EXPECT_EQ(rows(voxels), (std::vector<std::string>{"......", ".###..", ".###..", "......", "......", "......"}));
}

TEST(Voxels, OnASharedBorderBelongToExactlyOne) {
  // Four pieces of a square that meet in a centre, along slanted and upright borders through centres.
  const Point2 m{2, 3}, a{0, 0}, b{5, 0}, c{5, 5}, d{0, 5};
  const Segmentation voxels =
      rasterised(two_slices({{"a", {a, b, m}}, {"b", {b, c, m}}, {"c", {c, d, m}}, {"d", {d, a, m}}}), unit_grid);
  for (std::size_t j = 0; j < 5; ++j)
    for (std::size_t i = 0; i < 5; ++i) {
      int owners = 0;
      for (const Segment& segment : voxels.segments) owners += segment.voxels.at(i, j, 1);
      EXPECT_EQ(owners, 1) << i << ' ' << j;
    }
}

TEST(Voxels, OfHolesAreNotTaken) {
  const Segmentation voxels = rasterised(two_slices({{"tooth", {{-0.5, -0.5}, {5.5, -0.5}, {5.5, 5.5}, {-0.5, 5.5}}},
                                                     {"tooth", {{1.5, 1.5}, {1.5, 3.5}, {3.5, 3.5}, {3.5, 1.5}}}}),
                                         unit_grid);
  EXPECT_EQ(rows(voxels)[2], "##..##");
  EXPECT_EQ(voxels.segments[0].voxels.count(), 2u * (36 - 4));
}

TEST(Voxels, AgreeWithAnAngleCountInGeneralPosition) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Ring star;
    for (int i = 0; i < 40; ++i) {
      const double angle = 2 * 3.14159265358979 * i / 40, radius = 6 + 3 * at(random);
      star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const VoxelGrid grid{{70, 61, 2}, {0.31, 0.29, 1}, {-10 + at(random), -9 + at(random), 0}};
    const Segmentation voxels = rasterised(two_slices({{"tooth", star}}), grid);
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        ASSERT_EQ(voxels.segments[0].voxels.at(i, j, 0), made::covers({star}, {grid.x(i), grid.y(j)})) << i << ' ' << j;
  }
}

TEST(Voxels, ContoursBeyondTheGridAreCutOff) {
  const VoxelGrid small{{3, 3, 2}, {1, 1, 1}, {2, 2, 0}};
  const Segmentation voxels = rasterised(two_slices({{"tooth", polygon(30, 50)}}), small);
  EXPECT_EQ(voxels.segments[0].voxels.count(), 18u);
}

SurfaceMesh cube(double low, double high) {
  SurfaceMesh mesh;
  for (int n = 0; n < 8; ++n)
    mesh.points.push_back({(n & 1) != 0 ? high : low, (n & 2) != 0 ? high : low, (n & 4) != 0 ? high : low});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(SolidVoxels, OnWallsBelongToWhatLiesBeyond) {
  const SurfaceMesh mesh = cube(1, 3);  // every wall, edge and corner through centres
  const VoxelGrid grid{{5, 5, 5}, {1, 1, 1}, {0, 0, 0}};
  const Segmentation voxels = rasterised({{"cube", &mesh}}, grid);
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t j = 0; j < 5; ++j)
      for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(voxels.segments[0].voxels.at(i, j, k), i >= 1 && i < 3 && j >= 1 && j < 3 && k >= 1 && k < 3)
            << i << j << k;
}

TEST(SolidVoxels, BetweenSlicesAreThoseOfTheTetrahedra) {
  const Reconstruction model = reconstruct(made::tooth());
  const VoxelGrid grid{{64, 64, 21}, {0.2, 0.2, 0.05}, {-6.31, -6.27, 0.503}};
  std::vector<FilledSurface> surfaces;
  for (const Solid& solid : model.solids) surfaces.push_back({solid.structure, &solid.surface});
  const Segmentation voxels = rasterised(surfaces, grid);
  ASSERT_EQ(voxels.segments.size(), 3u);
  // Against barycentric coordinates in every tetrahedron.
  for (std::size_t s = 0; s < 3; ++s) {
    const TetraMesh& mesh = model.solids[s].tetrahedra;
    std::vector<bool> inside(grid.voxels());
    for (const Tetrahedron& t : mesh.tetrahedra) {
      const Point3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]], &d = mesh.points[t[3]];
      const auto volume = [](const Point3& p, const Point3& q, const Point3& r, const Point3& u) {
        const double x1 = q.x - p.x, y1 = q.y - p.y, z1 = q.z - p.z, x2 = r.x - p.x, y2 = r.y - p.y, z2 = r.z - p.z,
                     x3 = u.x - p.x, y3 = u.y - p.y, z3 = u.z - p.z;
        return x1 * (y2 * z3 - z2 * y3) - y1 * (x2 * z3 - z2 * x3) + z1 * (x2 * y3 - y2 * x3);
      };
      const auto first = [](double low, double origin, double step) {
        return static_cast<std::size_t>(std::max(0.0, std::floor((low - origin) / step)));
      };
      const auto [lx, hx] = std::minmax({a.x, b.x, c.x, d.x});
      const auto [ly, hy] = std::minmax({a.y, b.y, c.y, d.y});
      const auto [lz, hz] = std::minmax({a.z, b.z, c.z, d.z});
      for (std::size_t k = first(lz, grid.origin.z, 0.05); k < grid.size[2] && grid.z(k) <= hz; ++k)
        for (std::size_t j = first(ly, grid.origin.y, 0.2); j < grid.size[1] && grid.y(j) <= hy; ++j)
          for (std::size_t i = first(lx, grid.origin.x, 0.2); i < grid.size[0] && grid.x(i) <= hx; ++i) {
            const Point3 p{grid.x(i), grid.y(j), grid.z(k)};
            if (volume(p, b, c, d) >= 0 && volume(a, p, c, d) >= 0 && volume(a, b, p, d) >= 0 &&
                volume(a, b, c, p) >= 0)
              inside[(k * grid.size[1] + j) * grid.size[0] + i] = true;
          }
    }
    std::size_t count = 0, differ = 0;
    for (std::size_t k = 0; k < grid.size[2]; ++k)
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        for (std::size_t i = 0; i < grid.size[0]; ++i) {
          const bool wanted = inside[(k * grid.size[1] + j) * grid.size[0] + i];
          count += wanted;
          differ += wanted != voxels.segments[s].voxels.at(i, j, k);
        }
    EXPECT_GT(count, 500u);
    EXPECT_EQ(differ, 0u) << model.solids[s].structure;
  }
}

TEST(SolidVoxels, AtTheSlicesAreThoseOfTheContours) {
  const ContourStack stack = made::tooth();
  const Reconstruction model = reconstruct(stack);
  // The lowest slice is a wall: a solid lies above it. The topmost is one, too, and nothing lies above.
  const VoxelGrid grid{{130, 130, 2}, {0.1, 0.1, 0.5}, {-6.5, -6.5, 0.5}};
  const Segmentation flat = rasterised(stack, VoxelGrid{{130, 130, 3}, {0.1, 0.1, 0.5}, {-6.5, -6.5, 0.5}});
  std::vector<FilledSurface> surfaces;
  for (const Solid& solid : model.solids) surfaces.push_back({solid.structure, &solid.surface});
  const Segmentation solid = rasterised(surfaces, grid);
  for (std::size_t s = 0; s < 3; ++s)
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(rows(solid, s, k), rows(flat, s, k)) << s << ' ' << k;
}

TEST(VoxelGrids, LieAroundTheStructures) {
  const VoxelGrid grid = grid_around({{-1, 0.05, 2}, {1, 0.95, 3}}, {0.5, 0.1, 1});
  EXPECT_EQ(grid.size, (std::array<std::size_t, 3>{7, 13, 4}));
  EXPECT_EQ(grid.origin, (Point3{-1.5, -0.1, 1}));
  EXPECT_THROW(grid_around({{0, 0, 0}, {1, 1, 1}}, {1e-4, 1e-4, 1e-4}), UsageError);
  EXPECT_THROW(grid_around({{0, 0, 0}, {1, 1, 1}}, {0, 1, 1}), UsageError);
  EXPECT_THROW(grid_from({0, 0, 0}, {{-1, 0, 0}, {1, 1, 1}}, {1, 1, 1}), UsageError);
  EXPECT_EQ(grid_from({-1, 0, 0}, {{-1, 0, 0}, {1, 1, 1}}, {1, 1, 1}).size, (std::array<std::size_t, 3>{3, 2, 2}));
}

TEST(VoxelGrids, OfUnevenSlicesAreRefused) {
  ContourStack stack = made::tooth();
  EXPECT_EQ(grid_of_slices(stack, 0.1, 0.1).size[2], 3u);
  EXPECT_EQ(grid_of_slices(stack, 0.1, 0.1).spacing[2], 0.5);
  stack.slices[1].z = 0.9;
  try {
    grid_of_slices(stack, 0.1, 0.1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.cause(), "uneven-slices");
  }
}

}  // namespace
}  // namespace odontoscope
