#include "recon/delaunay/solve_stack.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>

#include "recon/core/limits.h"
#include "recon/core/parallel.h"
#include "recon/core/union_find.h"
#include "recon/delaunay/interpolated_slab.h"
#include "recon/delaunay/overhang.h"
#include "recon/delaunay/plate.h"
#include "recon/delaunay/remedy.h"
#include "recon/delaunay/survey.h"
#include "recon/delaunay/topology.h"

namespace odontoscope::delaunay {
namespace {

Nesting nesting_of(const ConformedSlice& slice, const SliceVoids& voids) {
  Nesting nesting;
  nesting.owner.push_back(none);
  for (const std::uint32_t hole : voids.hole_contour)
    nesting.owner.push_back(slice.planar.region_of[slice.first_point[hole]]);
  for (const std::uint32_t outer : slice.outer_contour) nesting.around.push_back(voids.of_contour[outer]);
  return nesting;
}

long apart(const Topology& a, const Topology& b) {
  return std::labs(a.pieces - b.pieces) + std::labs(a.handles - b.handles) + std::labs(a.bubbles - b.bubbles);
}

class StackSolver {
 public:
  StackSolver(const StackTask& task, tbb::task_arena& arena, const Progress& progress)
      : task_(task), input_(task.input.stack), arena_(arena), progress_(progress), slabs_(input_.slices.size() - 1) {}

  SurveyedStructure surveyed() {
    conform_slices();
    survey_slabs();
    SurveyedStructure found;
    for (std::size_t k = 0; k < slabs_; ++k) {
      const SlabTask task = slab_task(k, Walls::lifted);
      found.links.push_back(task.correspondences.links);
      found.implied.push_back(implied_with_plates(k, task));
      solved_[k].links = task.correspondences.links;
    }
    report_doubts();
    found.doubts = std::move(result_.doubts);
    found.slices = std::move(result_.stack.slices);
    found.voids = std::move(voids_);
    found.surveys = std::move(surveys_);
    return found;
  }

  SolvedStructure run() {
    conform_slices();
    survey_slabs();
    for_each(slabs_, arena_, "slabs", progress_, [&](std::size_t k) { solve(k, Walls::lifted); });
    add_plates();
    for (std::size_t k = 0; k < slabs_; ++k) report(k);
    report_doubts();
    for (std::size_t k = 0; k < slabs_; ++k) result_.stack.slabs.push_back(std::move(solved_[k].pieces));
    trim();
    return std::move(result_);
  }

 private:
  const ConformedSlice& slice(std::size_t k) const { return result_.stack.slices[k]; }

  void conform_slices() {
    auto& slices = result_.stack.slices;
    slices.resize(input_.slices.size());
    voids_.resize(slices.size());
    nesting_.resize(slices.size());
    for_each(slices.size(), arena_, "conform", progress_, [&](std::size_t k) {
      slices[k] = taken(k);
      voids_[k] = voids_of(slices[k]);
      nesting_[k] = nesting_of(slices[k], voids_[k]);
    });
    for (const ConformedSlice& one : slices) {
      result_.counts.contours += one.contour_number.size();
      result_.counts.points += one.planar.points.size() - one.steiner_points;
      result_.counts.steiner_points += one.steiner_points;
      result_.counts.constrained_slices += !one.conforming;
    }
  }

  /// Conforming if that can be had.
  ConformedSlice taken(std::size_t k) const {
    try {
      return conform(input_.slices[k], task_.structure, task_.input.original_slice[k], input_.source, progress_);
    } catch (const InputError&) {
      return constrained(input_.slices[k], task_.structure, task_.input.original_slice[k], input_.source, progress_);
    }
  }

  bool conforming(std::size_t k) const { return slice(k).conforming && slice(k + 1).conforming; }
  bool has_material(std::size_t k) const { return slice(k).regions() > 0 && slice(k + 1).regions() > 0; }
  /// A structure ends in the slab, and the slice before tells how it narrows.
  bool is_end(std::size_t k) const {
    const bool upwards = slice(k + 1).regions() == 0 && slice(k).regions() > 0 && k > 0 && slice(k - 1).regions() > 0;
    return upwards ||
           (slice(k).regions() == 0 && slice(k + 1).regions() > 0 && k + 2 <= slabs_ && slice(k + 2).regions() > 0);
  }

  // ---- links --------------------------------------------------------------------------------------------------------

  void survey_slabs() {
    surveys_.resize(slabs_);
    solved_.resize(slabs_);
    implied_.resize(slabs_);
    interpolated_.assign(slabs_, 0);
    for_each(slabs_, arena_, "links", progress_, [&](std::size_t k) {
      surveys_[k] = survey_slab(slice(k), slice(k + 1), voids_[k], voids_[k + 1], task_.options.correspondence);
    });
    if (task_.options.correspondence == Correspondence::tracked) follow();
  }

  void follow() {
    std::vector<Choices> chosen;
    std::vector<Place> places;
    for (std::size_t k = 0; k < slabs_; ++k) {
      chosen.push_back(choices(k));
      places.push_back(place(k));
    }
    doubts_ = track_stack(result_.stack.slices, voids_, chosen, places, surveys_);
  }

  Place place(std::size_t k) const {
    Place where;
    where.file = input_.source;
    where.slice = task_.input.original_slice[k];
    where.z = input_.slices[k].z;
    return where;
  }

  /// The region whose outer contour has this number in its slice's list. Precondition: validate_links passed.
  static std::uint32_t region_of_contour(const ConformedSlice& slice, std::size_t contour) {
    for (std::uint32_t r = 0; r < slice.regions(); ++r)
      if (slice.contour_number[slice.outer_contour[r]] == contour) return r;
    throw InternalError("a link names no region");
  }

  Choices choices(std::size_t k) const {
    Choices made;
    for (const Link& link : task_.options.links) {
      if (link.structure != task_.structure || link.slice != k) continue;
      const std::pair regions{region_of_contour(slice(k), link.lower), region_of_contour(slice(k + 1), link.upper)};
      auto& list = link.connect ? made.joined : made.apart;
      if (std::find(list.begin(), list.end(), regions) == list.end()) list.push_back(regions);
    }
    return made;
  }

  SlabTask slab_task(std::size_t k, Walls walls) const {
    SlabTask task{slice(k), slice(k + 1), {}, choices(k), walls, place(k)};
    task.correspondences =
        correspond(surveys_[k].material, task.choices, static_cast<std::uint32_t>(slice(k).regions()),
                   static_cast<std::uint32_t>(slice(k + 1).regions()), task.place);
    return task;
  }

  // ---- solving ------------------------------------------------------------------------------------------------------

  void solve(std::size_t k, Walls walls) {
    const SlabTask task = slab_task(k, walls);
    interpolated_[k] = 0;
    if ((!has_material(k) && !is_end(k)) || task_.options.between == Between::delaunay || !conforming(k)) {
      solved_[k] = solve_slab(task, progress_);
      implied_[k] = implied(k, solved_[k]);
      return;
    }
    long least = -1;
    for (const Attempt& attempt : attempts(k, task)) {
      std::size_t slices = 0;
      if (attempt.late && (least > limits::mendable || !deserves_more(k))) return;
      std::optional<SolvedSlab> solved =
          attempt.slices == 0 ? solve_slab(task, progress_) : through(k, task, attempt, slices);
      if (!solved) continue;
      if (slices > 0) solved->links = links_kept(task);
      const Topology wanted = implied(k, *solved);
      const long off = apart(wanted, topology_of(slice(k), slice(k + 1), *solved));
      if (least >= 0 && off >= least) continue;
      least = off;
      solved_[k] = std::move(*solved);
      implied_[k] = wanted;
      interpolated_[k] = slices;
      if (off == 0) return;
    }
  }

  /// Late attempts cost several times all others, and were found to mend what anatomy has: a few outlines of many
  /// points. Crowds, toys, and contours so near each other that making them Delaunay took more points than they had
  /// stay as they are.
  bool deserves_more(std::size_t k) const {
    std::size_t contours = 0, points = 0, added = 0;
    for (const ConformedSlice* one : {&slice(k), &slice(k + 1)}) {
      contours += one->contour_number.size();
      points += one->planar.points.size() - one->steiner_points;
      added += one->steiner_points;
    }
    return contours <= limits::few_contours && points >= limits::fine_outlines && added <= points;
  }

  struct Attempt {
    std::size_t slices = 0;  // to be interpolated
    bool strips = false;     // this and the next: between::BlendOptions
    std::size_t finer = 1;
    bool late = false;  // for what is nearly as it should be
    bool kept = false;  // between::BlendOptions::keep_links and draw_back
  };

  /// In the order in which they are tried. A structure that ends would end flat without any slices.
  std::vector<Attempt> attempts(std::size_t k, const SlabTask& task) const {
    const bool chosen = !task.choices.joined.empty() || !task.choices.apart.empty();
    if (!has_material(k)) return {{3}, {1}, {0}};
    std::vector<Attempt> list{{1, true}, {3, true}, {1}, {3}};
    const between::SlabNeed need = between::need(outline_of(slice(k)), outline_of(slice(k + 1)));
    const bool gentle = chosen || need.travel < limits::steep * (slice(k + 1).z - slice(k).z);
    list.insert(gentle ? list.begin() : list.end(), Attempt{});
    list.push_back({7});
    // Few slabs come so far: thin walls, and wedges that drift. Each of these is the first that gives some of them what
    // they should have.
    for (const Attempt& one : {Attempt{5, true}, Attempt{5}, Attempt{1, true, 3}, Attempt{3, false, 3}, Attempt{15}})
      list.push_back({one.slices, one.strips, one.finer, true});
    for (const std::size_t slices : {3, 7})
      for (const bool strips : {true, false}) list.push_back({slices, strips, 1, true, true});
    return list;
  }

  static std::vector<RegionLink> links_kept(const SlabTask& task) { return task.correspondences.links; }

  /// `slices`: how many were interpolated.
  std::optional<SolvedSlab> through(std::size_t k, const SlabTask& task, const Attempt& attempt,
                                    std::size_t& slices) const {
    const between::BlendOptions options{
        .strips = attempt.strips, .finer = attempt.finer, .keep_links = attempt.kept, .draw_back = attempt.kept};
    std::vector<Interpolated> made;
    for (between::StagedOutline& one : blend_slab(result_.stack.slices, voids_, k, task.correspondences.links,
                                                  surveys_[k].voids, even_shares(attempt.slices), options))
      made.push_back({slice(k).z + one.share * (slice(k + 1).z - slice(k).z), std::move(one.outline)});
    slices = made.size();
    return solve_through(task, task.correspondences.components, made, progress_);
  }

  // ---- topology -----------------------------------------------------------------------------------------------------

  static RegionPairs pairs(const std::vector<RegionLink>& links) {
    RegionPairs list;
    for (const RegionLink& link : links) list.emplace_back(link.lower, link.upper);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  /// Without plates, which are added later.
  Topology implied(std::size_t k, const SolvedSlab& solved) const {
    const SlabLinks links{pairs(solved.links), pairs(surveys_[k].voids), solved.lower_linked, solved.upper_linked};
    return implied_topology(nesting_[k], nesting_[k + 1], links);
  }

  /// Of a slab in which what is linked to nothing stands on its slice as a plate.
  Topology implied_with_plates(std::size_t k, const SlabTask& task) const {
    SlabLinks links{pairs(task.correspondences.links), pairs(surveys_[k].voids),
                    std::vector<bool>(slice(k).regions(), false), std::vector<bool>(slice(k + 1).regions(), false)};
    for (const auto& [lower, upper] : links.material) links.lower_in[lower] = links.upper_in[upper] = true;
    const auto plates = [&](std::size_t number, const std::vector<bool>& in, std::size_t& count) {
      for (std::uint32_t r = 0; r < in.size(); ++r) {
        if (in[r]) continue;
        ++count;
        const auto& owner = nesting_[number].owner;
        links.plate_holes += static_cast<std::size_t>(std::count(owner.begin() + 1, owner.end(), r));
      }
    };
    plates(k, links.lower_in, links.lower_plates);
    plates(k + 1, links.upper_in, links.upper_plates);
    return implied_topology(nesting_[k], nesting_[k + 1], links);
  }

  // ---- plates -------------------------------------------------------------------------------------------------------

  std::vector<std::vector<bool>> isolated_regions() const {
    std::vector<std::vector<bool>> isolated(slabs_ + 1);
    for (std::size_t k = 0; k <= slabs_; ++k)
      for (std::size_t r = 0; r < slice(k).regions(); ++r)
        isolated[k].push_back(!(k > 0 && solved_[k - 1].upper_linked[r]) &&
                              !(k < slabs_ && solved_[k].lower_linked[r]));
    return isolated;
  }

  /// Where a plate finds no room the slab is solved again with all its pieces raised.
  void add_plates() {
    std::vector<std::optional<std::vector<SlabSolid>>> made(slabs_);
    std::vector<Walls> walls(slabs_, Walls::lifted);
    for (bool room = false; !room;) {
      const std::vector<std::vector<bool>> isolated = isolated_regions();
      for_each(slabs_, arena_, "plates", progress_, [&](std::size_t k) {
        made[k] = plates(slice(k), slice(k + 1), isolated[k], isolated[k + 1], solved_[k].pieces);
      });
      room = true;
      for (std::size_t k = 0; k < slabs_; ++k) {
        if (made[k]) continue;
        if (walls[k] == Walls::raised) refuse_too_close(slab_task(k, walls[k]));
        walls[k] = Walls::raised;
        solve(k, walls[k]);
        room = false;
      }
      if (room) count_plates(isolated);
      if (room) advise(isolated);
    }
    for (std::size_t k = 0; k < slabs_; ++k)
      for (SlabSolid& one : *made[k]) solved_[k].pieces.push_back(std::move(one));
  }

  void count_plates(const std::vector<std::vector<bool>>& isolated) {
    for (std::size_t k = 0; k <= slabs_; ++k)
      for (std::uint32_t r = 0; r < isolated[k].size(); ++r) {
        if (!isolated[k][r]) continue;
        ++result_.counts.isolated_regions;
        const auto& owner = nesting_[k].owner;
        const long holes = std::count(owner.begin() + 1, owner.end(), r);
        for (const std::size_t slab : {k - 1, k}) {  // k - 1 wraps round at the first slice, and is no slab
          if (slab >= slabs_) continue;
          implied_[slab].pieces += 1;
          implied_[slab].handles += holes;
        }
      }
  }

  void trim() {
    for (const TrimmedSlab& trimmed : trim_overhangs(result_.stack)) {
      const std::size_t k = trimmed.slab;
      result_.counts.trimmed += trimmed.tetrahedra;
      result_.topology[k].untrimmed = trimmed.before;
      result_.changes.push_back({SlabChange::Kind::trimmed, task_.structure, k, slice(k).z, slice(k + 1).z,
                                 trimmed.place, trimmed.volume, trimmed.tetrahedra});
    }
  }

  /// For the first isolated regions, links that would join them.
  void advise(const std::vector<std::vector<bool>>& isolated) {
    std::size_t advised = 0;
    for (std::size_t k = 0; k <= slabs_; ++k)
      for (std::uint32_t r = 0; r < isolated[k].size(); ++r) {
        if (!isolated[k][r] || advised++ >= limits::regions_advised) continue;
        for (const std::size_t slab : {k, k - 1})  // k - 1 wraps round at the first slice, and is no slab
          if (slab < slabs_ && has_material(slab) && add_remedy(slab, {slab == k, r})) break;
      }
  }

  bool add_remedy(std::size_t slab, RegionOfSlab region) {
    const std::optional<RegionLink> link =
        remedy(slab_task(slab, Walls::lifted), surveys_[slab].material, region, progress_);
    if (!link) return false;
    const Link words{task_.structure, slab, outer_number(slab, link->lower), outer_number(slab + 1, link->upper), true};
    if (std::find(result_.remedies.begin(), result_.remedies.end(), words) == result_.remedies.end())
      result_.remedies.push_back(words);
    return true;
  }

  std::size_t outer_number(std::size_t k, std::uint32_t region) const {
    return slice(k).contour_number[slice(k).outer_contour[region]];
  }

  // ---- report -------------------------------------------------------------------------------------------------------

  std::optional<std::size_t> hole_number(std::size_t k, std::uint32_t number) const {
    if (number == 0) return std::nullopt;
    return slice(k).contour_number[voids_[k].hole_contour[number - 1]];
  }

  void report(std::size_t k) {
    const SolvedSlab& solved = solved_[k];
    for (const RegionLink& link : solved.links)
      result_.links.push_back(
          {{task_.structure, k, outer_number(k, link.lower), outer_number(k + 1, link.upper), true}, link.criterion});
    for (const RegionLink& link : surveys_[k].voids)
      result_.void_links.push_back(
          {task_.structure, k, hole_number(k, link.lower), hole_number(k + 1, link.upper), link.criterion});
    result_.topology.push_back({task_.structure, k, implied_[k], {}, interpolated_[k], solved_[k].raised, {}, {}});
    ReconstructCounts& counts = result_.counts;
    counts.cut_links += solved.cut_links;
    counts.raised_slabs += solved.raised;
    for (const SlabSolid& piece : solved.pieces) {
      counts.restored += piece.restored;
      if (piece.restored > 0) counts.lifted_points += piece.added.size();
      counts.largest_sideways = std::max(counts.largest_sideways, piece.largest_sideways);
    }
  }

  /// Regions that are parts of one piece already have nothing to decide.
  void report_doubts() {
    for (const DoubtfulLink& link : doubts_.material) {
      const bool may_connect = link.choice == Choice::may_connect;
      if (may_connect == one_piece(link)) continue;  // others joined it, or it could not be built
      add_doubt(link, may_connect ? DoubtKind::may_connect : DoubtKind::may_part);
    }
    for (const DoubtfulLink& link : doubts_.voids)
      add_doubt(link, link.choice == Choice::may_connect ? DoubtKind::void_may_connect : DoubtKind::void_may_part);
    std::stable_sort(result_.doubts.begin(), result_.doubts.end(), [](const Doubt& a, const Doubt& b) {
      return std::tie(a.slab, a.lower, a.upper) < std::tie(b.slab, b.lower, b.upper);
    });
  }

  void add_doubt(const DoubtfulLink& link, DoubtKind kind) {
    const auto number = [](std::size_t contour) {
      return contour == no_contour ? std::nullopt : std::optional(contour);
    };
    result_.doubts.push_back(
        {task_.structure, link.slab, link.at, kind, number(link.lower_contour), number(link.upper_contour)});
  }

  bool one_piece(const DoubtfulLink& link) const {
    const auto lower = static_cast<std::uint32_t>(slice(link.slab).regions());
    UnionFind pieces(lower + slice(link.slab + 1).regions());
    for (const RegionLink& made : solved_[link.slab].links) pieces.join(made.lower, lower + made.upper);
    return pieces.find(link.lower) == pieces.find(lower + link.upper);
  }

  const StackTask& task_;
  const ContourStack& input_;
  tbb::task_arena& arena_;
  const Progress& progress_;
  const std::size_t slabs_;
  SolvedStructure result_;
  std::vector<SliceVoids> voids_;
  std::vector<Nesting> nesting_;
  std::vector<SlabSurvey> surveys_;
  StackDoubts doubts_;
  std::vector<SolvedSlab> solved_;
  std::vector<Topology> implied_;
  std::vector<std::size_t> interpolated_;
};

}  // namespace

SolvedStructure solve_stack(const StackTask& task, tbb::task_arena& arena, const Progress& progress) {
  return StackSolver(task, arena, progress).run();
}

SurveyedStructure survey_stack(const StackTask& task, tbb::task_arena& arena, const Progress& progress) {
  return StackSolver(task, arena, progress).surveyed();
}

}  // namespace odontoscope::delaunay
