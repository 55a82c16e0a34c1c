#include "recon/delaunay/reconstruct.h"

#include <tbb/global_control.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "recon/core/limits.h"
#include "recon/delaunay/assemble.h"
#include "recon/delaunay/certify.h"
#include "recon/core/parallel.h"
#include "recon/delaunay/conform.h"
#include "recon/delaunay/overhang.h"
#include "recon/delaunay/plate.h"
#include "recon/delaunay/solve_slab.h"
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
    const auto known = std::find_if(times_.begin(), times_.end(), [stage](const StageTime& t) { return t.stage == stage; });
    if (known != times_.end()) known->seconds += seconds;
    else times_.push_back({stage, seconds});
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<StageTime>& times_;
  Clock::time_point start_;
};

class Reconstructor {
 public:
  Reconstructor(const OrderedStack& input, const ReconstructOptions& options, int threads, const Progress& progress)
      : input_(input), options_(options), progress_(progress), arena_(threads), watch_(result_.seconds) {
    result_.threads = threads;
  }

  Reconstruction run() {
    const std::vector<std::string> structures = structures_of(input_.stack);
    result_.counts.slices = input_.stack.slices.size();
    for (std::size_t s = 0; s < structures.size(); ++s) reconstruct_structure(structures[s], static_cast<Label>(s + 1));
    result_.slices_checked = input_.stack.slices.size();
    result_.certified = true;
    return std::move(result_);
  }

 private:
  void reconstruct_structure(const std::string& structure, Label label) {
    SolvedStack stack = conform_slices(structure);
    watch_.lap("conform");
    solve_slabs(stack, structure);
    watch_.lap("slabs");
    result_.solids.push_back(assemble_and_certify(stack, structure, label));
  }

  SolvedStack conform_slices(const std::string& structure) {
    SolvedStack stack;
    const auto& slices = input_.stack.slices;
    stack.slices.resize(slices.size());
    for_each(slices.size(), arena_, "conform", progress_, [&](std::size_t k) {
      stack.slices[k] = conform(slices[k], structure, input_.original_slice[k], input_.stack.source, progress_);
    });
    for (const ConformedSlice& slice : stack.slices) {
      result_.counts.contours += slice.contour_number.size();
      result_.counts.points += slice.planar.points.size() - slice.steiner_points;
      result_.counts.steiner_points += slice.steiner_points;
    }
    return stack;
  }

  // ---- slabs ----------------------------------------------------------------------------------------------------------

  void solve_slabs(SolvedStack& stack, const std::string& structure) {
    const std::size_t slabs = stack.slices.size() - 1;
    stack.slabs.resize(slabs);
    std::vector<SolvedSlab> solved(slabs);
    for_each(slabs, arena_, "slabs", progress_, [&](std::size_t k) {
      const SlabTask task{stack.slices[k], stack.slices[k + 1], options_.correspondence, choices(stack, structure, k), place(k)};
      solved[k] = solve_slab(task, progress_);
    });
    std::vector<std::vector<bool>> isolated(stack.slices.size());
    for (std::size_t k = 0; k < stack.slices.size(); ++k)
      for (std::size_t r = 0; r < stack.slices[k].regions(); ++r) {
        const bool below = k > 0 && solved[k - 1].upper_linked[r], above = k < slabs && solved[k].lower_linked[r];
        isolated[k].push_back(!below && !above);
        result_.counts.isolated_regions += isolated[k].back();
      }
    for_each(slabs, arena_, "plates", progress_, [&](std::size_t k) {
      add_plates(stack.slices[k], stack.slices[k + 1], isolated[k], isolated[k + 1], solved[k].pieces);
    });
    for (std::size_t k = 0; k < slabs; ++k) {
      report_links(stack, structure, k, solved[k]);
      stack.slabs[k] = std::move(solved[k].pieces);
      for (const SlabSolid& piece : stack.slabs[k]) {
        result_.counts.restored += piece.restored;
        if (piece.restored > 0) result_.counts.lifted_points += piece.added.size();
        result_.counts.largest_sideways = std::max(result_.counts.largest_sideways, piece.largest_sideways);
      }
    }
    result_.counts.trimmed += trim_overhangs(stack);
  }

  Place place(std::size_t k) const {
    Place where;
    where.file = input_.stack.source;
    where.slice = input_.original_slice[k];
    where.z = input_.stack.slices[k].z;
    return where;
  }

  /// The region whose outer contour has this number in its slice's list. Precondition: validate_links passed.
  static std::uint32_t region_of_contour(const ConformedSlice& slice, std::size_t contour) {
    for (std::uint32_t r = 0; r < slice.regions(); ++r)
      if (slice.contour_number[slice.outer_contour[r]] == contour) return r;
    throw InternalError("a link names no region");
  }

  Choices choices(const SolvedStack& stack, const std::string& structure, std::size_t k) const {
    Choices made;
    for (const Link& link : options_.links) {
      if (link.structure != structure || link.slice != k) continue;
      const std::pair regions{region_of_contour(stack.slices[k], link.lower), region_of_contour(stack.slices[k + 1], link.upper)};
      auto& list = link.connect ? made.joined : made.apart;
      if (std::find(list.begin(), list.end(), regions) == list.end()) list.push_back(regions);
    }
    return made;
  }

  void report_links(const SolvedStack& stack, const std::string& structure, std::size_t k, const SolvedSlab& solved) {
    const auto contour = [](const ConformedSlice& slice, std::uint32_t region) {
      return slice.contour_number[slice.outer_contour[region]];
    };
    for (const RegionLink& link : solved.links)
      result_.links.push_back({{structure, k, contour(stack.slices[k], link.lower), contour(stack.slices[k + 1], link.upper), true},
                               link.criterion});
    result_.counts.cut_links += solved.cut_links;
  }

  // ---- result ---------------------------------------------------------------------------------------------------------

  void certify_sections(const SolvedStack& stack, const Numbering& numbering, const std::vector<AssembledSlab>& slabs,
                        const TetraMesh& mesh) {
    for_each(slabs.size(), arena_, "certify", progress_, [&](std::size_t k) { certify_slab(stack, numbering, slabs[k], mesh, k); });
    for_each(stack.slices.size(), arena_, "certify", progress_, [&](std::size_t k) {
      certify_contours(stack.slices[k], input_.stack.slices[k]);
      certify_slice(stack, numbering, k > 0 ? &slabs[k - 1] : nullptr, k < slabs.size() ? &slabs[k] : nullptr, k);
    });
  }

  Solid assemble_and_certify(const SolvedStack& stack, const std::string& structure, Label label) {
    const Numbering numbering(stack);
    std::vector<AssembledSlab> slabs(stack.slabs.size());
    for_each(slabs.size(), arena_, "assemble", progress_,
             [&](std::size_t k) { slabs[k] = assemble_slab(stack, numbering, k); });
    Assembly assembly = arena_.execute([&] { return assemble(stack, numbering, slabs, label); });
    watch_.lap("assemble");

    Solid solid;
    solid.structure = structure;
    arena_.execute([&] {   // the two proofs are about equally long
      tbb::parallel_invoke([&] { solid.report = inspect(assembly.surface); },
                           [&] { certify_sections(stack, numbering, slabs, assembly.tetrahedra); });
    });
    certify_surface(solid.report, structure);
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
  const int threads = options.threads > 0 ? options.threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  // Holds for validation too, and lets a caller ask for more threads than the machine has (the bytes do not depend on it).
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  std::vector<StageTime> preparation;
  Stopwatch watch(preparation);
  validate(stack, progress);
  const OrderedStack input = ordered(stack);
  validate_links(options.links, input.stack);
  watch.lap("validate");
  Reconstruction result = Reconstructor(input, options, threads, progress).run();
  result.seconds.insert(result.seconds.begin(), preparation.begin(), preparation.end());
  return result;
}

const char* name(Correspondence criterion) {
  switch (criterion) {
    case Correspondence::reverse: return "reverse";
    case Correspondence::medial: return "medial";
    case Correspondence::overlap: return "overlap";
  }
  return "unknown";
}

const char* name(LinkCriterion criterion) {
  switch (criterion) {
    case LinkCriterion::reverse: return "reverse";
    case LinkCriterion::medial: return "medial";
    case LinkCriterion::overlap: return "overlap";
    case LinkCriterion::user: return "user";
    case LinkCriterion::crossing: return "crossing";
  }
  return "unknown";
}

}  // namespace odontoscope
