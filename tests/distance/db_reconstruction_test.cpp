// The DB engine from contours to a report, splits and decimation.

#include "recon/distance/db_reconstruction.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <set>
#include <stop_token>

#include "recon/core/error.h"
#include "recon/sample/sample_tooth.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"
#include "tests/distance/shapes.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

DbOptions with(std::size_t points, CaseTable cases) {
  DbOptions options;
  options.grid.columns = options.grid.rows = points;
  options.cases = cases;
  return options;
}

TEST(Db, TellsTheTruthAboutItsSurfaces) {
  const DbReconstruction consistent = reconstruct_by_distance(corners_under_a_block(), with(48, CaseTable::consistent));
  EXPECT_TRUE(consistent.certified);
  EXPECT_EQ(consistent.surfaces.at(0).structure, "tooth");
  EXPECT_EQ(consistent.surfaces[0].report.shells.at(0).structure, "tooth");
  const DbReconstruction classic = reconstruct_by_distance(corners_under_a_block(), with(48, CaseTable::classic));
  EXPECT_FALSE(classic.certified);
  EXPECT_GT(classic.surfaces.at(0).report.boundary_edges, 0u);
  const DbReconstruction unoriented =
      reconstruct_by_distance(corners_under_a_block(), with(48, CaseTable::classic_unoriented));
  EXPECT_FALSE(unoriented.certified);
  EXPECT_GT(unoriented.surfaces.at(0).report.misoriented_edges, 0u);
}

TEST(Db, TakesAnyNamedShape) {
  for (const NamedStack& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const DbReconstruction result = reconstruct_by_distance(shape.stack, with(24, CaseTable::consistent));
    const SurfaceReport& report = result.surfaces.at(0).report;
    EXPECT_EQ(report.boundary_edges + report.nonmanifold_edges + report.misoriented_edges + report.nonmanifold_vertices,
              0u);
  }
}

TEST(Db, ASplitEndsWhatItParts) {
  DbOptions options = with(32, CaseTable::consistent);
  const ContourStack column = stack_of({{circle(2)}, {circle(2)}, {circle(2)}, {circle(2)}});
  EXPECT_EQ(reconstruct_by_distance(column, options).surfaces.at(0).report.shells.size(), 1u);
  options.grid.splits = {1.25};  // between the last two of 0, 0.5, 1, 1.5
  const DbReconstruction split = reconstruct_by_distance(column, options);
  EXPECT_EQ(split.surfaces.at(0).report.shells.size(), 2u);
  EXPECT_TRUE(split.certified);
}

TEST(Db, EvenSlightOverlapConnects) {
  // DT's default separates these discs; the paper says that DB joins whatever overlaps.
  const DbReconstruction result = reconstruct_by_distance(shifted_circles(1.8), with(64, CaseTable::consistent));
  EXPECT_EQ(result.surfaces.at(0).report.shells.size(), 1u);
}

TEST(Db, DecimatesToATargetWithPointsOfTheSurface) {
  DbOptions options = with(64, CaseTable::consistent);
  const ContourStack stack = stack_of({{circle(3), circle(1)}, {circle(3), circle(1)}, {circle(3), circle(1)}});
  const DbReconstruction full = reconstruct_by_distance(stack, options);
  options.decimation = DecimateOptions{.triangles = 1000};
  const DbReconstruction fewer = reconstruct_by_distance(stack, options);
  const DbSurface& made = fewer.surfaces.at(0);
  EXPECT_LE(made.report.triangles, 1000u);
  EXPECT_GT(made.report.triangles, 900u);
  EXPECT_EQ(made.before.triangles, full.surfaces.at(0).report.triangles);
  ASSERT_TRUE(made.decimation_error);
  EXPECT_LT(*made.decimation_error, 0.1);
  std::set<std::array<double, 3>> points;
  for (const Point3& p : full.surfaces[0].surface.points) points.insert({p.x, p.y, p.z});
  for (const Point3& p : made.surface.points) EXPECT_TRUE(points.contains({p.x, p.y, p.z}));
}

TEST(Db, DecimatesToTheMostPossibleWithinHalfASpacing) {
  DbOptions options = with(64, CaseTable::classic);
  options.decimation = DecimateOptions{};
  const DbReconstruction result = reconstruct_by_distance(corners_under_a_block(), options);
  const DbSurface& made = result.surfaces.at(0);
  EXPECT_GT(made.before.boundary_edges, 0u) << "the case is one with cracks";
  EXPECT_LT(made.report.triangles, made.before.triangles / 2);
  EXPECT_GT(made.report.triangles, 100u);
  EXPECT_LE(*made.decimation_error, 0.5 * std::max(result.grid.dx, result.grid.dy));
  EXPECT_EQ(result.certified, made.report.closed_oriented_manifold());  // small cracks may close, or not
}

bool same_bytes(const DbReconstruction& a, const DbReconstruction& b) {
  if (a.surfaces.size() != b.surfaces.size()) return false;
  for (std::size_t i = 0; i < a.surfaces.size(); ++i) {
    const SurfaceMesh &one = a.surfaces[i].surface, &other = b.surfaces[i].surface;
    if (one.triangles != other.triangles || one.points.size() != other.points.size()) return false;
    if (std::memcmp(one.points.data(), other.points.data(), one.points.size() * sizeof(Point3)) != 0) return false;
  }
  return true;
}

TEST(Db, GivesTheSameBytesOnAnyNumberOfThreads) {
  DbOptions options = with(40, CaseTable::classic);
  options.decimation = DecimateOptions{.triangles = 20'000};
  options.threads = 1;
  const ContourStack molar = sample_tooth(ToothKind::molar);
  const DbReconstruction one = reconstruct_by_distance(molar, options);
  options.threads = 5;
  EXPECT_TRUE(same_bytes(one, reconstruct_by_distance(molar, options)));
  EXPECT_EQ(one.surfaces.size(), 3u);
}

TEST(Db, RefusesBadStacksAndStops) {
  ContourStack crossing = stack_of({{circle(2), circle(2, {1, 0})}, {circle(2)}});
  EXPECT_THROW(reconstruct_by_distance(crossing), InputError);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(reconstruct_by_distance(annulus_over_disc(), {}, {{}, stop.get_token()}), Cancelled);
}

// --- the CT molar ----------------------------------------------------------------------------------------------------

TEST(DbCtMolar, CracksAreExactlyThoseThatTheFacesPredict) {
  const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
  if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file)) GTEST_SKIP() << "set ODONTOSCOPE_DATA";
  const ContourStack stack = iso_contours(read_volume(file.string()), {{120, "tooth"}}, {.min_area = 4}).stack;
  const Grid grid = make_grid(stack, {});
  const Field field = sample_field(stack, "tooth", grid);
  for (const CaseTable table : {CaseTable::classic, CaseTable::classic_unoriented, CaseTable::consistent}) {
    SCOPED_TRACE(name(table));
    const MarchedSurface surface = march(grid, field, table);
    const std::vector<Defect> found = defects_of(grid, field, surface);
    EXPECT_EQ(found, predicted_defects(grid, field, table, surface));
    EXPECT_EQ(found.empty(), table == CaseTable::consistent);
    EXPECT_EQ(std::any_of(found.begin(), found.end(), [](const Defect& d) { return d.kind == DefectKind::crack; }),
              table != CaseTable::consistent);
  }
}

}  // namespace
}  // namespace odontoscope::test
