#include "recon/delaunay/solve_slab.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "recon/delaunay/block.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/raise.h"

namespace odontoscope::delaunay {
namespace {

/// Components that share one Delaunay triangulation. More than one: they are carved from it and stay disjoint.
struct Group {
  std::vector<Component> components;
  std::optional<SlabSolid> solid;  // empty: cut
  std::vector<RegionLink> merged;  // links by which its components became one
};

void merge_sorted(std::vector<std::uint32_t>& into, const std::vector<std::uint32_t>& from) {
  into.insert(into.end(), from.begin(), from.end());
  std::sort(into.begin(), into.end());
}

Component united(const std::vector<Component>& components) {
  Component all;
  for (const Component& c : components) {
    merge_sorted(all.lower, c.lower);
    merge_sorted(all.upper, c.upper);
  }
  return all;
}

class SlabSolver {
 public:
  SlabSolver(const SlabTask& task, const Progress& progress) : task_(task), progress_(progress) {}

  SolvedSlab run() {
    const Planar& lower = task_.lower.planar;
    const Planar& upper = task_.upper.planar;
    if (conforming()) whole_ = triangulate_slab(lower, upper);
    for (const Component& component : task_.correspondences.components) {
      groups_.push_back({{component}, std::nullopt, {}});
      solve(groups_.back());
    }
    while (separate()) progress_.check();
    return collect(task_.correspondences.links);
  }

 private:
  static std::uint32_t regions(const ConformedSlice& slice) { return static_cast<std::uint32_t>(slice.regions()); }

  bool conforming() const { return task_.lower.conforming && task_.upper.conforming; }

  bool is_whole(const Component& c) const {
    return c.lower.size() == task_.lower.regions() && c.upper.size() == task_.upper.regions();
  }

  // ---- one group ----------------------------------------------------------------------------------------------------

  void solve(Group& group) {
    const Component all = united(group.components);
    if (!conforming()) {
      solve_as_block(group, all);
      return;
    }
    if (is_whole(all)) {
      solve_in(group, whole_, task_.lower.planar, task_.upper.planar);
      return;
    }
    const Planar lower = part_of(task_.lower, all.lower), upper = part_of(task_.upper, all.upper);
    solve_in(group, triangulate_slab(lower, upper), lower, upper);
  }

  void solve_as_block(Group& group, const Component& all) {
    if (group.components.size() > 1) {
      if (joins_apart(all, task_.choices)) return;
      remember_merger(group);
      group.components = {all};
    }
    const Planar lower = part_of(task_.lower, all.lower), upper = part_of(task_.upper, all.upper);
    SlabSolid solid;
    const Blocked made =
        block(lower, upper, {task_.lower.z, task_.upper.z}, points(task_.lower), points(task_.upper), solid);
    if (made == Blocked::no_height) refuse_too_close(task_);
    if (made == Blocked::yes) group.solid = std::move(solid);
  }

  void solve_in(Group& group, const SlabTetrahedra& tets, const Planar& lower, const Planar& upper) {
    if (group.components.size() > 1) {
      if (carve(group, tets, lower, upper)) return;
      const Component all = united(group.components);
      group.solid.reset();
      if (joins_apart(all, task_.choices)) return;
      remember_merger(group);
      group.components = {all};
    }
    Fates fate = eliminate(tets, lower, upper);
    if (finish(group, tets, fate, Owners(tets.size(), 0), lower, upper)) return;
    throw InternalError(
        fmt::format("the slab between z = {} and {} could not be repaired", task_.lower.z, task_.upper.z));
  }

  /// The components of a group from one triangulation: tetrahedra with points of two components belong to none.
  bool carve(Group& group, const SlabTetrahedra& tets, const Planar& lower, const Planar& upper) {
    std::vector<std::uint32_t> of_lower(task_.lower.regions(), 0), of_upper(task_.upper.regions(), 0);
    for (std::uint32_t c = 0; c < group.components.size(); ++c) {
      for (const std::uint32_t r : group.components[c].lower) of_lower[r] = c;
      for (const std::uint32_t r : group.components[c].upper) of_upper[r] = c;
    }
    Fates fate = eliminate(tets, lower, upper);
    Owners owner(tets.size(), none);
    const SlabNumbers numbers(lower);
    for (const TetIndex t : tets.indices()) {
      const auto component = [&](SlabPoint v) {
        return numbers.is_lower(v) ? of_lower[lower.region_of[numbers.own(v)]]
                                   : of_upper[upper.region_of[numbers.own(v)]];
      };
      const auto& v = tets[t].v;
      if (std::all_of(v.begin() + 1, v.end(), [&](SlabPoint w) { return component(w) == component(v[0]); }))
        owner[t] = component(v[0]);
      if (owner[t] != none || fate[t] == Fate::removed) continue;
      if (tets[t].lower_count != 2) return false;  // part of a region would go uncovered
      fate[t] = Fate::removed;
    }
    return finish(group, tets, fate, owner, lower, upper);
  }

  bool finish(Group& group, const SlabTetrahedra& tets, Fates& fate, const Owners& owner, const Planar& lower,
              const Planar& upper) {
    SlabSolid solid;
    for (;;) {
      if (!repair(tets, lower, upper, owner, fate)) return false;
      const std::optional<std::size_t> joined = connect(tets, lower, upper, owner, fate);
      if (!joined) return false;
      if (*joined == 0) break;
    }
    const SlabHeights heights{task_.lower.z, task_.upper.z};
    const bool lifted = task_.walls == Walls::lifted &&
                        lift(tets, fate, lower, upper, heights, points(task_.lower), points(task_.upper), solid);
    if (!lifted && !raise(tets, fate, lower, upper, heights, points(task_.lower), points(task_.upper), solid))
      refuse_too_close(task_);
    group.solid = std::move(solid);
    return true;
  }

  static std::uint32_t points(const ConformedSlice& slice) {
    return static_cast<std::uint32_t>(slice.planar.points.size());
  }

  /// Written so that the same links, given by the user, make the same component.
  static void remember_merger(Group& group) {
    for (std::size_t c = 1; c < group.components.size(); ++c)
      group.merged.push_back(
          {group.components[0].lower.front(), group.components[c].upper.front(), LinkCriterion::crossing});
  }

  // ---- groups among each other --------------------------------------------------------------------------------------

  /// Puts groups that cross or touch into one; false when none do.
  bool separate() {
    if (groups_.size() < 2) return false;
    std::vector<Boundary> boundaries;
    for (const Group& group : groups_)
      boundaries.push_back(group.solid ? boundary_of(task_.lower, task_.upper, *group.solid) : Boundary{});
    const auto pairs = crossing_pairs(boundaries);
    if (pairs.empty()) return false;
    std::vector<std::size_t> head(groups_.size());
    for (std::size_t g = 0; g < head.size(); ++g) head[g] = g;
    for (const auto& [i, j] : pairs) {
      const std::size_t from = std::max(head[i], head[j]), to = std::min(head[i], head[j]);
      std::replace(head.begin(), head.end(), from, to);
    }
    std::vector<Group> next;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (head[g] != g) continue;
      Group group = std::move(groups_[g]);
      bool grew = false;
      for (std::size_t other = g + 1; other < groups_.size(); ++other) {
        if (head[other] != g) continue;
        for (Component& c : groups_[other].components) group.components.push_back(std::move(c));
        group.merged.insert(group.merged.end(), groups_[other].merged.begin(), groups_[other].merged.end());
        grew = true;
      }
      if (grew) {
        group.solid.reset();
        solve(group);
      }
      next.push_back(std::move(group));
    }
    groups_ = std::move(next);
    return true;
  }

  SolvedSlab collect(std::vector<RegionLink> links) {
    SolvedSlab result;
    result.lower_linked.assign(task_.lower.regions(), false);
    result.upper_linked.assign(task_.upper.regions(), false);
    for (Group& group : groups_) {
      if (!group.solid) continue;
      links.insert(links.end(), group.merged.begin(), group.merged.end());
      const Component all = united(group.components);
      for (const std::uint32_t r : all.lower) result.lower_linked[r] = true;
      for (const std::uint32_t r : all.upper) result.upper_linked[r] = true;
      result.raised = result.raised || group.solid->raised;
      result.pieces.push_back(std::move(*group.solid));
    }
    for (const RegionLink& link : links) {
      if (result.lower_linked[link.lower] && result.upper_linked[link.upper]) {
        result.links.push_back(link);
      } else if (link.criterion == LinkCriterion::user) {
        throw InputError("link-impossible", task_.place,
                         "a link cannot be built: its solid would cross another one that it must stay apart from",
                         "Drop this link, or allow the regions that it crosses to be joined");
      } else {
        ++result.cut_links;
      }
    }
    std::stable_sort(result.links.begin(), result.links.end(), [](const RegionLink& a, const RegionLink& b) {
      return std::pair(a.lower, a.upper) < std::pair(b.lower, b.upper);
    });
    return result;
  }

  const SlabTask& task_;
  const Progress& progress_;
  SlabTetrahedra whole_;
  std::vector<Group> groups_;
};

}  // namespace

void refuse_too_close(const SlabTask& task) {
  throw InputError(
      "slices-too-close", task.place,
      fmt::format(
          "a wall must run between this slice and the next, at z = {}, and no number lies between the two heights",
          task.upper.z),
      "Drop one of the two slices, or give heights that differ by more than a rounding");
}

namespace {

/// Which witnessed links give way to the user's.
enum class Give { those_beside, all };

Correspondences without_witnessed(const SlabTask& task, Give give) {
  const auto& components = task.correspondences.components;
  std::vector<RegionLink> kept;
  for (const RegionLink& link : task.correspondences.links) {
    const auto holds_it_and_a_users = [&](const Component& c) {
      const auto begins_here = [&c](std::uint32_t region) {
        return std::binary_search(c.lower.begin(), c.lower.end(), region);
      };
      return begins_here(link.lower) && std::any_of(task.choices.joined.begin(), task.choices.joined.end(),
                                                    [&](const auto& pair) { return begins_here(pair.first); });
    };
    if (link.criterion == LinkCriterion::user || give == Give::all) continue;  // `correspond` adds the user's
    if (std::none_of(components.begin(), components.end(), holds_it_and_a_users)) kept.push_back(link);
  }
  return correspond(kept, task.choices, static_cast<std::uint32_t>(task.lower.regions()),
                    static_cast<std::uint32_t>(task.upper.regions()), task.place);
}

SolvedSlab solved_without(const SlabTask& task, Give give, const Progress& progress) {
  const SlabTask fewer{task.lower, task.upper, without_witnessed(task, give), task.choices, task.walls, task.place};
  SolvedSlab solved = SlabSolver(fewer, progress).run();
  solved.cut_links += task.correspondences.links.size() - fewer.correspondences.links.size();
  return solved;
}

/// As `solve`, or nothing where a link of the user's cannot be built.
template <class Solve>
std::optional<SolvedSlab> unless_impossible(const Solve& solve) {
  try {
    return solve();
  } catch (const InputError& error) {
    if (error.cause() != "link-impossible") throw;
    return std::nullopt;
  }
}

}  // namespace

SolvedSlab solve_slab(const SlabTask& task, const Progress& progress) {
  if (task.lower.regions() == 0 || task.upper.regions() == 0) {
    SolvedSlab flat;
    flat.lower_linked.assign(task.lower.regions(), false);
    flat.upper_linked.assign(task.upper.regions(), false);
    return flat;
  }
  // A link that the user asked for goes before those that contours alone witness: these are cut where it cannot be
  // built beside them.
  if (auto solved = unless_impossible([&] { return SlabSolver(task, progress).run(); })) return std::move(*solved);
  if (auto solved = unless_impossible([&] { return solved_without(task, Give::those_beside, progress); }))
    return std::move(*solved);
  return solved_without(task, Give::all, progress);
}

Boundary boundary_of(const ConformedSlice& lower, const ConformedSlice& upper, const SlabSolid& solid) {
  const auto& below = lower.planar.points;
  const auto& above = upper.planar.points;
  const auto on = [](const Table<SlicePoint, Point2>& points, std::size_t v, double z) {
    const Point2 p = points[SlicePoint(v)];
    return Point3{p.x, p.y, z};
  };
  const auto place = [&](std::size_t v) -> Point3 {
    if (v < below.size()) return on(below, v, lower.z);
    v -= below.size();
    if (v < above.size()) return on(above, v, upper.z);
    return solid.added[v - above.size()];
  };
  Boundary boundary;
  each_outer_face(solid.tetrahedra, [&](const Triangle& f) {
    boundary.push_back({place(f[0]), place(f[1]), place(f[2])});
  });
  return boundary;
}

}  // namespace odontoscope::delaunay
