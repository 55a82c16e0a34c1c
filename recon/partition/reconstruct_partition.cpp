#include "recon/partition/reconstruct_partition.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

#include "recon/core/error.h"
#include "recon/core/parallel.h"
#include "recon/delaunay/certify.h"
#include "recon/input/validate.h"
#include "recon/partition/certify_partition.h"
#include "recon/partition/complex_parts.h"
#include "recon/partition/limits.h"
#include "recon/partition/partition_slab.h"

namespace odontoscope {
namespace {

using namespace partition;

double area_of(const Contour& contour) {
  double twice = 0;
  const auto& p = contour.points;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 a = p[i], b = p[(i + 1) % p.size()];
    twice += (a.x - p[0].x) * (b.y - p[0].y) - (a.y - p[0].y) * (b.x - p[0].x);
  }
  return twice / 2;
}

/// Those that are named first; of the others the one with the least area in all slices first, which lies within the others if any does.
Materials materials_of(const ContourStack& stack, const PartitionOptions& options) {
  Materials materials;
  materials.structures = structures_of(stack);
  materials.gap = options.gap;
  const std::size_t count = materials.structures.size();
  Place place;
  place.file = stack.source;
  if (count > limits::most_structures)
    throw InputError("too-many-structures", place, fmt::format("a partition of {} structures; at most {} are supported", count, limits::most_structures),
                     "Leave some out, or reconstruct them independently");
  for (const std::string& name : options.priority)
    if (std::find(materials.structures.begin(), materials.structures.end(), name) == materials.structures.end())
      throw InputError("unknown-structure", place, fmt::format("no structure is called \"{}\"", name),
                       fmt::format("The structures are: {}", fmt::join(materials.structures, ", ")));
  std::vector<double> area(count, 0);
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) {
      const auto found = std::find(materials.structures.begin(), materials.structures.end(), contour.structure);
      area[static_cast<std::size_t>(found - materials.structures.begin())] += area_of(contour);
    }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  const auto named = [&](std::uint32_t s) {
    return std::find(options.priority.begin(), options.priority.end(), materials.structures[s]) - options.priority.begin();
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return named(a) != named(b) ? named(a) < named(b) : area[a] < area[b];
  });
  materials.rank.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) materials.rank[order[i]] = i;
  return materials;
}

class PartitionReconstructor {
 public:
  PartitionReconstructor(const OrderedStack& input, Materials materials, int threads, const Progress& progress)
      : input_(input), materials_(std::move(materials)), progress_(progress), arena_(threads) {
    result_.threads = threads;
  }

  Reconstruction run() {
    const std::vector<Slice>& given = input_.stack.slices;
    slices_.resize(given.size());
    timed("slices", [&] {
      for_each(given.size(), arena_, "slices", progress_, [&](std::size_t k) {
        slices_[k] = planar_partition(given[k], materials_, input_.original_slice[k], input_.stack.source, progress_);
      });
    });
    slabs_.resize(given.size() - 1);
    timed("slabs", [&] {
      for_each(slabs_.size(), arena_, "slabs", progress_, [&](std::size_t k) {
        slabs_[k] = solve_partition_slab(slices_[k], slices_[k + 1], materials_, place(k), progress_);
      });
    });
    timed("assemble", [&] { assemble(); });
    timed("certify", [&] { certify(); });
    count();
    return std::move(result_);
  }

 private:
  template <class Work>
  void timed(const char* stage, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    result_.seconds.push_back({stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
  }

  Place place(std::size_t k) const {
    Place where;
    where.file = input_.stack.source;
    where.slice = input_.original_slice[k];
    where.z = input_.stack.slices[k].z;
    return where;
  }

  // ---- one complex --------------------------------------------------------------------------------------------------

  /// Points slice by slice, then those that each slab added; what no tetrahedron has is left out last.
  void assemble() {
    LabelledComplex complex;
    complex.structures = materials_.structures;
    std::uint64_t count = 0;
    for (const PartitionSlice& slice : slices_) count += slice.planar.points.size();
    const std::uint64_t on_slices = count;
    for (const PartitionSlab& slab : slabs_) count += slab.added.size();
    if (count >= delaunay::none) throw InternalError("more points than 32-bit numbers can count");
    TetraMesh& mesh = complex.mesh;
    mesh.points.reserve(count);
    for (const PartitionSlice& slice : slices_) {
      ranges_.points.push_back(static_cast<std::uint32_t>(mesh.points.size()));
      for (const Point2 p : slice.planar.points) mesh.points.push_back({p.x, p.y, slice.z});
    }
    ranges_.points.push_back(static_cast<std::uint32_t>(on_slices));
    for (std::size_t k = 0; k < slabs_.size(); ++k) {
      const PartitionSlab& slab = slabs_[k];
      const std::uint32_t first = ranges_.points[k], in_slices = ranges_.points[k + 2] - first;
      const auto first_added = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.insert(mesh.points.end(), slab.added.begin(), slab.added.end());
      ranges_.tetrahedra.push_back(mesh.tetrahedra.size());
      for (Tetrahedron tet : slab.tetrahedra) {
        for (std::uint32_t& v : tet) v = v < in_slices ? first + v : first_added + (v - in_slices);
        mesh.tetrahedra.push_back(tet);
      }
      mesh.labels.insert(mesh.labels.end(), slab.labels.begin(), slab.labels.end());
    }
    ranges_.tetrahedra.push_back(mesh.tetrahedra.size());
    complex.interfaces = interfaces_of(mesh);
    result_.complex = std::move(complex);
  }

  void certify() {
    const LabelledComplex& complex = *result_.complex;
    for_each(slabs_.size(), arena_, "certify", progress_, [&](std::size_t k) { certify_slab(slices_, ranges_, complex.mesh, k); });
    const std::size_t count = materials_.structures.size();
    result_.solids.resize(count);
    for_each(count + 1, arena_, "certify", progress_, [&](std::size_t s) {
      const auto label = static_cast<Label>(s == count ? void_label : s + 1);
      SurfaceMesh surface = surface_of(complex, label);
      SurfaceReport report = inspect(surface);
      delaunay::certify_surface(report, s == count ? "all structures together" : materials_.structures[s]);
      if (s == count) return;
      Solid& solid = result_.solids[s];
      solid.structure = materials_.structures[s];
      solid.tetrahedra = tetrahedra_of(complex, label);
      solid.surface = std::move(surface);
      solid.report = std::move(report);
      for (Shell& shell : solid.report.shells) shell.structure = solid.structure;
    });
    result_.slices_checked = slices_.size();
    result_.certified = true;
  }

  void count() {
    ReconstructCounts& counts = result_.counts;
    counts.slices = slices_.size();
    for (const Slice& slice : input_.stack.slices) {
      counts.contours += slice.contours.size();
      for (const Contour& contour : slice.contours) counts.points += contour.points.size();
    }
    for (const PartitionSlice& slice : slices_) {
      counts.steiner_points += slice.steiner_points;
      counts.constrained_slices += !slice.conforming;
    }
    counts.kept = result_.complex->mesh.tetrahedra.size();
    for (const PartitionSlab& slab : slabs_) {
      counts.restored += slab.relabelled;
      counts.lifted_points += slab.added.size();
      counts.raised_slabs += !slab.added.empty();
    }
  }

  const OrderedStack& input_;
  const Materials materials_;
  const Progress& progress_;
  tbb::task_arena arena_;
  std::vector<PartitionSlice> slices_;
  std::vector<PartitionSlab> slabs_;
  ComplexRanges ranges_;
  Reconstruction result_;
};

}  // namespace

Reconstruction reconstruct_partition(const ContourStack& stack, const PartitionOptions& options, const Progress& progress) {
  const int threads = options.threads > 0 ? options.threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  validate(stack, progress);
  const OrderedStack input = ordered(stack);
  return PartitionReconstructor(input, materials_of(input.stack, options), threads, progress).run();
}

}  // namespace odontoscope
