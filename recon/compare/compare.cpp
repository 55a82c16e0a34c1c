#include "recon/compare/compare.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "recon/compare/peak_memory.h"
#include "recon/core/arena.h"
#include "recon/delaunay/verdict.h"
#include "recon/input/validate.h"
#include "recon/mesh/append.h"

namespace odontoscope {
namespace {

/// Runs `make` once to three times; the least time, and the peak of the first run.
template <class Make>
auto timed(ComparedMethod& method, Make make) {
  constexpr int most_runs = 3;
  constexpr double long_enough = 1;  // second
  using Clock = std::chrono::steady_clock;
  std::optional<decltype(make())> made;
  for (int run = 0; run < most_runs; ++run) {
    made.reset();
    double seconds = 0;
    const auto work = [&] {
      const auto start = Clock::now();
      made.emplace(make());
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    };
    if (run == 0) {
      method.peak_memory = peak_memory_of(work);
    } else {
      work();
    }
    method.seconds = run == 0 ? seconds : std::min(method.seconds, seconds);
    if (seconds > long_enough) break;
  }
  return std::move(*made);
}

/// What a solid's pieces, handles and bubbles come to, over all of its surfaces.
struct ShellCounts {
  std::size_t external = 0, cavities = 0;
  long genus = 0;
  explicit ShellCounts(const SurfaceReport& report) {
    for (const Shell& shell : report.shells) {
      ++(shell.kind == Shell::Kind::cavity ? cavities : external);
      genus += shell.genus;
    }
  }
  friend bool operator==(const ShellCounts&, const ShellCounts&) = default;
};

/// By structure; those alone that DT has as its links imply.
using ImpliedShells = std::map<std::string, ShellCounts>;

ComparedMethod run_dt(const ValidStack& stack, const CompareOptions& options, ImpliedShells& implied,
                      const Progress& progress) {
  ComparedMethod method;
  method.name = std::string("DT");
  method.made_by = fmt::format("Delaunay, correspondence {}, between slices {}", name(options.dt.correspondence),
                               options.dt.between == Between::blended ? "blended" : "Delaunay alone");
  Reconstruction made = timed(method, [&] { return reconstruct(stack, options.dt, progress); });
  method.certified = made.certified;
  method.verdict = headline(made);
  std::set<std::string> otherwise;
  for (const SlabTopology& slab : made.topology)
    if (!slab.as_implied()) otherwise.insert(slab.structure);
  for (const Solid& solid : made.solids)
    if (!otherwise.contains(solid.structure)) implied.emplace(solid.structure, ShellCounts(solid.report));
  method.topology = {implied.size(), implied.size()};
  for (Solid& solid : made.solids) method.surfaces.push_back({solid.structure, std::move(solid.surface)});
  return method;
}

ComparedMethod run_db(const ValidStack& stack, const DbOptions& options, std::string name_of_it,
                      const ImpliedShells& implied, const Progress& progress) {
  ComparedMethod method;
  method.name = std::move(name_of_it);
  method.made_by = fmt::format("grid {} x {}, field {}, table {}", options.grid.columns, options.grid.rows,
                               name(options.field.kind), name(options.cases));
  DbReconstruction made = timed(method, [&] { return reconstruct_by_distance(stack, options, progress); });
  method.certified = made.certified;
  method.topology.known = implied.size();
  for (DbSurface& one : made.surfaces) {
    const SurfaceReport report = inspect(one.surface);
    const auto known = implied.find(one.structure);
    method.topology.as_implied +=
        known != implied.end() && report.closed_oriented_manifold() && known->second == ShellCounts(report);
    method.surfaces.push_back({one.structure, std::move(one.surface)});
  }
  return method;
}

SurfaceMesh as_one(const std::vector<ComparedSurface>& surfaces) {
  SurfaceMesh whole;
  for (const ComparedSurface& one : surfaces) append(one.surface, whole);
  return whole;
}

void judge(ComparedMethod& method, const ContourStack& sorted, const DistanceOptions& options,
           const Progress& progress) {
  method.report = inspect(as_one(method.surfaces));
  std::vector<WeightedFit> fits;
  for (const ComparedSurface& one : method.surfaces) {
    fits.push_back(
        {contour_fit(sorted, one.structure, one.surface, options, progress), contour_length(sorted, one.structure)});
  }
  method.fit = joined(fits);
}

double area_of(const SurfaceMesh& surface) {
  double sum = 0;
  for (const Shell& shell : inspect(surface).shells) sum += shell.area;
  return sum;
}

ComparedPair measure_pair(const std::vector<ComparedMethod>& methods, std::size_t first, std::size_t second,
                          const DistanceOptions& options, const Progress& progress) {
  ComparedPair pair{first, second, {}};
  double weight = 0;
  for (std::size_t i = 0; i < methods[first].surfaces.size(); ++i) {
    const SurfaceMesh &a = methods[first].surfaces[i].surface, &b = methods[second].surfaces[i].surface;
    const auto distance = surface_distance(a, b, options, progress);
    if (!distance) continue;
    const double area = area_of(a);
    weight += area;
    const auto join = [area](OneWayDistance& whole, const OneWayDistance& part) {
      whole.largest = std::max(whole.largest, part.largest);
      whole.mean += area * part.mean;
    };
    join(pair.distance.a_to_b, distance->a_to_b);
    join(pair.distance.b_to_a, distance->b_to_a);
  }
  if (weight > 0) {
    pair.distance.a_to_b.mean /= weight;
    pair.distance.b_to_a.mean /= weight;
  }
  return pair;
}

Comparison run(const ValidStack& stack, const CompareOptions& options, const Progress& progress) {
  const ContourStack sorted = ordered(stack).stack;
  Comparison result;
  result.source = stack->source;
  result.slices = sorted.slices.size();
  for (const Slice& slice : sorted.slices) {
    result.contours += slice.contours.size();
    for (const Contour& contour : slice.contours) result.points += contour.points.size();
  }
  result.grid = make_grid(sorted, options.db.grid);
  result.cases = options.db.cases;
  result.field = options.db.field.kind;
  DbOptions full = options.db, fewer = options.db;
  full.decimation.reset();
  if (!fewer.decimation) fewer.decimation = DecimateOptions{};
  ImpliedShells implied;
  result.methods.push_back(run_dt(stack, options, implied, progress));
  result.methods.push_back(run_db(stack, full, "DB", implied, progress));
  result.methods.push_back(run_db(stack, fewer, "DB decimated", implied, progress));
  result.methods.back().made_by += fewer.decimation->triangles
                                       ? fmt::format(", decimated to {}", *fewer.decimation->triangles)
                                       : ", decimated to the most possible";
  for (ComparedMethod& method : result.methods) judge(method, sorted, options.distance, progress);
  for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    result.pairs.push_back(measure_pair(result.methods, static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                                        options.distance, progress));
  }
  return result;
}

}  // namespace

Comparison compare(const ContourStack& stack, const CompareOptions& options, const Progress& progress) {
  const auto limit = allow_threads(options.dt.threads);
  return compare(validate(stack, progress), options, progress);
}

Comparison compare(const ValidStack& stack, const CompareOptions& options, const Progress& progress) {
  CompareOptions with_threads = options;
  const int threads = threads_of(options.dt.threads);
  with_threads.dt.threads = with_threads.db.threads = threads;
  const auto limit = allow_threads(threads);
  tbb::task_arena arena = arena_of(threads);
  Comparison result = arena.execute([&] { return run(stack, with_threads, progress); });
  result.threads = threads;
  return result;
}

}  // namespace odontoscope
