#include "recon/delaunay/reconstruct.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "recon/core/arena.h"
#include "recon/core/limits.h"
#include "recon/core/parallel.h"
#include "recon/delaunay/assemble.h"
#include "recon/delaunay/certify.h"
#include "recon/delaunay/difference_place.h"
#include "recon/delaunay/look_here.h"
#include "recon/delaunay/solve_stack.h"
#include "recon/delaunay/topology.h"
#include "recon/input/validate.h"

namespace odontoscope {
namespace {

using namespace delaunay;

class Stopwatch {
 public:
  explicit Stopwatch(std::vector<StageTime>& times) : times_(times), start_(Clock::now()) {}

  /// Books the time since the last lap (or the start) on `stage`.
  void lap(const char* stage) {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    const auto known =
        std::find_if(times_.begin(), times_.end(), [stage](const StageTime& t) { return t.stage == stage; });
    if (known != times_.end())
      known->seconds += seconds;
    else
      times_.push_back({stage, seconds});
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<StageTime>& times_;
  Clock::time_point start_;
};

class Reconstructor {
 public:
  Reconstructor(const OrderedStack& input, const ReconstructOptions& options, int threads, const Progress& progress)
      : input_(input), options_(options), progress_(progress), arena_(arena_of(threads)), watch_(result_.seconds) {
    result_.threads = threads;
  }

  Reconstruction run() {
    const std::vector<std::string> structures = structures_of(input_.stack);
    result_.counts.slices = input_.stack.slices.size();
    for (std::size_t s = 0; s < structures.size(); ++s) reconstruct_structure(structures[s], static_cast<Label>(s + 1));
    result_.slices_checked = input_.stack.slices.size();
    result_.certified = true;
    result_.attention = places_to_look_at(result_, input_.stack, options_);
    watch_.lap("certify");
    return std::move(result_);
  }

 private:
  void reconstruct_structure(const std::string& structure, Label label) {
    SolvedStructure solved = solve_stack({input_, structure, options_}, arena_, progress_);
    watch_.lap("slabs");
    result_.links.insert(result_.links.end(), solved.links.begin(), solved.links.end());
    result_.void_links.insert(result_.void_links.end(), solved.void_links.begin(), solved.void_links.end());
    result_.doubts.insert(result_.doubts.end(), solved.doubts.begin(), solved.doubts.end());
    result_.remedies.insert(result_.remedies.end(), solved.remedies.begin(), solved.remedies.end());
    add(solved.counts);
    result_.solids.push_back(assemble_and_certify(solved, structure, label));
  }

  void add(const ReconstructCounts& counts) {
    ReconstructCounts& all = result_.counts;
    all.contours += counts.contours;
    all.points += counts.points;
    all.steiner_points += counts.steiner_points;
    all.restored += counts.restored;
    all.lifted_points += counts.lifted_points;
    all.trimmed += counts.trimmed;
    all.cut_links += counts.cut_links;
    all.isolated_regions += counts.isolated_regions;
    all.raised_slabs += counts.raised_slabs;
    all.constrained_slices += counts.constrained_slices;
    all.largest_sideways = std::max(all.largest_sideways, counts.largest_sideways);
  }

  // ---- result -------------------------------------------------------------------------------------------------------

  void certify_sections(const SolvedStack& stack, const Numbering& numbering, const std::vector<AssembledSlab>& slabs,
                        const TetraMesh& mesh) {
    for_each(slabs.size(), arena_, "certify", progress_,
             [&](std::size_t k) { certify_slab(stack, numbering, slabs[k], mesh, k); });
    for_each(stack.slices.size(), arena_, "certify", progress_, [&](std::size_t k) {
      certify_contours(stack.slices[k], input_.stack.slices[k]);
      certify_slice(stack, numbering, k > 0 ? &slabs[k - 1] : nullptr, k < slabs.size() ? &slabs[k] : nullptr, k);
    });
  }

  /// Counts what each slab's solid is like, beside what it should be.
  void count_topology(std::vector<SlabTopology>& topology, const std::vector<AssembledSlab>& slabs,
                      const Numbering& numbering, const std::vector<Point3>& points) {
    for_each(slabs.size(), arena_, "certify", progress_, [&](std::size_t k) {
      std::vector<Triangle> boundary = slabs[k].sides;
      boundary.insert(boundary.end(), slabs[k].floor.begin(), slabs[k].floor.end());
      boundary.insert(boundary.end(), slabs[k].ceiling.begin(), slabs[k].ceiling.end());
      const PointRanges ranges{numbering.slice_begin[k], numbering.slice_begin[k + 2], numbering.added_begin[k],
                               numbering.added_begin[k + 1]};
      topology[k].found = topology[k].untrimmed ? counted_topology_of_pinched(slabs[k].tetrahedra, boundary)
                                                : counted_topology(slabs[k].tetrahedra, boundary, ranges);
      if (topology[k].as_implied()) return;
      topology[k].place = place_of_difference(
          {points, slabs[k].tetrahedra, boundary, holes_beside(input_.stack, k, topology[k].structure)},
          topology[k].implied, topology[k].found);
    });
    result_.topology.insert(result_.topology.end(), topology.begin(), topology.end());
  }

  /// Adds slabs that were raised or interpolated to what was trimmed.
  void tell_changes(SolvedStructure& solved, const std::vector<AssembledSlab>& slabs,
                    const std::vector<Point3>& points) {
    std::vector<SlabChange> changes = std::move(solved.changes);
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      const SlabTopology& slab = solved.topology[k];
      if (!slab.raised && slab.interpolated == 0) continue;
      const Mass mass = mass_of(points, slabs[k].tetrahedra);
      const SlabChange change{SlabChange::Kind::raised,     slab.structure, k,           input_.stack.slices[k].z,
                              input_.stack.slices[k + 1].z, mass.centre,    mass.volume, 0};
      if (slab.raised) changes.push_back(change);
      if (slab.interpolated == 0) continue;
      changes.push_back(change);
      changes.back().kind = SlabChange::Kind::interpolated;
      changes.back().count = slab.interpolated;
    }
    std::stable_sort(changes.begin(), changes.end(), [](const SlabChange& a, const SlabChange& b) {
      return std::pair(a.slice, a.kind) < std::pair(b.slice, b.kind);
    });
    result_.changes.insert(result_.changes.end(), changes.begin(), changes.end());
  }

  Solid assemble_and_certify(SolvedStructure& solved, const std::string& structure, Label label) {
    const SolvedStack& stack = solved.stack;
    const Numbering numbering(stack);
    std::vector<AssembledSlab> slabs(stack.slabs.size());
    for_each(slabs.size(), arena_, "assemble", progress_,
             [&](std::size_t k) { slabs[k] = assemble_slab(stack, numbering, k); });
    Assembly assembly = arena_.execute([&] { return assemble(stack, numbering, slabs, label); });
    watch_.lap("assemble");

    Solid solid;
    solid.structure = structure;
    arena_.execute([&] {  // the two proofs are about equally long
      tbb::parallel_invoke([&] { solid.report = inspect(assembly.surface); },
                           [&] { certify_sections(stack, numbering, slabs, assembly.tetrahedra); });
    });
    certify_surface(solid.report, structure);
    tell_changes(solved, slabs, assembly.tetrahedra.points);
    count_topology(solved.topology, slabs, numbering, assembly.tetrahedra.points);
    for (Shell& shell : solid.report.shells) shell.structure = structure;
    result_.counts.kept += assembly.tetrahedra.tetrahedra.size();
    solid.tetrahedra = std::move(assembly.tetrahedra);
    solid.surface = std::move(assembly.surface);
    watch_.lap("certify");
    return solid;
  }

  const OrderedStack& input_;
  const ReconstructOptions& options_;
  const Progress& progress_;
  tbb::task_arena arena_;
  Reconstruction result_;
  Stopwatch watch_;
};

}  // namespace

Reconstruction reconstruct(const ContourStack& stack, const ReconstructOptions& options, const Progress& progress) {
  const auto limit = allow_threads(options.threads);  // holds for validation too
  return reconstruct(validate(stack, progress), options, progress);
}

Reconstruction reconstruct(const ValidStack& stack, const ReconstructOptions& options, const Progress& progress) {
  const int threads = threads_of(options.threads);
  const auto limit = allow_threads(threads);
  std::vector<StageTime> preparation;
  Stopwatch watch(preparation);
  const OrderedStack input = ordered(stack);
  validate_links(options.links, input.stack);
  watch.lap("validate");
  Reconstruction result = Reconstructor(input, options, threads, progress).run();
  result.seconds.insert(result.seconds.begin(), preparation.begin(), preparation.end());
  return result;
}

const char* name(LinkCriterion criterion) {
  switch (criterion) {
    case LinkCriterion::reverse:
      return "reverse";
    case LinkCriterion::medial:
      return "medial";
    case LinkCriterion::overlap:
      return "overlap";
    case LinkCriterion::user:
      return "user";
    case LinkCriterion::crossing:
      return "crossing";
    case LinkCriterion::tracked:
      return "tracked";
  }
  return "unknown";
}

const char* name(DoubtKind kind) {
  switch (kind) {
    case DoubtKind::may_connect:
      return "may-connect";
    case DoubtKind::may_part:
      return "may-part";
    case DoubtKind::void_may_connect:
      return "void-may-connect";
    case DoubtKind::void_may_part:
      return "void-may-part";
  }
  return "unknown";
}

}  // namespace odontoscope
