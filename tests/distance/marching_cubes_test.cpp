// The surface: what each table makes of random contours, and that every defect has the reason that it is given.

#include "recon/distance/marching_cubes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstring>
#include <stop_token>

#include "recon/core/error.h"
#include "recon/distance/defects.h"
#include "recon/input/validate.h"
#include "recon/mesh/surface_report.h"
#include "recon/sample/sample_tooth.h"
#include "tests/distance/shapes.h"
#include "tests/support/random_stacks.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

struct Made {
  Grid grid;
  Field field;
  MarchedSurface surface;
  SurfaceReport report;
};

Made made(const ContourStack& given, const std::string& structure, std::size_t points, CaseTable table,
          FieldKind kind = FieldKind::hybrid) {
  const ContourStack stack = ordered(given).stack;
  Made result{make_grid(stack, {.columns = points, .rows = points, .splits = {}}), {}, {}, {}};
  result.field = sample_field(stack, structure, result.grid, {kind});
  result.surface = march(result.grid, result.field, table);
  result.report = inspect(result.surface.mesh);
  return result;
}

bool has_zero(const Field& field) {
  return std::find(field.values.begin(), field.values.end(), 0) != field.values.end();
}

TEST(MarchingCubes, ConsistentIsAlwaysAClosedOrientedManifoldUpToTrianglesWithoutArea) {
  std::size_t plain = 0, with_zeros = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const ContourStack stack = random_stack(seed).stack;
    for (const FieldKind kind : {FieldKind::hybrid, FieldKind::signed_distance, FieldKind::sign})
      for (const std::size_t points : {9, 24}) {
        const Made m = made(stack, structures_of(stack)[0], points, CaseTable::consistent, kind);
        EXPECT_EQ(m.report.boundary_edges + m.report.nonmanifold_edges + m.report.misoriented_edges, 0u) << seed;
        EXPECT_EQ(m.report.nonmanifold_vertices, 0u) << seed;
        const bool zero = has_zero(m.field);
        with_zeros += zero;
        plain += m.report.degenerate_triangles == 0;
        EXPECT_TRUE(zero || kind != FieldKind::sign || m.report.degenerate_triangles == 0) << seed;
      }
  }
  EXPECT_GT(plain, 100u);
  EXPECT_GT(with_zeros, 10u) << "the lattice stacks should pass through grid points";
}

TEST(MarchingCubes, EveryDefectIsWhereItsTableSaysAndNowhereElse) {
  std::size_t cracks = 0, misoriented = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const ContourStack stack = random_stack(seed).stack;
    for (const CaseTable table : {CaseTable::classic, CaseTable::classic_unoriented, CaseTable::consistent}) {
      const Made m = made(stack, structures_of(stack)[0], 20, table);
      const std::vector<Defect> found = defects_of(m.grid, m.field, m.surface);
      EXPECT_EQ(found, predicted_defects(m.grid, m.field, table, m.surface)) << seed << " " << name(table);
      const auto count = [&](DefectKind kind) {
        return std::size_t(std::count_if(found.begin(), found.end(), [&](const Defect& d) { return d.kind == kind; }));
      };
      EXPECT_EQ(count(DefectKind::crack), m.report.boundary_edges);
      EXPECT_EQ(count(DefectKind::misoriented), m.report.misoriented_edges);
      EXPECT_EQ(count(DefectKind::nonmanifold), 0u);
      EXPECT_TRUE(table != CaseTable::classic || m.report.misoriented_edges == 0) << seed;
      cracks += count(DefectKind::crack);
      misoriented += count(DefectKind::misoriented);
    }
  }
  EXPECT_GT(cracks, 100u);
  EXPECT_GT(misoriented, 1000u);
}

TEST(MarchingCubes, ADefectTellsItsReason) {
  const Made m = made(corners_under_a_block(), "tooth", 24, CaseTable::classic_unoriented);
  bool crack = false, misoriented = false;
  for (const Defect& d : defects_of(m.grid, m.field, m.surface)) {
    EXPECT_EQ(case_at(m.grid, m.field, d.first), d.first_case);
    EXPECT_EQ(case_at(m.grid, m.field, d.second), d.second_case);
    EXPECT_EQ(d.second[d.axis], d.first[d.axis] + 1);
    const auto& cells = cell_triangles(CaseTable::classic_unoriented);
    EXPECT_NE(cells[d.first_case].complement, cells[d.second_case].complement);
    EXPECT_EQ(d.ambiguous_face, d.kind == DefectKind::crack);
    const std::string words = in_words(d, CaseTable::classic_unoriented);
    EXPECT_NE(words.find("classic-unoriented"), std::string::npos) << words;
    EXPECT_NE(words.find("complement of base case"), std::string::npos) << words;
    EXPECT_NE(words.find(d.kind == DefectKind::crack ? "a crack" : "not turned over"), std::string::npos) << words;
    crack = crack || d.kind == DefectKind::crack;
    misoriented = misoriented || d.kind == DefectKind::misoriented;
  }
  EXPECT_TRUE(crack);
  EXPECT_TRUE(misoriented);
}

TEST(MarchingCubes, PointsLieOnTheirGridEdges) {
  const Made m = made(star_over_turned_star(), "tooth", 20, CaseTable::classic, FieldKind::signed_distance);
  ASSERT_EQ(m.surface.edge_of_point.size(), m.surface.mesh.points.size());
  ASSERT_EQ(m.surface.cell_of_triangle.size(), m.surface.mesh.triangles.size());
  for (std::size_t i = 0; i < m.surface.mesh.points.size(); ++i) {
    const GridEdge& e = m.surface.edge_of_point[i];
    const Point3 a = m.grid.point(e.from[0], e.from[1], e.from[2]), p = m.surface.mesh.points[i];
    const double along[] = {(p.x - a.x) / m.grid.dx, (p.y - a.y) / m.grid.dy, (p.z - a.z) / spacing};
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(along[axis], -1e-12);
      EXPECT_LE(along[axis], (axis == e.axis ? 1 : 0) + 1e-12);
    }
  }
  for (std::size_t t = 0; t < m.surface.mesh.triangles.size(); ++t)
    for (const PointIndex p : m.surface.mesh.triangles[t])
      for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t from = m.surface.edge_of_point[p].from[axis], cell = m.surface.cell_of_triangle[t][axis];
        EXPECT_TRUE(from == cell || from == cell + 1);
      }
}

TEST(MarchingCubes, PointsOnAStraightContourLieOnIt) {
  // A block from x = 0 to 4 without corners nearby: distances are linear there, so interpolation meets the contour.
  // The last slice is wider, so that the contours lie anywhere between grid points.
  const std::vector<Ring> section{rectangle({0, -20}, {4, 20})}, wider{rectangle({-0.3, -20}, {5, 20})};
  const Made m = made(stack_of({section, section, wider}), "tooth", 21, CaseTable::classic, FieldKind::signed_distance);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < m.surface.mesh.points.size(); ++i) {
    const Point3& p = m.surface.mesh.points[i];
    if (m.surface.edge_of_point[i].axis != 0 || std::abs(p.y) > 10 || p.z > spacing) continue;
    EXPECT_NEAR(std::min(std::abs(p.x), std::abs(p.x - 4)), 0, 1e-12);
    ++seen;
  }
  EXPECT_GT(seen, 30u);
}

TEST(MarchingCubes, SurfacesFaceOutwardsAndEncloseTheRightVolume) {
  // A column of 4 x 3 with a hole of 2 x 1 through it, 4 slices high (1.5 mm), and caps between 0 and 0.5 mm beyond
  // each end.
  const std::vector<Ring> section{rectangle({0, 0}, {4, 3}), rectangle({1, 1}, {3, 2})};
  const Made m = made(stack_of({section, section, section, section}), "tooth", 64, CaseTable::consistent);
  ASSERT_EQ(m.report.shells.size(), 1u);
  EXPECT_EQ(m.report.shells[0].kind, Shell::Kind::external);
  EXPECT_EQ(m.report.shells[0].genus, 1);
  EXPECT_GT(m.report.shells[0].volume, 10 * 1.5 * 0.99);
  EXPECT_LT(m.report.shells[0].volume, 10 * 2.5);
}

TEST(MarchingCubes, AContourThroughGridPointsGivesTrianglesWithoutAreaButKeepsTheTopology) {
  // Grid points at -0.5, 0.5, ..., 8.5: the inner square passes through many of them.
  const std::vector<Ring> section{rectangle({0, 0}, {8, 8}), rectangle({2.5, 2.5}, {5.5, 5.5})};
  const Made m = made(stack_of({section, section}), "tooth", 10, CaseTable::consistent);
  ASSERT_TRUE(has_zero(m.field));
  EXPECT_GT(m.report.degenerate_triangles, 0u);
  EXPECT_EQ(
      m.report.boundary_edges + m.report.nonmanifold_edges + m.report.misoriented_edges + m.report.nonmanifold_vertices,
      0u);
  EXPECT_FALSE(m.report.closed_oriented_manifold());
}

TEST(MarchingCubes, RefusesAFieldThatLeavesTheGrid) {
  Made m = made(annulus_over_disc(), "tooth", 10, CaseTable::consistent);
  m.field.values.front() = -1;
  EXPECT_THROW(march(m.grid, m.field, CaseTable::consistent), InternalError);
}

bool same_bytes(const MarchedSurface& a, const MarchedSurface& b) {
  return a.mesh.points.size() == b.mesh.points.size() && a.mesh.triangles == b.mesh.triangles &&
         std::memcmp(a.mesh.points.data(), b.mesh.points.data(), a.mesh.points.size() * sizeof(Point3)) == 0 &&
         a.edge_of_point == b.edge_of_point && a.cell_of_triangle == b.cell_of_triangle;
}

TEST(MarchingCubes, GivesTheSameBytesOnAnyNumberOfThreads) {
  const ContourStack molar = sample_tooth(ToothKind::molar);
  const auto with = [&](int threads) {
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return made(molar, "dentine", 48, CaseTable::classic); });
  };
  const Made one = with(1), many = with(7);
  EXPECT_GT(one.surface.mesh.triangles.size(), 10'000u);
  EXPECT_EQ(std::memcmp(one.field.values.data(), many.field.values.data(), one.field.values.size() * sizeof(double)),
            0);
  EXPECT_TRUE(same_bytes(one.surface, many.surface));
}

TEST(MarchingCubes, CanBeStoppedAndTellsHowFarItIs) {
  std::stop_source stop;
  double last = 0;
  const ContourStack stack = ordered(comb_over_mirrored_comb()).stack;
  const Grid grid = make_grid(stack, {});
  const Progress listening{[&](std::string_view, double fraction) { last = fraction; }, stop.get_token()};
  const Field field = sample_field(stack, "tooth", grid, {}, listening);
  EXPECT_EQ(last, 1);
  march(grid, field, CaseTable::classic, listening);
  EXPECT_EQ(last, 1);
  stop.request_stop();
  EXPECT_THROW(sample_field(stack, "tooth", grid, {}, listening), Cancelled);
  EXPECT_THROW(march(grid, field, CaseTable::classic, listening), Cancelled);
}

}  // namespace
}  // namespace odontoscope::test
