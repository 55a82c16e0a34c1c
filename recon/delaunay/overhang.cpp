#include "recon/delaunay/overhang.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/delaunay/difference_place.h"
#include "recon/delaunay/face_table.h"
#include "recon/delaunay/topology.h"

namespace odontoscope::delaunay {
namespace {

/// Where the bisectors of two edges meet.
Point2 bisectors_meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const double p = 0.5 * (ux * (a.x + b.x) + uy * (a.y + b.y)), q = 0.5 * (vx * (c.x + d.x) + vy * (c.y + d.y));
  const double area = ux * vy - uy * vx;
  return {(p * vy - q * uy) / area, (q * ux - p * vx) / area};
}

double distance(Point2 a, Point2 b) { return portable::hypot(a.x - b.x, a.y - b.y); }

using Edge = std::array<std::uint32_t, 2>;

/// Of one slab, in the assembled numbering: what lies across each face.
class SlabFaces {
 public:
  static constexpr std::uint32_t nothing = FaceTable::vacant;
  struct Tet {
    Tetrahedron v{};
    std::array<std::uint32_t, 4> across{nothing, nothing, nothing, nothing};  // opposite v[i], in the same slab
    bool gone = false;
  };

  SlabFaces(const SolvedStack& stack, const Numbering& numbering, std::size_t slab)
      : slices_{numbering.slice_begin[slab], numbering.slice_begin[slab + 1], numbering.slice_begin[slab + 2]},
        table_(4 * count(stack.slabs[slab])) {
    for (const Tetrahedron& v : assembled_tetrahedra(stack, numbering, slab))
      tets.push_back({v, {nothing, nothing, nothing, nothing}, false});
    for (std::uint32_t t = 0; t < tets.size(); ++t)
      for (std::uint32_t i = 0; i < 4; ++i) {
        std::uint32_t& seen = at(t, i);
        if (seen == nothing) {
          seen = 4 * t + i;
        } else {
          tets[seen / 4].across[seen % 4] = t;
          tets[t].across[i] = seen / 4;
        }
      }
  }

  /// -1: the face opposite v[i] lies in the lower slice; 1: in the upper; 0: in neither.
  int slice_of(std::uint32_t t, std::uint32_t i) const {
    const auto all = [&](std::uint32_t from, std::uint32_t to) {
      return std::all_of(outward_face[i], outward_face[i] + 3,
                         [&](int c) { return tets[t].v[c] >= from && tets[t].v[c] < to; });
    };
    return all(slices_[0], slices_[1]) ? -1 : all(slices_[1], slices_[2]) ? 1 : 0;
  }

  /// The tetrahedron that has this face alone, or has it first; nothing where there is none.
  std::uint32_t with_face(const std::array<std::uint32_t, 3>& face) {
    std::uint32_t& seen = table_(face[0], face[1], face[2]);
    return seen == nothing ? nothing : seen / 4;
  }

  std::array<std::uint32_t, 3> face(std::uint32_t t, std::uint32_t i) const {
    const auto& f = outward_face[i];
    return {tets[t].v[f[0]], tets[t].v[f[1]], tets[t].v[f[2]]};
  }

  std::vector<Tet> tets;

 private:
  static std::size_t count(const std::vector<SlabSolid>& pieces) {
    std::size_t all = 0;
    for (const SlabSolid& piece : pieces) all += piece.tetrahedra.size();
    return all;
  }
  std::uint32_t& at(std::uint32_t t, std::uint32_t i) {
    const auto f = face(t, i);
    return table_(f[0], f[1], f[2]);
  }

  std::array<std::uint32_t, 3> slices_;
  FaceTable table_;
};

class Trimmer {
 public:
  explicit Trimmer(SolvedStack& stack) : stack_(stack), numbering_(stack), slabs_(stack.slabs.size()) {}

  std::vector<TrimmedSlab> run() {
    std::deque<Place> waiting = overhanging();
    while (!waiting.empty()) {
      const Place place = waiting.front();
      waiting.pop_front();
      if (tet(place).gone || !removable(place)) continue;
      tet(place).gone = true;
      for (std::uint32_t i = 0; i < 4; ++i)  // what was covered by it may be free now
        if (const auto next = across(place, i); next && reaches(*next)) waiting.push_back(*next);
    }
    std::vector<TrimmedSlab> trimmed;
    for (std::size_t k = 0; k < slabs_.size(); ++k)
      if (auto one = told(k)) trimmed.push_back(*one);
    if (!trimmed.empty()) take_out();
    return trimmed;
  }

 private:
  struct Place {
    std::size_t slab = 0;
    std::uint32_t tetrahedron = 0;
  };

  SlabFaces& faces(std::size_t slab) {
    if (!slabs_[slab]) slabs_[slab] = std::make_unique<SlabFaces>(stack_, numbering_, slab);
    return *slabs_[slab];
  }
  SlabFaces::Tet& tet(const Place& place) { return faces(place.slab).tets[place.tetrahedron]; }

  /// Of the pieces of a slab, one after the other, as tetrahedra are numbered there.
  float reach_of(const Place& place) const {
    std::size_t number = place.tetrahedron;
    for (const SlabSolid& piece : stack_.slabs[place.slab]) {
      if (number < piece.tetrahedra.size()) return number < piece.reach.size() ? piece.reach[number] : 0.0f;
      number -= piece.tetrahedra.size();
    }
    return 0;
  }
  bool reaches(const Place& place) const { return reach_of(place) > limits::overhang; }

  /// The farthest first: strips go from their far end.
  std::deque<Place> overhanging() const {
    std::vector<std::tuple<float, std::size_t, std::uint32_t>> found;
    for (std::size_t k = 0; k < stack_.slabs.size(); ++k) {
      std::uint32_t number = 0;
      for (const SlabSolid& piece : stack_.slabs[k]) {
        for (std::size_t t = 0; t < piece.reach.size(); ++t)
          if (piece.reach[t] > limits::overhang)
            found.emplace_back(-piece.reach[t], k, number + static_cast<std::uint32_t>(t));
        number += static_cast<std::uint32_t>(piece.tetrahedra.size());
      }
    }
    std::sort(found.begin(), found.end());
    std::deque<Place> places;
    for (const auto& [reach, slab, t] : found) places.push_back({slab, t});
    return places;
  }

  /// What is left beyond the face opposite v[i], in the next slab if the face lies in a slice.
  std::optional<Place> across(const Place& place, std::uint32_t i) {
    const std::uint32_t same = tet(place).across[i];
    if (same != SlabFaces::nothing)
      return tet({place.slab, same}).gone ? std::nullopt : std::optional(Place{place.slab, same});
    const int side = faces(place.slab).slice_of(place.tetrahedron, i);
    if (side == 0 || (side < 0 && place.slab == 0) || (side > 0 && place.slab + 1 == slabs_.size()))
      return std::nullopt;
    const std::size_t other = side < 0 ? place.slab - 1 : place.slab + 1;
    const std::uint32_t there = faces(other).with_face(faces(place.slab).face(place.tetrahedron, i));
    if (there == SlabFaces::nothing || tet({other, there}).gone) return std::nullopt;
    return Place{other, there};
  }

  /// Does the solid go all round the edge?
  bool inside_solid(const Place& start, const Edge& edge) {
    Place at = start;
    std::uint32_t from =
        other_than(at, edge, SlabFaces::nothing);  // the fan is entered through the face opposite to it
    do {
      const std::uint32_t towards = other_than(at, edge, from);
      const std::uint32_t leave = corner(at, from);  // the face that holds the edge and `towards`
      const auto next = across(at, leave);
      if (!next) return false;
      at = *next;
      from = towards;
    } while (at.slab != start.slab || at.tetrahedron != start.tetrahedron);
    return true;
  }
  /// A corner off the edge that is not `but`.
  std::uint32_t other_than(const Place& place, const Edge& edge, std::uint32_t but) {
    for (const std::uint32_t v : tet(place).v)
      if (v != edge[0] && v != edge[1] && v != but) return v;
    return but;
  }
  std::uint32_t corner(const Place& place, std::uint32_t v) {
    const Tetrahedron& all = tet(place).v;
    return static_cast<std::uint32_t>(std::find(all.begin(), all.end(), v) - all.begin());
  }

  /// Is what the tetrahedron shares with the rest's outside one disc? All points lie on the surface, so that takes two
  /// bare faces and solid all round the edge that they do not touch; or three round a point that lifting added.
  bool removable(const Place& place) {
    std::vector<std::uint32_t> bare;
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (across(place, i)) continue;
      if (faces(place.slab).slice_of(place.tetrahedron, i) != 0)
        return false;  // a region's triangle with material on this side only
      bare.push_back(i);
    }
    const Tetrahedron& v = tet(place).v;
    if (bare.size() == 2) return inside_solid(place, {v[bare[0]], v[bare[1]]});
    if (bare.size() != 3) return false;
    const std::uint32_t top = 6 - bare[0] - bare[1] - bare[2];
    return v[top] >= numbering_.added_begin.front();
  }

  Point3 point(std::size_t slab, std::uint32_t v) const {
    for (const std::size_t k : {slab, slab + 1})
      if (v < numbering_.slice_begin[k + 1]) {
        const Point2 p = stack_.slices[k].planar.points[SlicePoint(v - numbering_.slice_begin[k])];
        return {p.x, p.y, stack_.slices[k].z};
      }
    std::size_t number = v - numbering_.added_begin[slab];
    for (const SlabSolid& piece : stack_.slabs[slab]) {
      if (number < piece.added.size()) return piece.added[number];
      number -= piece.added.size();
    }
    throw InternalError("a tetrahedron has a point of no slice and no piece");
  }

  /// What goes from a slab, if anything. Before take_out.
  std::optional<TrimmedSlab> told(std::size_t k) const {
    if (!slabs_[k]) return std::nullopt;
    TrimmedSlab trimmed;
    trimmed.slab = k;
    double largest = 0;
    for (const SlabFaces::Tet& one : slabs_[k]->tets) {
      if (!one.gone) continue;
      const std::vector<Point3> corners{point(k, one.v[0]), point(k, one.v[1]), point(k, one.v[2]), point(k, one.v[3])};
      const Mass mass = mass_of(corners, {{0, 1, 2, 3}});
      ++trimmed.tetrahedra;
      trimmed.volume += mass.volume;
      if (mass.volume <= largest) continue;
      largest = mass.volume;
      trimmed.place = mass.centre;
    }
    if (trimmed.tetrahedra == 0) return std::nullopt;
    trimmed.before = topology_before(k);
    return trimmed;
  }

  Topology topology_before(std::size_t k) const {
    const std::vector<Tetrahedron> all = assembled_tetrahedra(stack_, numbering_, k);
    std::vector<Triangle> boundary;
    each_outer_face(all, [&](const Triangle& face) { boundary.push_back(face); });
    return counted_topology(all, boundary,
                            {numbering_.slice_begin[k], numbering_.slice_begin[k + 2], numbering_.added_begin[k],
                             numbering_.added_begin[k + 1]});
  }

  void take_out() {
    for (std::size_t k = 0; k < slabs_.size(); ++k) {
      if (!slabs_[k]) continue;
      std::size_t number = 0;
      for (SlabSolid& piece : stack_.slabs[k]) {
        std::vector<std::array<std::uint32_t, 4>> left;
        for (const auto& v : piece.tetrahedra)
          if (!slabs_[k]->tets[number++].gone) left.push_back(v);
        if (left.size() == piece.tetrahedra.size()) continue;
        piece.tetrahedra = std::move(left);
        piece.reach.clear();
        drop_unused(piece, numbering_.slice_begin[k + 2] - numbering_.slice_begin[k]);
      }
    }
  }

  SolvedStack& stack_;
  Numbering numbering_;
  std::vector<std::unique_ptr<SlabFaces>> slabs_;
};

/// Of the widest circle's radius beside an edge, within its region; infinity outside all.
double half_width(const Planar& slice, SlicePoint a, SlicePoint b) {
  double least = std::numeric_limits<double>::infinity();
  for (const SpokeIndex s : slice.spokes_of(a)) {
    if (slice.spokes[s].vertex != b) continue;
    for (const TriangleIndex t : {slice.spokes[s].triangle, slice.right_of(a, s)})
      if (slice.inside(t)) least = std::min(least, distance(slice.centres[t].at, slice.points[a]));
  }
  return least;
}

/// Of a tetrahedron whose dual point lies in no region: how far its two edges are apart, over half the width of the
/// narrower region there.
double lean(const SlabTetrahedron& tetrahedron, const Planar& lower, const Planar& upper) {
  const SlabNumbers numbers(lower);
  std::array<SlicePoint, 4> v;  // each in its own slice
  std::transform(tetrahedron.v.begin(), tetrahedron.v.end(), v.begin(), [&](SlabPoint p) { return numbers.own(p); });
  double apart = std::numeric_limits<double>::infinity();
  for (const SlicePoint a : {v[0], v[1]})
    for (const SlicePoint b : {v[2], v[3]}) apart = std::min(apart, distance(lower.points[a], upper.points[b]));
  return apart / std::min(half_width(lower, v[0], v[1]), half_width(upper, v[2], v[3]));
}

}  // namespace

double reach(const SlabTetrahedron& tetrahedron, const Planar& lower, const Planar& upper) {
  const SlabNumbers numbers(lower);
  const auto point = [&](SlabPoint v) { return (numbers.is_lower(v) ? lower : upper).points[numbers.own(v)]; };
  const auto& v = tetrahedron.v;
  const Point2 dual = tetrahedron.lower_count == 3 ? lower.centres[tetrahedron.triangle].at
                      : tetrahedron.lower_count == 1
                          ? upper.centres[tetrahedron.triangle].at
                          : bisectors_meet(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
  const double below = distance(dual, point(v[0])), above = distance(dual, point(v[3]));
  const bool over_material = below > above ? tetrahedron.dual_in_lower : tetrahedron.dual_in_upper;
  if (over_material) return 0;
  double ratio = std::max(below, above) / std::min(below, above);
  if (tetrahedron.lower_count == 2 && !tetrahedron.dual_in_lower && !tetrahedron.dual_in_upper)
    ratio = std::max(ratio, lean(tetrahedron, lower, upper));
  return std::isfinite(ratio) ? ratio : 0;
}

std::vector<TrimmedSlab> trim_overhangs(SolvedStack& stack) {
  if (stack.slabs.empty()) return {};
  return Trimmer(stack).run();
}

}  // namespace odontoscope::delaunay
