#include "recon/compare/canal.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "recon/compare/contour_fit.h"
#include "recon/core/error.h"
#include "recon/core/portable_math.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/validate.h"

namespace odontoscope {
namespace {

constexpr double height = 10, apex_width = 6, crown_width = 10;
constexpr std::size_t slices = 41;
constexpr double least_canal = 0.05, most_canal = 2;

std::vector<Point2> ring(double width, Point2 centre, int points) {
  std::vector<Point2> result;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    result.push_back({centre.x + width / 2 * portable::cos(angle), centre.y + width / 2 * portable::sin(angle)});
  }
  return result;
}

/// Half a turn about a point off the axis; at most 0.06 mm a slice, and less for thinner canals.
Point2 canal_centre(double share, double canal) {
  constexpr double turns = 0.5;
  const double radius = std::min(0.7, 2.8 * canal);
  const double angle = 2 * std::numbers::pi * turns * share;
  return {0.37 + radius * portable::cos(angle), -0.23 + radius * portable::sin(angle)};
}

CanalResult judged(const SurfaceMesh& surface, const SurfaceReport& report, const ContourStack& stack) {
  CanalResult result;
  const ContourFit fit = contour_fit(stack, "tooth", surface, {.samples = 0});
  result.open_slices = fit.holes.all - fit.holes.lost;
  result.surfaces = report.shells.size();
  result.triangles = report.triangles;
  bool closed = true;
  for (const Shell& shell : report.shells) {
    if (shell.kind == Shell::Kind::open)
      closed = false;
    else
      result.genus += shell.genus;
  }
  result.open_through = closed && result.surfaces == 1 && result.genus == 1;
  return result;
}

std::vector<std::size_t> usual_grids() {
  constexpr std::size_t first = 16, last = 128, step = 4;
  std::vector<std::size_t> grids;
  for (std::size_t grid = first; grid <= last; grid += step) grids.push_back(grid);
  return grids;
}

}  // namespace

ContourStack tooth_with_canal(const CanalTooth& tooth) {
  if (!(tooth.canal >= least_canal && tooth.canal <= most_canal)) {
    throw UsageError(fmt::format("a canal of {} mm", tooth.canal),
                     fmt::format("Use {} to {} mm", least_canal, most_canal));
  }
  constexpr int tooth_points = 96, canal_points = 24;
  ContourStack stack;
  for (std::size_t k = 0; k < slices; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(slices - 1);
    const double width = apex_width + share * (crown_width - apex_width);
    std::vector<Point2> canal = ring(tooth.canal, canal_centre(share, tooth.canal), canal_points);
    stack.slices.push_back(
        {share * height, {{"tooth", ring(width, {}, tooth_points)}, {"tooth", {canal.rbegin(), canal.rend()}}}});
  }
  return stack;
}

CanalExperiment canal_experiment(const CanalOptions& options, const Progress& progress) {
  CanalExperiment experiment{options.tooth, options.cases, slices, {}, {}};
  const ContourStack stack = ordered(tooth_with_canal(options.tooth)).stack;
  const std::vector<std::size_t> grids = options.grids.empty() ? usual_grids() : options.grids;
  const Progress inner{{}, progress.stop};
  ReconstructOptions dt;
  dt.threads = options.threads;
  const Reconstruction made = reconstruct(stack, dt, inner);
  experiment.dt = judged(made.solids.at(0).surface, made.solids[0].report, stack);
  for (const std::size_t grid : grids) {
    progress.tell("canal", static_cast<double>(experiment.db.size()) / static_cast<double>(grids.size()));
    DbOptions db;
    db.grid.columns = db.grid.rows = grid;
    db.cases = options.cases;
    db.threads = options.threads;
    const DbReconstruction by_distance = reconstruct_by_distance(stack, db, inner);
    experiment.db.push_back(judged(by_distance.surfaces.at(0).surface, by_distance.surfaces[0].report, stack));
    experiment.db.back().grid = grid;
  }
  progress.tell("canal", 1);
  return experiment;
}

}  // namespace odontoscope
