#include "recon/delaunay/bits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/core/union_find.h"

namespace odontoscope::delaunay {
namespace {

double distance_of_points(const std::vector<Point2>& points, const std::vector<Point2>& ring) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point2 p : points) least = std::min(least, distance_to_border(p, ring));
  return least;
}

/// An overlap below this share is rounding.
constexpr double least_overlap = 1e-6;

/// Seen from above; 0 if they overlap.
double gap(const TrackedShape& a, const TrackedShape& b) {
  if (overlap_share(a, b) > least_overlap) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& ring : a.contours)
    for (const auto& other : b.contours)
      least = std::min({least, distance_of_points(ring, other), distance_of_points(other, ring)});
  return least;
}

/// What the contour of the outside that is nearest to a shape encloses.
double area_beside(const TrackedShape& shape, const TrackedShape& all_around) {
  double least = std::numeric_limits<double>::infinity(), area = 0;
  for (const auto& ring : all_around.contours) {
    const double distance = distance_of_points(shape.contours.front(), ring);
    if (distance >= least) continue;
    least = distance;
    area = std::abs(signed_area(ring));
  }
  return area;
}

bool near(const TrackedShape& a, const TrackedShape& b, double reach) {
  return a.low.x <= b.high.x + reach && b.low.x <= a.high.x + reach && a.low.y <= b.high.y + reach &&
         b.low.y <= a.high.y + reach;
}

double width(const TrackedShape& shape) { return std::sqrt(std::max(shape.area, 0.0)); }

class BitSearch {
 public:
  BitSearch(const ShapeGraph& graph, const std::vector<ShapePairs>& apart, const EndsByItself& ends_by_itself)
      : graph_(graph), apart_(apart), ends_by_itself_(ends_by_itself), pieces_(number_shapes()) {
    for (std::size_t k = 0; k < graph.slabs(); ++k)
      for (std::uint32_t i = 0; i < graph.slices()[k].shapes.size(); ++i)
        for (const std::uint32_t j : graph.above(k, i))
          if (!graph.shape(k, i).unbounded && !graph.shape(k + 1, j).unbounded)
            pieces_.join(number(k, i), number(k + 1, j));
    for (std::size_t k = 0; k < graph.slabs(); ++k)
      for (std::uint32_t i = 0; i < graph.slices()[k].shapes.size(); ++i)
        for (const std::uint32_t j : graph.above(k, i)) {
          if (graph.shape(k, i).unbounded) open_.insert(pieces_.find(number(k + 1, j)));
          if (graph.shape(k + 1, j).unbounded) open_.insert(pieces_.find(number(k, i)));
        }
  }

  std::vector<BitLink> run() {
    if (!find_body()) return {};
    collect();
    return bridged();
  }

 private:
  struct Piece {
    double area = 0;
    std::size_t first = 0, last = 0;  // slices
  };
  struct Candidate {
    bool by_itself = false;  // the end is running out: taken only if nothing else joins the bit
    double gap = 0, aside = 0;
    BitLink link;
    bool from_lower = true;  // which of the two hangs free and asks
  };

  std::size_t number_shapes() {
    std::size_t count = 0;
    for (const ShapeSlice& slice : graph_.slices()) {
      first_.push_back(count);
      count += slice.shapes.size();
    }
    return count;
  }
  std::uint32_t number(std::size_t k, std::uint32_t i) const { return static_cast<std::uint32_t>(first_[k] + i); }

  bool find_body() {
    std::map<std::uint32_t, Piece> found;
    double total = 0;
    for (std::size_t k = 0; k < graph_.slices().size(); ++k)
      for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i) {
        const TrackedShape& shape = graph_.shape(k, i);
        if (shape.unbounded) continue;
        Piece& piece = found.try_emplace(pieces_.find(number(k, i)), Piece{0, k, k}).first->second;
        piece.area += shape.area;
        piece.last = k;
        total += shape.area;
      }
    if (found.empty()) return false;
    const auto largest = std::max_element(found.begin(), found.end(),
                                          [](const auto& a, const auto& b) { return a.second.area < b.second.area; });
    const Piece& body = largest->second;
    if (body.area < body_share * total || body.last - body.first + 1 < body_slices) return false;
    body_ = largest->first;
    for (const auto& [root, piece] : found)
      if (root != body_ && piece.area <= bit_share * body.area) bits_.insert(root);
    return !bits_.empty() && bits_.size() <= most_bits;
  }

  void collect() {
    for (std::size_t k = 0; k < graph_.slices().size(); ++k)
      for (std::uint32_t i = 0; i < graph_.slices()[k].shapes.size(); ++i) {
        if (graph_.shape(k, i).unbounded || !bits_.contains(pieces_.find(number(k, i)))) continue;
        for (const bool up : {true, false})
          if ((up ? graph_.free_above(k, i) : graph_.free_below(k, i)) && !is_pit(k, i, up)) collect_from(k, i, up);
      }
    std::stable_sort(found_.begin(), found_.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.by_itself, a.gap, a.aside, a.link.slab, a.link.lower, a.link.upper) <
             std::tie(b.by_itself, b.gap, b.aside, b.link.slab, b.link.lower, b.link.upper);
    });
  }

  bool is_pit(std::size_t k, std::uint32_t i, bool up) {
    if (!open_.contains(pieces_.find(number(k, i)))) return false;
    std::size_t row = 1;
    for (auto next = inwards(k, i, up); next && row < row_slices; next = inwards(k, i, up), ++row) {
      i = *next;
      k = up ? k - 1 : k + 1;
    }
    return row < row_slices;
  }
  std::optional<std::uint32_t> inwards(std::size_t k, std::uint32_t i, bool up) const {
    return up ? graph_.same_below(k, i) : graph_.same_above(k, i);
  }

  void collect_from(std::size_t k, std::uint32_t i, bool up) {
    const TrackedShape& shape = graph_.shape(k, i);
    const std::size_t slab = up ? k : k - 1, beyond = up ? k + 1 : k - 1;
    for (std::uint32_t j = 0; j < graph_.slices()[beyond].shapes.size(); ++j) {
      const TrackedShape& other = graph_.shape(beyond, j);
      if (other.unbounded || !near(shape, other, bit_gap * width(shape))) continue;
      const std::uint32_t piece = pieces_.find(number(beyond, j));
      if (piece == pieces_.find(number(k, i)) || (piece != body_ && !bits_.contains(piece))) continue;
      const BitLink link{slab, up ? i : j, up ? j : i};
      const ShapePairs& apart = apart_[slab];
      if (std::find(apart.begin(), apart.end(), std::pair{link.lower, link.upper}) != apart.end()) continue;
      const bool like = ShapeGraph::like(shape, other);
      const double found = gap(shape, other);
      if (found > 0 && ends_by_itself_(k, i, up)) continue;
      if (found > (like ? bit_gap : bit_gap_unlike) * std::min(width(shape), width(other))) continue;
      const double aside = portable::hypot(shape.centroid.x - other.centroid.x, shape.centroid.y - other.centroid.y);
      found_.push_back({ends_by_itself_(k, i, up), found, aside, link, up});
    }
  }

  /// The tree's links that lead to the body.
  std::vector<BitLink> bridged() {
    std::set<std::tuple<std::size_t, std::uint32_t, bool>> taken;  // slab, shape, is it the lower one
    std::vector<BitLink> made;
    for (const Candidate& c : found_) {
      const std::uint32_t lower = number(c.link.slab, c.link.lower), upper = number(c.link.slab + 1, c.link.upper);
      if (pieces_.find(lower) == pieces_.find(upper)) continue;
      if (taken.contains({c.link.slab, c.from_lower ? c.link.lower : c.link.upper, c.from_lower})) continue;
      taken.insert({c.link.slab, c.link.lower, true});
      taken.insert({c.link.slab, c.link.upper, false});
      pieces_.join(lower, upper);
      made.push_back(c.link);
    }
    const std::uint32_t body = pieces_.find(body_);
    std::erase_if(made, [&](const BitLink& link) { return pieces_.find(number(link.slab, link.lower)) != body; });
    std::sort(made.begin(), made.end(), [](const BitLink& a, const BitLink& b) {
      return std::tie(a.slab, a.lower, a.upper) < std::tie(b.slab, b.lower, b.upper);
    });
    return made;
  }

  const ShapeGraph& graph_;
  const std::vector<ShapePairs>& apart_;
  const EndsByItself& ends_by_itself_;
  std::vector<std::size_t> first_;  // number of the first shape of each slice
  UnionFind pieces_;                // shapes
  std::uint32_t body_ = 0;
  std::set<std::uint32_t> open_, bits_;  // pieces
  std::vector<Candidate> found_;
};

}  // namespace

std::vector<BitLink> links_of_bits(const ShapeGraph& graph, const std::vector<ShapePairs>& apart,
                                   const EndsByItself& ends_by_itself) {
  return BitSearch(graph, apart, ends_by_itself).run();
}

bool leaves_through(const TrackedShape& end, const TrackedShape& outside_here, const TrackedShape& outside_next) {
  const double left = gap(end, outside_next);
  if (left > outlet_gap * width(end) || left > outlet_wall * gap(end, outside_here)) return false;
  return area_beside(end, outside_next) >= outlet_taper * area_beside(end, outside_here);
}

namespace {

bool is_canal(const TrackedShape& hole, const TrackedShape& outside_here, const TrackedShape& outside_next) {
  const double around = area_beside(hole, outside_here);
  return hole.area <= canal_share * around && area_beside(hole, outside_next) >= outlet_taper * around;
}

}  // namespace

bool lies_over_notch(const TrackedShape& canal, const TrackedShape& outside_here, const TrackedShape& outside_next) {
  return is_canal(canal, outside_here, outside_next) &&
         overlap_area(canal, {}, outside_next) >= lobe_share * canal.area;
}

bool all_but_reaches_notch(const TrackedShape& canal, const TrackedShape& outside_here,
                           const TrackedShape& outside_next) {
  if (!is_canal(canal, outside_here, outside_next)) return false;
  const double left = gap(canal, outside_next);
  return left <= lobe_gap * width(canal) && left <= outlet_wall * gap(canal, outside_here);
}

}  // namespace odontoscope::delaunay
