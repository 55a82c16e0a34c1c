#include "recon/partition/reconstruct_partition.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "recon/core/arena.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/parallel.h"
#include "recon/delaunay/certify.h"
#include "recon/delaunay/difference_place.h"
#include "recon/delaunay/look_here.h"
#include "recon/input/validate.h"
#include "recon/mesh/complex_parts.h"
#include "recon/partition/certify_partition.h"
#include "recon/partition/interfaces.h"
#include "recon/partition/interpolate.h"
#include "recon/partition/limits.h"
#include "recon/partition/own_faces.h"
#include "recon/partition/partition_topology.h"
#include "recon/partition/solve_between.h"

namespace odontoscope {
namespace {

using namespace partition;

class PartitionReconstructor {
 public:
  PartitionReconstructor(const OrderedStack& input, Materials materials, Between between, int threads,
                         const Progress& progress)
      : input_(input),
        materials_(std::move(materials)),
        between_(between),
        progress_(progress),
        arena_(arena_of(threads)) {
    result_.threads = threads;
  }

  Reconstruction run() {
    timed("slices", [&] { partition_slices(); });
    timed("links", [&] { follow_links(); });
    timed("slabs", [&] { solve_slabs(); });
    timed("assemble", [&] { assemble(); });
    timed("certify", [&] { certify(); });
    count();
    return std::move(result_);
  }

 private:
  std::size_t structures() const { return materials_.structures.size(); }

  void partition_slices() {
    const std::vector<Slice>& given = input_.stack.slices;
    borders_.resize(given.size());
    slices_.resize(given.size());
    for_each(given.size(), arena_, "slices", progress_, [&](std::size_t k) {
      borders_[k] = overlay(given[k], materials_);
      slices_[k] = planar_partition(borders_[k], given[k].z, progress_);
    });
  }

  void follow_links() {
    left_ = {.stack = own_faces(input_.stack, borders_, materials_), .original_slice = input_.original_slice};
    for (const std::string& structure : materials_.structures)
      implied_.push_back(implied_topology(left_, structure, arena_, progress_));
    if (between_ == Between::blended) interpolator_.emplace(borders_, materials_, input_, arena_, progress_);
  }

  BetweenTask task(std::size_t k) const {
    BetweenTask task{slices_[k], slices_[k + 1], materials_, {}, interpolator_ ? &*interpolator_ : nullptr,
                     k,          place(k)};
    for (const ImpliedTopology& one : implied_) task.implied.push_back(one.of_slab[k]);
    return task;
  }

  void solve_slabs() {
    between_slices_.resize(slices_.size() - 1);
    for_each(between_slices_.size(), arena_, "slabs", progress_,
             [&](std::size_t k) { between_slices_[k] = solve_between(task(k), progress_); });
    std::vector<std::size_t> off;
    for (std::size_t k = 0; k < between_slices_.size(); ++k)
      if (between_slices_[k].off > 0 && between_slices_[k].off <= odontoscope::limits::mendable) off.push_back(k);
    if (off.empty() || !interpolator_ || structures() < 2 || structures() > partition::limits::most_structures / 2)
      return;
    interpolator_->survey_own(arena_, progress_);
    for_each(off.size(), arena_, "slabs", progress_,
             [&](std::size_t i) { improve_between(task(off[i]), between_slices_[off[i]], progress_); });
  }

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

  /// One complex of all slices, given and interpolated, bottom up.
  void assemble() {
    std::vector<const PartitionSlab*> slabs;
    for (std::size_t k = 0; k < slices_.size(); ++k) {
      given_.push_back(all_.size());
      all_.push_back(&slices_[k]);
      if (k + 1 == slices_.size()) break;
      for (const PartitionSlice& slice : between_slices_[k].slices) all_.push_back(&slice);
      for (const PartitionSlab& slab : between_slices_[k].slabs) slabs.push_back(&slab);
    }
    SlabStack stack = stacked(all_, slabs);
    LabelledComplex complex;
    complex.structures = materials_.structures;
    complex.mesh = std::move(stack.mesh);
    complex.interfaces = interfaces_of(complex.mesh);
    first_tetrahedron_ = std::move(stack.tetrahedra);
    first_point_ = std::move(stack.points);
    result_.complex = std::move(complex);
  }

  void certify() {
    const LabelledComplex& complex = *result_.complex;
    const ComplexRanges ranges{first_tetrahedron_, first_point_};
    for_each(all_.size() - 1, arena_, "certify", progress_,
             [&](std::size_t k) { certify_slab(all_, ranges, complex.mesh, k); });
    const std::size_t count = structures();
    result_.solids.resize(count);
    for_each(count + 1, arena_, "certify", progress_, [&](std::size_t s) {
      const auto label = static_cast<Label>(s == count ? void_label : s + 1);
      SurfaceMesh surface = surface_of(complex, label);
      if (surface.triangles.empty()) return;  // others keep its place everywhere
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
    std::erase_if(result_.solids, [](const Solid& solid) { return solid.tetrahedra.tetrahedra.empty(); });
    result_.slices_checked = given_.size();
    result_.certified = true;
    compare_topology();
    drop_unused(*result_.complex);
  }

  void compare_topology() {
    const LabelledComplex& complex = *result_.complex;
    for (std::size_t s = 0; s < structures(); ++s) {
      const std::string& name = materials_.structures[s];
      std::vector<SlabTopology> counted(between_slices_.size());
      for_each(counted.size(), arena_, "certify", progress_, [&](std::size_t k) {
        counted[k] = {
            name, k, implied_[s].of_slab[k], between_slices_[k].found[s], between_slices_[k].slices.size(), false,
            {},   {}};
        if (counted[k].as_implied()) return;
        const LabelledPart part = part_of(complex.mesh, first_tetrahedron_[given_[k]],
                                          first_tetrahedron_[given_[k + 1]], static_cast<Label>(s + 1));
        if (part.tetrahedra.empty()) return;
        counted[k].place = delaunay::place_of_difference(
            {complex.mesh.points, part.tetrahedra, part.boundary, delaunay::holes_beside(left_.stack, k, name)},
            counted[k].implied, counted[k].found);
      });
      result_.topology.insert(result_.topology.end(), counted.begin(), counted.end());
      result_.links.insert(result_.links.end(), implied_[s].links.begin(), implied_[s].links.end());
      result_.void_links.insert(result_.void_links.end(), implied_[s].void_links.begin(), implied_[s].void_links.end());
    }
    for (const ImpliedTopology& one : implied_)
      result_.doubts.insert(result_.doubts.end(), one.doubts.begin(), one.doubts.end());
    result_.attention = delaunay::places_to_look_at(result_, left_.stack, {});
    forget_numbers();
  }

  /// Links and doubts number contours as the partition left them, which the user does not see.
  void forget_numbers() {
    for (Attention& item : result_.attention) {
      item.links.clear();
      if (item.remedy.find("--") != std::string::npos) item.remedy = "Links can be chosen with --independent only.";
    }
    result_.links.clear();
    result_.void_links.clear();
    result_.doubts.clear();
  }

  void count() {
    ReconstructCounts& counts = result_.counts;
    counts.slices = given_.size();
    for (const Slice& slice : input_.stack.slices) {
      counts.contours += slice.contours.size();
      for (const Contour& contour : slice.contours) counts.points += contour.points.size();
    }
    for (const Borders& slice : borders_) {
      result_.partition.crossings += slice.crossings;
      result_.partition.corners_cut += slice.corners_cut;
      result_.partition.closed_gap += slice.closed_gap;
    }
    for (const PartitionSlice* slice : all_) {
      counts.steiner_points += slice->steiner_points;
      counts.constrained_slices += !slice->conforming;
    }
    counts.kept = result_.complex->mesh.tetrahedra.size();
    for (const SolvedBetween& one : between_slices_) {
      bool raised = false;
      for (const PartitionSlab& slab : one.slabs) {
        result_.partition.relabelled += slab.relabelled;
        result_.partition.raised_points += slab.added.size();
        result_.partition.patches += slab.patches;
        result_.partition.cut_slabs += slab.cut;
        raised = raised || !slab.added.empty();
      }
      counts.raised_slabs += raised;
    }
  }

  const OrderedStack& input_;
  const Materials materials_;
  const Between between_;
  const Progress& progress_;
  tbb::task_arena arena_;
  std::vector<Borders> borders_;          // of the given slices
  std::vector<PartitionSlice> slices_;    // given
  OrderedStack left_;                     // contours as the partition leaves them
  std::vector<ImpliedTopology> implied_;  // of each structure
  std::optional<Interpolator> interpolator_;
  std::vector<SolvedBetween> between_slices_;   // above each given slice
  std::vector<const PartitionSlice*> all_;      // given and interpolated, bottom up
  std::vector<std::size_t> given_;              // of each given slice: its number among all
  std::vector<std::size_t> first_tetrahedron_;  // of each of their slabs
  std::vector<std::uint32_t> first_point_;      // of each of them
  Reconstruction result_;
};

}  // namespace

Reconstruction reconstruct_partition(const ContourStack& stack, const PartitionOptions& options,
                                     const Progress& progress) {
  const auto limit = allow_threads(options.threads);
  return reconstruct_partition(validate(stack, progress), options, progress);
}

Reconstruction reconstruct_partition(const ValidStack& stack, const PartitionOptions& options,
                                     const Progress& progress) {
  const int threads = threads_of(options.threads);
  const auto limit = allow_threads(threads);
  const OrderedStack input = ordered(stack);
  return PartitionReconstructor(input, materials_of(input.stack, options.priority, options.gap), options.between,
                                threads, progress)
      .run();
}

}  // namespace odontoscope
