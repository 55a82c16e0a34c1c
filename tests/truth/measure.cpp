#include "measure.h"

#include <algorithm>
#include <cmath>

#include "recon/core/error.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/validate.h"
#include "recon/mesh/surface_distance.h"
#include "recon/mesh/vector.h"
#include "recon/partition/reconstruct_partition.h"
#include "shape_based.h"
#include "visible.h"

namespace odontoscope::test {
namespace {

constexpr double shares[] = {0.25, 0.5, 0.75};
constexpr std::size_t distance_samples = 20'000;
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

/// `found_at` gives what was made of the plane of that number.
template <class FoundAt>
void add_areas(MethodResult& result, const Truth& truth, const Planes& planes, std::size_t structure,
               const FoundAt& found_at) {
  const double cell = truth.raster.step * truth.raster.step;
  double of_slab = 0;
  for (std::size_t h = 0; h < planes.heights.size(); ++h) {
    const Mask found = found_at(h);
    std::size_t wrong = 0, own = 0;
    for (std::size_t p = 0; p < found.size(); ++p) {
      const std::uint8_t is = planes.truth[h][p] >> structure & 1;
      own += is;
      wrong += is != found[p];
    }
    result.own_area += cell * static_cast<double>(own);
    result.wrong_area += cell * static_cast<double>(wrong);
    of_slab = (h % std::size(shares) == 0 ? 0 : of_slab) + cell * static_cast<double>(wrong);
    if (of_slab <= result.worst_area) continue;
    result.worst_area = of_slab;
    result.worst_slab = h / std::size(shares);
  }
}

/// Points spread evenly over a surface's area: at equal steps of accumulated area, within a triangle by a sequence of
/// low discrepancy. Not its vertices: those of DT lie on contours, and would tell of the contours alone.
std::vector<Point3> spread_over(const SurfaceMesh& mesh) {
  std::vector<double> areas;
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    areas.push_back(area += length(cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a])) / 2);
  std::vector<Point3> points;
  constexpr double golden = 0.7548776662466927, golden2 = 0.5698402909980532;  // of the plane's golden sequence
  for (std::size_t i = 0; i < distance_samples && area > 0; ++i) {
    const double target = area * (static_cast<double>(i) + 0.5) / static_cast<double>(distance_samples);
    const auto t = static_cast<std::size_t>(std::lower_bound(areas.begin(), areas.end(), target) - areas.begin());
    double u = std::fmod(golden * static_cast<double>(i + 1), 1.0),
           v = std::fmod(golden2 * static_cast<double>(i + 1), 1.0);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto [a, b, c] = mesh.triangles[std::min(t, areas.size() - 1)];
    const Point3& p = mesh.points[a];
    const Direction d = u * (mesh.points[b] - p) + v * (mesh.points[c] - p);
    points.push_back({p.x + d.x, p.y + d.y, p.z + d.z});
  }
  return points;
}

/// `on_truth`: points spread over the true surface.
void add_distances(MethodResult& result, const SurfaceMesh& surface, const SurfaceMesh& truth,
                   const std::vector<Point3>& on_truth) {
  const auto there = distance_to_surface(spread_over(surface), truth);
  const auto back = distance_to_surface(on_truth, surface);
  if (!there || !back) return;
  result.mean = std::max(there->mean, back->mean);
  result.largest = std::max(there->largest, back->largest);
}

class Measuring {
 public:
  Measuring(const ContourStack& stack, const Truth& truth, const MeasureOptions& options)
      : stack_(ordered(stack).stack), truth_(truth), options_(options) {
    if (!options.shape) return;
    planes_ = planes_of(stack_, truth);
    surfaces_ = truth.surfaces();
    for (const SurfaceMesh& surface : surfaces_) on_surfaces_.push_back(spread_over(surface));
  }

  void take_surface(const std::string& method, const std::string& structure, const SurfaceMesh& surface,
                    const SurfaceReport& report) {
    const auto known = std::find(truth_.names.begin(), truth_.names.end(), structure);
    if (known == truth_.names.end()) return;
    const auto s = static_cast<std::size_t>(known - truth_.names.begin());
    take_mesh(method, s, surface, report);
    if (!options_.shape) return;
    const SurfaceSections sections(surface, planes_.heights);
    add_areas(of(method)[s], truth_, planes_, s, [&](std::size_t h) { return sections.at(truth_.raster, h); });
  }

  void reconstruct_by_delaunay(Between way) {
    ReconstructOptions engine = options_.engine;
    engine.between = way;
    take(method_name(way), [&] { return reconstruct(stack_, engine); });
  }

  void reconstruct_as_partition(const ContourStack& shared) {
    take("DT partition", [&] { return reconstruct_partition(shared, {.threads = options_.engine.threads}); });
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
  template <class Make>
  void take(const std::string& method, Make make) {
    try {
      const Reconstruction made = make();
      for (const Solid& solid : made.solids) take_surface(method, solid.structure, solid.surface, solid.report);
      for (const Attention& item : made.attention) {
        for (std::size_t s = 0; s < truth_.names.size(); ++s)
          if (truth_.names[s] == item.structure) of(method)[s].warned = true;
      }
    } catch (const Error& error) {
      for (MethodResult& result : of(method)) result.refused = error.what();
    }
  }

  std::vector<MethodResult>& of(const std::string& method) {
    std::vector<MethodResult>& found = results.methods[method];
    found.resize(truth_.names.size());
    return found;
  }

  void take_mesh(const std::string& method, std::size_t s, const SurfaceMesh& surface, const SurfaceReport& report) {
    MethodResult& result = of(method)[s];
    result.topology = topology_of(report);
    result.triangles = surface.triangles.size();
    if (options_.shape) add_distances(result, surface, surfaces_[s], on_surfaces_[s]);
  }

  void interpolate(std::size_t s) {
    const ShapeBased shape(stack_, truth_.names[s], truth_.raster);
    for (const auto& [blend, method] : {std::pair{Blend::linear, "SBI linear"}, std::pair{Blend::cubic, "SBI cubic"}}) {
      const SurfaceMesh surface = shape.surface(blend);
      take_mesh(method, s, surface, inspect(surface));
      if (!options_.shape) continue;
      add_areas(of(method)[s], truth_, planes_, s, [&, blend = blend](std::size_t h) {
        return shape.between(h / std::size(shares), shares[h % std::size(shares)], blend);
      });
    }
  }

  ContourStack stack_;
  const Truth& truth_;
  const MeasureOptions& options_;
  Planes planes_;
  std::vector<SurfaceMesh> surfaces_;
  std::vector<std::vector<Point3>> on_surfaces_;
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

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names{"DT plain", "DT blended", "DT partition", "DB 64",
                                              "DB 128",   "DB 256",     "SBI linear",   "SBI cubic"};
  return names;
}

const char* method_name(Between way) { return way == Between::delaunay ? "DT plain" : "DT blended"; }

MethodResult measure_surface(const SurfaceMesh& surface, const SurfaceReport& report, const Truth& truth,
                             std::size_t structure) {
  MethodResult result;
  if (report.closed_oriented_manifold()) result.topology = topology_of(report);
  result.triangles = surface.triangles.size();
  const SurfaceMesh own = truth.surfaces().at(structure);
  add_distances(result, surface, own, spread_over(own));
  return result;
}

Results measure(const ContourStack& stack, const Truth& truth, const MeasureOptions& options,
                const ContourStack* shared) {
  Measuring measuring(stack, truth, options);
  for (const Between way : options.ways) measuring.reconstruct_by_delaunay(way);
  if (shared) measuring.reconstruct_as_partition(*shared);
  if (options.references) measuring.reconstruct_by_references();
  measuring.results.visible = visible(ordered(stack).stack, truth);
  return std::move(measuring.results);
}

}  // namespace odontoscope::test
