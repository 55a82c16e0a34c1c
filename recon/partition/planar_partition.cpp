#include "recon/partition/planar_partition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/delaunay/constrained.h"
#include "recon/partition/contour_overlay.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {
namespace {

using delaunay::Cdt;
using delaunay::EdgeKind;
using delaunay::Face;
using delaunay::Kernel;
using delaunay::none;
using delaunay::Planar;
using delaunay::SlicePoint;
using delaunay::SpokeIndex;
using delaunay::TriangleIndex;
using delaunay::Vertex;

enum class Fineness { gabriel, delaunay, constrained };

/// A part of a given border, from share `t0` to `t1` of the way; `u0` and `u1` are those from the other end, kept apart
/// so that a border and its mirror image are split alike to the last bit.
struct Piece {
  SlicePoint a, b;
  std::uint32_t border = 0;
  double t0 = 0, u0 = 1, t1 = 1, u1 = 0;
};

/// Splits borders until all are Gabriel, or Delaunay: rounds of triangulating anew from the points alone, as for
/// contours (recon/delaunay/refine.h).
class Conformer {
 public:
  Conformer(const Borders& given, Fineness fineness, const Progress& progress)
      : given_(given), fineness_(fineness), progress_(progress), points_(given.points) {
    for (std::uint32_t i = 0; i < given.pieces.size(); ++i)
      pieces_.push_back({SlicePoint(given.pieces[i].a), SlicePoint(given.pieces[i].b), i});
    Table<SlicePoint, std::vector<SlicePoint>> ends(points_.size());
    for (const Piece& piece : pieces_) {
      ends[piece.a].push_back(piece.b);
      ends[piece.b].push_back(piece.a);
    }
    sharp_.resize(points_.size());
    for (const SlicePoint p : points_.indices()) sharp_[p] = has_sharp_corner(p, ends[p]);
  }

  /// False if doubles do not suffice.
  bool run() {
    const std::size_t most = limits::steiner_factor * points_.size() + limits::steiner_free;
    for (;;) {
      progress_.check();
      if (!triangulate()) return false;
      if (fineness_ == Fineness::constrained) return true;
      if (!split_encroached()) return true;
      if (points_.size() > most) return false;
    }
  }

  Planar planar() {
    Planar result;
    result.insertion_order = order_;
    result.points = points_;
    result.slice_point.resize(points_.size());
    std::iota(result.slice_point.begin(), result.slice_point.end(), 0u);
    result.next.assign(points_.size(), none);
    result.previous = result.next;
    result.region_of.assign(points_.size(), none);
    delaunay::copy_triangles(cdt_, result);
    label_triangles(result);
    return result;
  }

 private:
  bool has_sharp_corner(SlicePoint p, const std::vector<SlicePoint>& others) const {
    for (std::size_t i = 0; i < others.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Point2 at = points_[p], q = points_[others[i]], r = points_[others[k]];
        if ((q.x - at.x) * (r.x - at.x) + (q.y - at.y) * (r.y - at.y) > 0) return true;
      }
    return false;
  }

  bool triangulate() {
    cdt_.clear();
    order_ = delaunay::order_of(points_);
    vertices_ = delaunay::insert_points(cdt_, points_, order_);
    for (const SlicePoint p : order_)
      if (vertices_[p]->info() != p) return false;  // rounded onto another point
    try {
      for (const Piece& piece : pieces_) cdt_.insert_constraint(vertices_[piece.a], vertices_[piece.b]);
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      return false;
    }
    of_edge_.clear();
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) of_edge_[std::minmax(pieces_[i].a, pieces_[i].b)] = i;
    return of_edge_.size() == count_constrained();
  }

  /// A border that runs through a point that is no end of it is cut there by the triangulation.
  std::size_t count_constrained() const {
    std::size_t count = 0;
    for (auto edge = cdt_.finite_edges_begin(); edge != cdt_.finite_edges_end(); ++edge)
      count += edge->first->is_constrained(edge->second);
    return count;
  }

  bool split_encroached() {
    std::vector<std::pair<std::uint32_t, SlicePoint>> splits;  // piece, and the point that is in its way
    for (auto edge = cdt_.finite_edges_begin(); edge != cdt_.finite_edges_end(); ++edge) {
      if (!edge->first->is_constrained(edge->second)) continue;
      if (fineness_ == Fineness::delaunay && delaunay::is_delaunay(cdt_, edge->first, edge->second)) continue;
      const Vertex point = delaunay::encroacher(cdt_, edge->first, edge->second);
      if (point == Vertex()) continue;
      const SlicePoint a = edge->first->vertex(Cdt::ccw(edge->second))->info();
      const SlicePoint b = edge->first->vertex(Cdt::cw(edge->second))->info();
      splits.emplace_back(of_edge_.at(std::minmax(a, b)), point->info());
    }
    std::sort(splits.begin(), splits.end());
    for (const auto& [piece, point] : splits) split(piece, points_[point]);
    return !splits.empty();
  }

  /// Opposite the point if the gap is narrow for the border's length, on a circle round a sharp end, else in the
  /// middle.
  void split(std::uint32_t number, Point2 v) {
    const Piece piece = pieces_[number];
    const Border& border = given_.pieces[piece.border];
    const Point2 a = given_.points[border.a], b = given_.points[border.b];
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y, length = std::sqrt(square);
    double t = ((v.x - a.x) * x + (v.y - a.y) * y) / square;
    const double gap = portable::hypot(v.x - (a.x + t * x), v.y - (a.y + t * y));
    const bool narrow = gap * odontoscope::limits::narrow_gap < (piece.t1 - piece.t0) * length &&
                        (t - piece.t0) * length > gap && (piece.t1 - t) * length > gap;
    double u = 1 - t;
    if (!narrow) {
      const bool at_start = sharp_[SlicePoint(border.a)] && piece.t0 == 0,
                 at_end = sharp_[SlicePoint(border.b)] && piece.u1 == 0;
      t = (piece.t0 + piece.t1) / 2;
      u = (piece.u0 + piece.u1) / 2;
      if (at_start != at_end) {
        const double share = portable::nearest_power_of_two((at_start ? piece.t1 : piece.u0) * length / 2) / length;
        t = at_start ? share : 1 - share;
        u = at_start ? 1 - share : share;
      }
    }
    const auto mix = [t, u](double from, double to) { return from == to ? from : from * u + to * t; };
    const SlicePoint middle(points_.size());
    points_.push_back({mix(a.x, b.x), mix(a.y, b.y)});
    pieces_[number] = {piece.a, middle, piece.border, piece.t0, piece.u0, t, u};
    pieces_.push_back({middle, piece.b, piece.border, t, u, piece.t1, piece.u1});
  }

  /// From both sides of each border, then over edges that are none.
  void label_triangles(Planar& planar) const {
    constexpr std::uint32_t unknown = none - 1;
    for (auto& triangle : planar.triangles) triangle.region = unknown;
    std::vector<TriangleIndex> stack;
    const auto border = [&](const delaunay::PlanarTriangle& triangle, int k) {
      return of_edge_.find(std::minmax(triangle.v[(k + 1) % 3], triangle.v[(k + 2) % 3]));
    };
    for (const TriangleIndex t : planar.triangles.indices())
      for (int k = 0; k < 3; ++k) {
        const auto found = border(planar.triangles[t], k);
        if (found == of_edge_.end()) continue;
        const Piece& piece = pieces_[found->second];
        const Border& sides = given_.pieces[piece.border];
        const Label label = planar.triangles[t].v[(k + 1) % 3] == piece.a ? sides.left : sides.right;
        if (planar.triangles[t].region == unknown) stack.push_back(t);
        planar.triangles[t].region = label == void_label ? std::uint32_t{none} : label;
      }
    while (!stack.empty()) {
      const TriangleIndex t = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const TriangleIndex other = planar.triangles[t].nb[k];
        if (other == none || planar.triangles[other].region != unknown ||
            border(planar.triangles[t], k) != of_edge_.end())
          continue;
        planar.triangles[other].region = planar.triangles[t].region;
        stack.push_back(other);
      }
    }
  }

  const Borders& given_;
  Fineness fineness_;
  const Progress& progress_;
  Table<SlicePoint, Point2> points_;
  std::vector<Piece> pieces_;
  Table<SlicePoint, bool> sharp_;
  Cdt cdt_;
  Table<SlicePoint, Vertex> vertices_;
  std::vector<SlicePoint> order_;
  std::map<std::pair<SlicePoint, SlicePoint>, std::uint32_t> of_edge_;
};

void set_edge_kinds(PartitionSlice& slice) {
  Planar& planar = slice.planar;
  for (const SlicePoint v : planar.points.indices()) {
    for (const SpokeIndex s : planar.spokes_of(v)) {
      const Label left = slice.label(planar.spokes[s].triangle);
      const Label right = slice.label(planar.right_of(v, s));
      planar.spokes[s].kind = left != right        ? EdgeKind::contour
                              : left == void_label ? EdgeKind::external
                                                   : EdgeKind::internal;
    }
  }
}

/// Each label at most once around each point.
void refuse_checkerboards(const PartitionSlice& slice) {
  const Planar& planar = slice.planar;
  for (const SlicePoint v : planar.points.indices()) {
    std::vector<Label> runs;
    for (const SpokeIndex s : planar.spokes_of(v))
      if (planar.spokes[s].kind == EdgeKind::contour) runs.push_back(slice.label(planar.spokes[s].triangle));
    std::sort(runs.begin(), runs.end());
    if (std::adjacent_find(runs.begin(), runs.end()) == runs.end()) continue;
    throw InternalError(fmt::format("faces of one label meet in the point ({}, {}) at z = {}", planar.points[v].x,
                                    planar.points[v].y, slice.z));
  }
}

}  // namespace

PartitionSlice planar_partition(const Borders& borders, double z, const Progress& progress) {
  PartitionSlice result;
  result.z = z;
  if (borders.pieces.empty()) return result;
  for (const Fineness fineness : {Fineness::gabriel, Fineness::delaunay, Fineness::constrained}) {
    Conformer conformer(borders, fineness, progress);
    if (!conformer.run()) continue;
    result.planar = conformer.planar();
    result.conforming = fineness != Fineness::constrained;
    break;
  }
  if (result.planar.points.empty()) throw InternalError("a slice's borders could not be triangulated");
  result.steiner_points = result.planar.points.size() - borders.points.size();
  delaunay::collect_spokes(result.planar);
  set_edge_kinds(result);
  refuse_checkerboards(result);
  return result;
}

}  // namespace odontoscope::partition
