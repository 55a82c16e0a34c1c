#include "recon/input/planar_sweep.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>

namespace odontoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// +1: a, b, c turn left; -1: right; 0: on one line. Exact.
int turn(const Point2& a, const Point2& b, const Point2& c) {
  return static_cast<int>(
      Kernel::Orientation_2()(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y)));
}

/// The order of the sweep. Points above each other come from below, as if the plane were tilted a little.
bool before(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Where two segments that are known to cross do so, rounded.
Point2 crossing_point(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double along = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
  const double t = along == 0 ? 0.5 : ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / along;
  const double inside = std::clamp(t, 0.0, 1.0);
  return {a.x + inside * (b.x - a.x), a.y + inside * (b.y - a.y)};
}

using Id = std::uint32_t;

/// A vertex and the edge that starts at it share a number.
struct Corner {
  Point2 at;
  Id contour;  // position in `members`
  Id previous, next;
};

/// The edge of the same number as its first vertex, ends in sweep order.
struct Edge {
  Point2 left, right;
};

class Sweep {
 public:
  Sweep(const std::vector<Contour>& contours, std::span<const std::size_t> members);
  SweepResult run();

 private:
  struct Below;
  /// The edges that the sweep line meets, from below. An entry is handed from edge to edge along a contour.
  struct Entry {
    mutable Id edge;
  };
  struct Below {
    using is_transparent = void;
    const std::vector<Edge>* edges;
    bool operator()(const Entry& a, const Entry& b) const;
    bool operator()(const Entry& a, const Point2& v) const;
  };
  using Status = std::set<Entry, Below>;
  using Place = Status::iterator;

  int side(Id edge, const Point2& v) const { return turn(edges_[edge].left, edges_[edge].right, v); }
  void look_for_equal_points();
  void visit(Id v);
  void open(Id v);
  void hand_over(Id v, Id ended, Id started);
  void close(Id v);
  bool strictly_above_predecessor(Id v, Place place);
  bool strictly_below_successor(Id v, Place place);
  void explain_disorder(Id v, Place a, Place b);
  void nest(Id v, Place above);
  void touch(Id v, Id other);
  void cross(Id a, Id b);
  Breach breach(Breach::Kind kind, Id a, Id b, Point2 at) const;

  std::span<const std::size_t> members_;
  std::vector<Id> first_corner_;  // of each member
  std::vector<Corner> corners_;
  std::vector<Edge> edges_;
  std::vector<Id> order_;
  Status status_;
  std::vector<Place> place_of_;  // of each edge that is in status_
  std::vector<bool> nested_;
  SweepResult result_;
};

bool Sweep::Below::operator()(const Entry& a, const Point2& v) const {
  return turn((*edges)[a.edge].left, (*edges)[a.edge].right, v) > 0;
}

bool Sweep::Below::operator()(const Entry& a, const Entry& b) const {
  const Edge& low = (*edges)[a.edge];
  const Edge& high = (*edges)[b.edge];
  if (low.left == high.left) return turn(low.left, low.right, high.right) > 0;
  if (before(low.left, high.left)) return turn(low.left, low.right, high.left) > 0;
  return turn(high.left, high.right, low.left) < 0;
}

Sweep::Sweep(const std::vector<Contour>& contours, std::span<const std::size_t> members)
    : members_(members), status_(Below{&edges_}), nested_(members.size(), false) {
  std::size_t total = 0;
  for (const std::size_t m : members) total += contours[m].points.size();
  corners_.reserve(total);
  edges_.reserve(total);
  first_corner_.reserve(members.size());
  for (std::size_t m = 0; m < members.size(); ++m) {
    const std::vector<Point2>& points = contours[members[m]].points;
    const Id first = static_cast<Id>(corners_.size());
    const Id last = first + static_cast<Id>(points.size()) - 1;
    first_corner_.push_back(first);
    for (Id i = first; i <= last; ++i) {
      corners_.push_back({points[i - first], static_cast<Id>(m), i == first ? last : i - 1, i == last ? first : i + 1});
    }
  }
  for (const Corner& corner : corners_) {
    const Point2& end = corners_[corner.next].at;
    edges_.push_back(before(corner.at, end) ? Edge{corner.at, end} : Edge{end, corner.at});
  }
  place_of_.resize(total);
  result_.nesting.resize(members.size());
}

SweepResult Sweep::run() {
  struct Key {
    Point2 at;
    Id corner;
  };
  std::vector<Key> keys;
  keys.reserve(corners_.size());
  for (Id i = 0; i < corners_.size(); ++i) keys.push_back({corners_[i].at, i});
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    if (a.at.x != b.at.x) return a.at.x < b.at.x;
    if (a.at.y != b.at.y) return a.at.y < b.at.y;
    return a.corner < b.corner;
  });
  order_.reserve(keys.size());
  for (const Key& key : keys) order_.push_back(key.corner);

  look_for_equal_points();
  for (std::size_t i = 0; i < order_.size() && !result_.breach; ++i) visit(order_[i]);
  return std::move(result_);
}

void Sweep::look_for_equal_points() {
  std::optional<Breach> shared;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const Id a = order_[i - 1], b = order_[i];
    if (corners_[a].at != corners_[b].at) continue;
    if (corners_[a].contour == corners_[b].contour) {
      result_.breach = breach(Breach::Kind::repeated_point, b, a, corners_[b].at);
      return;
    }
    if (!shared) shared = breach(Breach::Kind::touch, b, a, corners_[b].at);
  }
  result_.breach = shared;
}

void Sweep::visit(Id v) {
  const Id in = corners_[v].previous, out = v;
  const bool in_ends = before(corners_[in].at, corners_[v].at);
  const bool out_ends = before(corners_[corners_[v].next].at, corners_[v].at);
  if (in_ends != out_ends) {
    hand_over(v, in_ends ? in : out, in_ends ? out : in);
  } else if (in_ends) {
    close(v);
  } else {
    open(v);
  }
}

void Sweep::open(Id v) {
  const Point2& at = corners_[v].at;
  const Id in = corners_[v].previous, out = v;
  const int opening = turn(at, corners_[in].at, corners_[corners_[v].next].at);
  if (opening == 0) {
    result_.breach = breach(Breach::Kind::fold_back, v, v, at);
    return;
  }
  // Both neighbours of the place found were compared with `at` on the way down the tree.
  const Place above = status_.lower_bound(at);
  if (above != status_.end() && side(above->edge, at) == 0) return touch(v, above->edge);
  nest(v, above);
  const Id low = opening > 0 ? in : out, high = opening > 0 ? out : in;
  place_of_[low] = status_.emplace_hint(above, Entry{low});
  place_of_[high] = status_.emplace_hint(above, Entry{high});
}

void Sweep::hand_over(Id v, Id ended, Id started) {
  const Place place = place_of_[ended];
  if (!strictly_above_predecessor(v, place) || !strictly_below_successor(v, place)) return;
  place->edge = started;
  place_of_[started] = place;
}

void Sweep::close(Id v) {
  const Id in = corners_[v].previous, out = v;
  const int closing = turn(corners_[v].at, corners_[in].at, corners_[corners_[v].next].at);
  if (closing == 0) {
    result_.breach = breach(Breach::Kind::fold_back, v, v, corners_[v].at);
    return;
  }
  const Place low = place_of_[closing > 0 ? out : in], high = place_of_[closing > 0 ? in : out];
  if (std::next(low) != high) return explain_disorder(v, low, high);
  if (!strictly_above_predecessor(v, low) || !strictly_below_successor(v, high)) return;
  status_.erase(low);
  status_.erase(high);
}

bool Sweep::strictly_above_predecessor(Id v, Place place) {
  if (place == status_.begin()) return true;
  const Id below = std::prev(place)->edge;
  const int s = side(below, corners_[v].at);
  if (s == 0) touch(v, below);
  if (s < 0) cross(below, place->edge);
  return s > 0;
}

bool Sweep::strictly_below_successor(Id v, Place place) {
  const Place next = std::next(place);
  if (next == status_.end()) return true;
  const int s = side(next->edge, corners_[v].at);
  if (s == 0) touch(v, next->edge);
  if (s > 0) cross(place->edge, next->edge);
  return s < 0;
}

/// Two edges end in v and are not neighbours in the list, so what stands between them is in the wrong order: there is a
/// neighbouring pair of which the first lies on or above v and the second on or below.
void Sweep::explain_disorder(Id v, Place a, Place b) {
  const auto comes_first = [this](Place from, Place to) {
    while (from != status_.end() && from != to) ++from;
    return from == to;
  };
  if (!comes_first(a, b)) std::swap(a, b);
  for (Place place = std::next(a);; ++place) {
    const int s = place == b ? 1 : side(place->edge, corners_[v].at);
    if (s == 0) return touch(v, place->edge);
    if (s > 0) return cross(std::prev(place)->edge, place->edge);
  }
}

/// At the first vertex of each contour in sweep order: what lies below it tells how deep it is.
void Sweep::nest(Id v, Place above) {
  const Id contour = corners_[v].contour;
  if (nested_[contour]) return;
  nested_[contour] = true;
  const Corner& corner = corners_[v];
  Nesting& nesting = result_.nesting[contour];
  nesting.counter_clockwise = turn(corners_[corner.previous].at, corner.at, corners_[corner.next].at) > 0;
  if (above == status_.begin()) return;
  const Id below = std::prev(above)->edge;
  const Nesting& neighbour = result_.nesting[corners_[below].contour];
  const bool runs_right = edges_[below].left == corners_[below].at;
  const bool inside_neighbour = runs_right == neighbour.counter_clockwise;
  nesting.depth = neighbour.depth + (inside_neighbour ? 1 : 0);
}

void Sweep::touch(Id v, Id other) { result_.breach = breach(Breach::Kind::touch, v, other, corners_[v].at); }

void Sweep::cross(Id a, Id b) {
  const Id first = std::min(a, b), second = std::max(a, b);
  const Point2 at = crossing_point(edges_[first].left, edges_[first].right, edges_[second].left, edges_[second].right);
  result_.breach = breach(Breach::Kind::crossing, first, second, at);
}

Breach Sweep::breach(Breach::Kind kind, Id a, Id b, Point2 at) const {
  const auto number = [this](Id corner) { return corner - first_corner_[corners_[corner].contour]; };
  return {kind, members_[corners_[a].contour], number(a), members_[corners_[b].contour], number(b), at};
}

}  // namespace

SweepResult sweep(const std::vector<Contour>& contours, std::span<const std::size_t> members) {
  return Sweep(contours, members).run();
}

bool collinear(const std::vector<Point2>& points) {
  if (points.size() < 3) return true;
  const Point2& first = points.front();
  const auto second = std::find_if(points.begin(), points.end(), [&](const Point2& p) { return p != first; });
  if (second == points.end()) return true;
  return std::all_of(second, points.end(), [&](const Point2& p) { return turn(first, *second, p) == 0; });
}

bool counter_clockwise(const std::vector<Point2>& simple_polygon) {
  const std::size_t n = simple_polygon.size();
  const std::size_t lowest = static_cast<std::size_t>(
      std::min_element(simple_polygon.begin(), simple_polygon.end(), before) - simple_polygon.begin());
  return turn(simple_polygon[(lowest + n - 1) % n], simple_polygon[lowest], simple_polygon[(lowest + 1) % n]) > 0;
}

}  // namespace odontoscope
