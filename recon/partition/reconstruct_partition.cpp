#include "recon/partition/reconstruct_partition.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "recon/core/error.h"
#include "recon/core/parallel.h"
#include "recon/delaunay/certify.h"
#include "recon/delaunay/look_here.h"
#include "recon/input/validate.h"
#include "recon/partition/certify_partition.h"
#include "recon/partition/complex_parts.h"
#include "recon/partition/corners.h"
#include "recon/partition/face_contours.h"
#include "recon/partition/inner_first.h"
#include "recon/partition/interpolate.h"
#include "recon/partition/limits.h"
#include "recon/partition/partition_slab.h"
#include "recon/partition/partition_topology.h"

namespace odontoscope {
namespace {

using namespace partition;

/// Those that are named first, then the others from the inside out.
Materials materials_of(const ContourStack& stack, const PartitionOptions& options) {
  Materials materials;
  materials.structures = structures_of(stack);
  materials.gap = options.gap;
  const std::size_t count = materials.structures.size();
  Place place;
  place.file = stack.source;
  if (count > partition::limits::most_structures)
    throw InputError("too-many-structures", place, fmt::format("a partition of {} structures; at most {} are supported", count, partition::limits::most_structures),
                     "Leave some out, or reconstruct them independently");
  for (const std::string& name : options.priority)
    if (std::find(materials.structures.begin(), materials.structures.end(), name) == materials.structures.end())
      throw InputError("unknown-structure", place, fmt::format("no structure is called \"{}\"", name),
                       fmt::format("The structures are: {}", fmt::join(materials.structures, ", ")));
  std::vector<std::uint32_t> order = inner_first(stack, materials.structures);
  const auto named = [&](std::uint32_t s) {
    return std::find(options.priority.begin(), options.priority.end(), materials.structures[s]) - options.priority.begin();
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return named(a) < named(b); });
  materials.rank.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) materials.rank[order[i]] = i;
  return materials;
}

class PartitionReconstructor {
 public:
  PartitionReconstructor(const OrderedStack& input, Materials materials, Between between, int threads, const Progress& progress)
      : input_(input), materials_(std::move(materials)), between_(between), progress_(progress), arena_(threads) {
    result_.threads = threads;
  }

  Reconstruction run() {
    timed("slices", [&] { overlay_slices(); });
    if (between_ == Between::blended) timed("interpolate", [&] { interpolated_ = interpolate(borders_, materials_, input_, arena_, progress_); });
    timed("slabs", [&] { solve_slabs(); });
    timed("assemble", [&] { assemble(); });
    timed("certify", [&] { certify(); });
    timed("topology", [&] { compare_topology(); });
    count();
    return std::move(result_);
  }

 private:
  void overlay_slices() {
    const std::vector<Slice>& given = input_.stack.slices;
    borders_.resize(given.size());
    interpolated_.resize(given.size() - 1);
    for_each(given.size(), arena_, "slices", progress_, [&](std::size_t k) {
      borders_[k] = overlay(given[k], materials_);
      part_corners(borders_[k], materials_);
    });
  }

  /// Given slices and those between them, bottom up.
  void solve_slabs() {
    std::vector<std::pair<const Borders*, double>> all;
    for (std::size_t k = 0; k < borders_.size(); ++k) {
      given_.push_back(all.size());
      all.emplace_back(&borders_[k], input_.stack.slices[k].z);
      if (k + 1 == borders_.size()) break;
      for (const InterpolatedBorders& one : interpolated_[k]) all.emplace_back(&one.borders, one.z);
    }
    slices_.resize(all.size());
    for_each(all.size(), arena_, "slices", progress_,
             [&](std::size_t i) { slices_[i] = planar_partition(*all[i].first, all[i].second, progress_); });
    slabs_.resize(all.size() - 1);
    for_each(slabs_.size(), arena_, "slabs", progress_, [&](std::size_t i) {
      slabs_[i] = solve_partition_slab(slices_[i], slices_[i + 1], materials_, place(i), progress_);
    });
  }

  template <class Work>
  void timed(const char* stage, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    result_.seconds.push_back({stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
  }

  /// Of a slab, which may lie between interpolated slices.
  Place place(std::size_t slab) const {
    const std::size_t k = static_cast<std::size_t>(std::upper_bound(given_.begin(), given_.end(), slab) - given_.begin()) - 1;
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
    result_.slices_checked = given_.size();
    result_.certified = true;
  }

  /// The contours as the partition leaves them, structure after structure.
  OrderedStack effective() const {
    OrderedStack stack;
    stack.original_slice = input_.original_slice;
    stack.stack.source = input_.stack.source;
    for (std::size_t k = 0; k < borders_.size(); ++k) {
      stack.stack.slices.push_back({input_.stack.slices[k].z, {}});
      auto& contours = stack.stack.slices.back().contours;
      for (Label l = 1; l <= materials_.structures.size(); ++l) {
        const auto own = face_contours(borders_[k], materials_.structures[l - 1], [l](Label label) { return label == l; });
        contours.insert(contours.end(), own.begin(), own.end());
      }
    }
    return stack;
  }

  void compare_topology() {
    const OrderedStack stack = effective();
    std::vector<std::size_t> first;
    for (const std::size_t slice : given_) first.push_back(ranges_.tetrahedra[slice]);
    for (Label l = 1; l <= materials_.structures.size(); ++l) {
      std::vector<SlabTopology> counted = count_topology(stack, materials_.structures[l - 1], l, *result_.complex, first, result_.links,
                                                         result_.void_links, arena_, progress_);
      for (SlabTopology& slab : counted) slab.interpolated = interpolated_[slab.slice].size();
      result_.topology.insert(result_.topology.end(), counted.begin(), counted.end());
    }
    result_.attention = delaunay::places_to_look_at(result_, stack.stack, {});
  }

  void count() {
    ReconstructCounts& counts = result_.counts;
    counts.slices = given_.size();
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
  const Between between_;
  const Progress& progress_;
  tbb::task_arena arena_;
  std::vector<Borders> borders_;                               // of the given slices
  std::vector<std::vector<InterpolatedBorders>> interpolated_;   // above each
  std::vector<std::size_t> given_;                             // of each given slice: its number among all
  std::vector<PartitionSlice> slices_;                         // all, bottom up
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
  return PartitionReconstructor(input, materials_of(input.stack, options), options.between, threads, progress).run();
}

}  // namespace odontoscope
