#include "recon/delaunay/interpolated_slab.h"

#include <algorithm>

#include "recon/core/union_find.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/limits.h"
#include "recon/delaunay/topology.h"

namespace odontoscope::delaunay {
namespace {

/// What is interpolated belongs to one structure, so any name will do.
const std::string unnamed = "interpolated";

ConformedSlice conformed(const Interpolated& between, const Place& place, const Progress& progress) {
  Slice slice;
  slice.z = between.z;
  for (const auto& points : between.outline) slice.contours.push_back({unnamed, points});
  return conform(slice, unnamed, place.slice.value_or(0), place.file, progress);
}

/// Walls that thin are what is left of two outlines that the blend could not part, and all work would go to them.
bool too_thin(const ConformedSlice& slice) {
  const std::size_t traced = slice.planar.points.size() - slice.steiner_points;
  return slice.steiner_points > limits::interpolated_added * traced + limits::interpolated_added_free;
}

class ThroughSlices {
 public:
  ThroughSlices(const SlabTask& task, const std::vector<Component>& components)
      : task_(task), components_(components) {}

  std::optional<SolvedSlab> run(const std::vector<Interpolated>& between, const Progress& progress) {
    made_.reserve(between.size());
    slices_.push_back(&task_.lower);
    for (const Interpolated& one : between) {
      if (is_noise(one)) return std::nullopt;
      made_.push_back(conformed(one, task_.place, progress));
      if (too_thin(made_.back())) return std::nullopt;
      slices_.push_back(&made_.back());
    }
    slices_.push_back(&task_.upper);
    for (std::size_t i = 0; i + 1 < slices_.size(); ++i) {
      solved_.push_back(solve_slab(thin_slab(*slices_[i], *slices_[i + 1]), progress));
    }
    if (!joined_as_asked()) return std::nullopt;
    return merged();
  }

 private:
  /// Where both slices' borders coincide but for rounding the blend traces specks, thousands of them.
  bool is_noise(const Interpolated& one) const {
    const std::size_t given = task_.lower.contour_number.size() + task_.upper.contour_number.size();
    return one.outline.size() > limits::interpolated_contours * given + limits::interpolated_contours_free;
  }

  /// Whatever overlaps is linked: the interpolated slices lie close.
  SlabTask thin_slab(const ConformedSlice& lower, const ConformedSlice& upper) const {
    SlabTask thin{lower, upper, {}, {}, task_.walls, task_.place};
    if (lower.regions() == 0 || upper.regions() == 0) return thin;
    const auto witnessed =
        witnessed_links(walked_slab(lower.planar, upper.planar), lower.planar, upper.planar, Correspondence::overlap);
    thin.correspondences = correspond(witnessed, {}, static_cast<std::uint32_t>(lower.regions()),
                                      static_cast<std::uint32_t>(upper.regions()), task_.place);
    return thin;
  }

  /// Number of the first region of slice i among all slices' regions.
  std::vector<std::uint32_t> first_regions() const {
    std::vector<std::uint32_t> first{0};
    for (const ConformedSlice* slice : slices_)
      first.push_back(first.back() + static_cast<std::uint32_t>(slice->regions()));
    return first;
  }

  bool joined_as_asked() {
    const std::vector<std::uint32_t> first = first_regions();
    const std::uint32_t first_upper = first[slices_.size() - 1];
    UnionFind found(first.back()), asked(first.back());
    for (std::size_t i = 0; i < solved_.size(); ++i)
      for (const RegionLink& link : solved_[i].links) found.join(first[i] + link.lower, first[i + 1] + link.upper);
    for (const Component& component : components_) {
      for (const std::uint32_t r : component.lower) asked.join(component.lower.front(), r);
      for (const std::uint32_t r : component.upper) asked.join(component.lower.front(), first_upper + r);
    }
    std::vector<std::uint32_t> given;
    for (std::uint32_t r = 0; r < task_.lower.regions(); ++r) given.push_back(r);
    for (std::uint32_t r = 0; r < task_.upper.regions(); ++r) given.push_back(first_upper + r);
    // The same partition: each region's least given companion must be the same in both.
    std::vector<std::uint32_t> least(first.back(), none);
    for (const std::uint32_t r : given)
      if (least[found.find(r)] == none) least[found.find(r)] = r;
    // What no given region is joined with would be a ghost.
    for (std::size_t i = 0; i < solved_.size(); ++i)
      for (const RegionLink& link : solved_[i].links)
        if (least[found.find(first[i] + link.lower)] == none) return false;
    return std::all_of(given.begin(), given.end(), [&](std::uint32_t r) {
      const std::uint32_t companion = least[found.find(r)];
      return asked.find(companion) == asked.find(r) && found.find(asked.find(r)) == found.find(r);
    });
  }

  SolvedSlab merged() const {
    const auto below = static_cast<std::uint32_t>(task_.lower.planar.points.size());
    const auto above = static_cast<std::uint32_t>(task_.upper.planar.points.size());
    SlabSolid all;
    std::vector<std::uint32_t> first_point{0};  // of each slice's points in the merged numbering
    for (const ConformedSlice& slice : made_) {
      first_point.push_back(below + above + static_cast<std::uint32_t>(all.added.size()));
      for (const Point2 p : slice.planar.points) all.added.push_back({p.x, p.y, slice.z});
    }
    first_point.push_back(below);
    SolvedSlab result;
    for (std::size_t i = 0; i < solved_.size(); ++i) {
      result.raised = result.raised || solved_[i].raised;
      const auto in_lower = static_cast<std::uint32_t>(slices_[i]->planar.points.size());
      const auto in_upper = static_cast<std::uint32_t>(slices_[i + 1]->planar.points.size());
      for (const SlabSolid& piece : solved_[i].pieces) {
        const auto first_added = below + above + static_cast<std::uint32_t>(all.added.size());
        all.added.insert(all.added.end(), piece.added.begin(), piece.added.end());
        for (std::array<std::uint32_t, 4> tet : piece.tetrahedra) {
          for (std::uint32_t& v : tet)
            v = v < in_lower              ? first_point[i] + v
                : v < in_lower + in_upper ? first_point[i + 1] + (v - in_lower)
                                          : first_added + (v - in_lower - in_upper);
          all.tetrahedra.push_back(tet);
        }
        all.reach.insert(all.reach.end(), piece.reach.begin(), piece.reach.end());
        all.reach.resize(all.tetrahedra.size());  // plates reach nowhere
        all.restored += piece.restored;
        all.largest_sideways = std::max(all.largest_sideways, piece.largest_sideways);
      }
    }
    drop_unused(all, below + above);
    result.lower_linked = solved_.front().lower_linked;
    result.upper_linked = solved_.back().upper_linked;
    result.pieces.push_back(std::move(all));
    return result;
  }

  const SlabTask& task_;
  const std::vector<Component>& components_;
  std::vector<ConformedSlice> made_;
  std::vector<const ConformedSlice*> slices_;
  std::vector<SolvedSlab> solved_;
};

}  // namespace

std::optional<SolvedSlab> solve_through(const SlabTask& task, const std::vector<Component>& components,
                                        const std::vector<Interpolated>& between, const Progress& progress) {
  double z = task.lower.z;
  for (const Interpolated& one : between) {
    if (!(one.z > z)) return std::nullopt;
    z = one.z;
  }
  if (!(task.upper.z > z)) return std::nullopt;
  try {
    return ThroughSlices(task, components).run(between, progress);
  } catch (const InputError&) {  // too close for the interpolated slices; the given ones alone may still do
    return std::nullopt;
  }
}

Topology topology_of(const ConformedSlice& lower, const ConformedSlice& upper, const SolvedSlab& solved) {
  // Pieces share the slices' points only within one piece, so they can be counted one by one.
  Topology all;
  for (const SlabSolid& piece : solved.pieces) {
    std::vector<Triangle> boundary;
    each_outer_face(piece.tetrahedra, [&](const Triangle& face) { boundary.push_back(face); });
    const auto on_slices = static_cast<std::uint32_t>(lower.planar.points.size() + upper.planar.points.size());
    const Topology one =
        counted_topology(piece.tetrahedra, boundary,
                         {0, on_slices, on_slices, on_slices + static_cast<std::uint32_t>(piece.added.size())});
    all.pieces += one.pieces;
    all.handles += one.handles;
    all.bubbles += one.bubbles;
  }
  return all;
}

}  // namespace odontoscope::delaunay
