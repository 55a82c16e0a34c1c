#include "recon/partition/planar_pieces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "recon/core/error.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 exact(Point2 p) { return {p.x, p.y}; }

int side(Point2 a, Point2 b, Point2 p) { return static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(p))); }

struct ByPlace {
  bool operator()(Point2 a, Point2 b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

/// Of two segments that cross properly.
Point2 crossing(Point2 a, Point2 b, Point2 c, Point2 d) {
  using Number = CGAL::Gmpq;
  const Number ax(a.x), ay(a.y), dx = Number(b.x) - ax, dy = Number(b.y) - ay;
  const Number cx(c.x), cy(c.y), ex = Number(d.x) - cx, ey = Number(d.y) - cy;
  const Number t = ((cx - ax) * ey - (cy - ay) * ex) / (dx * ey - dy * ex);
  return {CGAL::to_double(Number(ax + t * dx)), CGAL::to_double(Number(ay + t * dy))};
}

class Planariser {
 public:
  Planariser(std::vector<Point2>& points, std::vector<ContourPiece>& pieces) : points_(points), pieces_(pieces) {
    for (std::uint32_t p = 0; p < points.size(); ++p) numbers_.emplace(points[p], p);
  }

  std::size_t run() {
    tidy();
    for (std::size_t round = 0; round < limits::planar_rounds; ++round) {
      cuts_.assign(pieces_.size(), {});
      find_cuts();
      if (std::all_of(cuts_.begin(), cuts_.end(), [](const auto& cuts) { return cuts.empty(); })) return crossings_;
      apply_cuts();
      tidy();
    }
    throw InternalError("contours of several structures could not be made planar");
  }

 private:
  std::uint32_t number(Point2 p) {
    const auto [found, fresh] = numbers_.emplace(p, static_cast<std::uint32_t>(points_.size()));
    if (fresh) {
      points_.push_back(p);
      ++crossings_;
    }
    return found->second;
  }

  void tidy() {
    for (ContourPiece& piece : pieces_)
      if (piece.b < piece.a) std::swap(piece.a, piece.b);
    std::sort(pieces_.begin(), pieces_.end(),
              [](const ContourPiece& p, const ContourPiece& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
    std::vector<ContourPiece> kept;
    for (const ContourPiece& piece : pieces_) {
      if (piece.a == piece.b) continue;
      if (!kept.empty() && kept.back().a == piece.a && kept.back().b == piece.b)
        kept.back().toggles ^= piece.toggles;
      else
        kept.push_back(piece);
    }
    pieces_ = std::move(kept);
  }

  void find_cuts() {
    struct Span {
      double low_x, high_x, low_y, high_y;
      std::uint32_t piece;
    };
    std::vector<Span> spans;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const Point2 a = points_[pieces_[i].a], b = points_[pieces_[i].b];
      spans.push_back({std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y), i});
    }
    std::sort(spans.begin(), spans.end(),
              [](const Span& p, const Span& q) { return std::pair(p.low_x, p.piece) < std::pair(q.low_x, q.piece); });
    std::vector<Span> active;
    for (const Span& span : spans) {
      std::erase_if(active, [&](const Span& other) { return other.high_x < span.low_x; });
      for (const Span& other : active)
        if (other.low_y <= span.high_y && span.low_y <= other.high_y) meet(other.piece, span.piece);
      active.push_back(span);
    }
  }

  bool within(std::uint32_t p, const ContourPiece& piece) const {
    const Point2 a = points_[piece.a], b = points_[piece.b], at = points_[p];
    return p != piece.a && p != piece.b && std::min(a.x, b.x) <= at.x && at.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= at.y && at.y <= std::max(a.y, b.y);
  }

  void meet(std::uint32_t i, std::uint32_t k) {
    const ContourPiece s = pieces_[i], t = pieces_[k];
    const Point2 a = points_[s.a], b = points_[s.b], c = points_[t.a], d = points_[t.b];
    const int c_side = side(a, b, c), d_side = side(a, b, d), a_side = side(c, d, a), b_side = side(c, d, b);
    if (c_side == 0 && within(t.a, s)) cuts_[i].push_back(t.a);
    if (d_side == 0 && within(t.b, s)) cuts_[i].push_back(t.b);
    if (a_side == 0 && within(s.a, t)) cuts_[k].push_back(s.a);
    if (b_side == 0 && within(s.b, t)) cuts_[k].push_back(s.b);
    if (c_side * d_side >= 0 || a_side * b_side >= 0) return;
    const Point2 at = crossing(a, b, c, d);
    const double reach = limits::snap_ulps * std::numeric_limits<double>::epsilon() *
                         std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y), std::abs(c.x),
                                   std::abs(c.y), std::abs(d.x), std::abs(d.y)});
    const auto near = [&](std::uint32_t end) {
      return std::abs(points_[end].x - at.x) <= reach && std::abs(points_[end].y - at.y) <= reach;
    };
    std::uint32_t p = t.a;
    if (near(s.a))
      p = s.a;
    else if (near(s.b))
      p = s.b;
    else if (near(t.b))
      p = t.b;
    else if (!near(t.a))
      p = number(at);
    if (p != s.a && p != s.b) cuts_[i].push_back(p);
    if (p != t.a && p != t.b) cuts_[k].push_back(p);
  }

  void apply_cuts() {
    std::vector<ContourPiece> cut;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const ContourPiece piece = pieces_[i];
      auto& cuts = cuts_[i];
      const Point2 a = points_[piece.a], b = points_[piece.b];
      const auto along = [&](std::uint32_t p) {
        return (points_[p].x - a.x) * (b.x - a.x) + (points_[p].y - a.y) * (b.y - a.y);
      };
      std::sort(cuts.begin(), cuts.end(),
                [&](std::uint32_t p, std::uint32_t q) { return std::pair(along(p), p) < std::pair(along(q), q); });
      cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
      std::uint32_t from = piece.a;
      for (const std::uint32_t p : cuts) {
        cut.push_back({from, p, piece.toggles});
        from = p;
      }
      cut.push_back({from, piece.b, piece.toggles});
    }
    pieces_ = std::move(cut);
  }

  std::vector<Point2>& points_;
  std::vector<ContourPiece>& pieces_;
  std::map<Point2, std::uint32_t, ByPlace> numbers_;
  std::vector<std::vector<std::uint32_t>> cuts_;  // of each piece: points to cut it at
  std::size_t crossings_ = 0;
};

}  // namespace

std::size_t make_planar(std::vector<Point2>& points, std::vector<ContourPiece>& pieces) {
  return Planariser(points, pieces).run();
}

}  // namespace odontoscope::partition
