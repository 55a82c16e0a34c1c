#include "measure.h"

#include <algorithm>

#include "recon/core/error.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/validate.h"
#include "recon/mesh/surface_distance.h"
#include "shape_based.h"

namespace odontoscope::test {
namespace {

constexpr double shares[] = {0.25, 0.5, 0.75};
constexpr std::size_t distance_samples = 30'000;
constexpr std::size_t db_grids[] = {64, 128, 256};

/// The planes between the slices, and what truly lies there.
struct Planes {
  std::vector<double> heights;  // slab by slab
  std::vector<Mask> truth;
};

Planes planes_of(const ContourStack& stack, const Truth& truth) {
  Planes planes;
  for (std::size_t slab = 0; slab + 1 < stack.slices.size(); ++slab) {
    const double low = stack.slices[slab].z, high = stack.slices[slab + 1].z;
    for (const double share : shares) planes.heights.push_back(low + share * (high - low));
  }
  planes.truth = truth.masks(planes.heights);
  return planes;
}

void add_area(MethodResult& result, const Truth& truth, const Mask& true_bits, std::size_t structure, const Mask& found) {
  const double cell = truth.raster.step * truth.raster.step;
  std::size_t wrong = 0, own = 0;
  for (std::size_t p = 0; p < found.size(); ++p) {
    const std::uint8_t is = true_bits[p] >> structure & 1;
    own += is;
    wrong += is != found[p];
  }
  result.wrong_area += cell * static_cast<double>(wrong);
  result.own_area += cell * static_cast<double>(own);
}

class Measuring {
 public:
  Measuring(const ContourStack& stack, const Truth& truth, const MeasureOptions& options)
      : stack_(ordered(stack).stack), truth_(truth), options_(options) {
    if (!options.shape) return;
    planes_ = planes_of(stack_, truth);
    surfaces_ = truth.surfaces();
  }

  void take_surface(const std::string& method, const std::string& structure, const SurfaceMesh& surface,
                    const SurfaceReport& report) {
    const auto known = std::find(truth_.names.begin(), truth_.names.end(), structure);
    if (known == truth_.names.end()) return;
    const auto s = static_cast<std::size_t>(known - truth_.names.begin());
    MethodResult& result = of(method)[s];
    result.topology = topology_of(report);
    result.triangles = surface.triangles.size();
    if (!options_.shape) return;
    const SurfaceSections sections(surface, planes_.heights);
    for (std::size_t h = 0; h < planes_.heights.size(); ++h)
      add_area(result, truth_, planes_.truth[h], s, sections.at(truth_.raster, h));
    if (const auto distance = surface_distance(surface, surfaces_[s], {distance_samples})) {
      result.mean = distance->mean();
      result.largest = distance->largest();
    }
  }

  void reconstruct_by_delaunay() {
    try {
      const Reconstruction made = reconstruct(stack_, options_.engine);
      for (const Solid& solid : made.solids) {
        take_surface("DT", solid.structure, solid.surface, solid.report);
      }
    } catch (const Error& error) {
      for (MethodResult& result : of("DT")) result.refused = error.what();
    }
  }

  void reconstruct_by_references() {
    for (const std::size_t points : db_grids) {
      DbOptions options;
      options.grid.columns = options.grid.rows = points;
      options.cases = CaseTable::consistent;
      options.threads = 1;
      const DbReconstruction made = reconstruct_by_distance(stack_, options);
      for (const DbSurface& surface : made.surfaces)
        take_surface("DB " + std::to_string(points), surface.structure, surface.surface, surface.report);
    }
    for (std::size_t s = 0; s < truth_.names.size(); ++s) interpolate(s);
  }

  Results results;

 private:
  std::vector<MethodResult>& of(const std::string& method) {
    std::vector<MethodResult>& found = results[method];
    found.resize(truth_.names.size());
    return found;
  }

  void interpolate(std::size_t s) {
    const ShapeBased shape(stack_, truth_.names[s], truth_.raster);
    for (const auto& [blend, method] : {std::pair{Blend::linear, "SBI linear"}, std::pair{Blend::cubic, "SBI cubic"}}) {
      MethodResult& result = of(method)[s];
      result.topology = shape.topology(blend);
      if (!options_.shape) continue;
      for (std::size_t h = 0; h < planes_.heights.size(); ++h)
        add_area(result, truth_, planes_.truth[h], s,
                 shape.between(h / std::size(shares), shares[h % std::size(shares)], blend));
    }
  }

  ContourStack stack_;
  const Truth& truth_;
  const MeasureOptions& options_;
  Planes planes_;
  std::vector<SurfaceMesh> surfaces_;
};

}  // namespace

Topology topology_of(const SurfaceReport& report) {
  Topology found;
  for (const Shell& shell : report.shells) {
    (shell.kind == Shell::Kind::cavity ? found.bubbles : found.pieces) += 1;
    found.handles += shell.genus;
  }
  return found;
}

Results measure(const ContourStack& stack, const Truth& truth, const MeasureOptions& options) {
  Measuring measuring(stack, truth, options);
  measuring.reconstruct_by_delaunay();
  if (options.references) measuring.reconstruct_by_references();
  return std::move(measuring.results);
}

}  // namespace odontoscope::test
