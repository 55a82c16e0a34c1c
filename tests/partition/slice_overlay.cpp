#include "tests/partition/slice_overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/oracle_parts.h"
#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

double distance_to(Point2 p, Point2 a, Point2 b) {
  const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double length = std::hypot(dx, dy), along = (px * dx + py * dy) / length;
  if (along <= 0) return std::hypot(px, py);
  if (along >= length) return std::hypot(p.x - b.x, p.y - b.y);
  return std::abs(px * dy - py * dx) / length;
}

/// Exact.
bool on(Point2 p, Point2 a, Point2 b) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool upper_half(Point2 from, Point2 to) { return to.y > from.y || (to.y == from.y && to.x > from.x); }

/// Counter-clockwise from +x, of directions from `p`.
bool before(Point2 p, Point2 a, Point2 b) {
  if (upper_half(p, a) != upper_half(p, b)) return upper_half(p, a);
  return turn(p, a, b) > 0;
}

bool cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

Point2 crossing(Point2 a, Point2 b, Point2 c, Point2 d) {
  const long double dx = (long double)b.x - a.x, dy = (long double)b.y - a.y, ex = (long double)d.x - c.x,
                    ey = (long double)d.y - c.y;
  const long double t = (((long double)c.x - a.x) * ey - ((long double)c.y - a.y) * ex) / (dx * ey - dy * ex);
  return {double(a.x + t * dx), double(a.y + t * dy)};
}

}  // namespace

SliceOverlay::SliceOverlay(const Slice& slice, const std::vector<std::string>& structures, const PartitionRule& rule) {
  double largest = 0;
  for (std::size_t s = 0; s < structures.size(); ++s) {
    ContourStack alone;
    alone.slices = {slice};
    rings_.push_back(slices_of(alone, structures[s]).front().rings);
    for (const auto& ring : rings_.back())
      for (std::size_t i = 0; i < ring.size(); ++i) {
        edges_.push_back({ring[i], ring[(i + 1) % ring.size()], Label(s + 1)});
        largest = std::max({largest, std::abs(ring[i].x), std::abs(ring[i].y)});
      }
  }
  for (const std::string& name : rule.priority) {
    const auto at = std::find(structures.begin(), structures.end(), name);
    if (at != structures.end()) by_rank_.push_back(Label(at - structures.begin() + 1));
  }
  rounding_ = rounding_ulps * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
  find_cuts();
}

Label SliceOverlay::label_at(Point2 p) const {
  for (Label label : by_rank_) {
    bool inside = false;
    for (const auto& ring : rings_[label - 1]) inside = inside != is_inside(ring, p);
    if (inside) return label;
  }
  return void_label;
}

double SliceOverlay::distance(Point2 p, Label of) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_)
    if (of == void_label || edge.label == of) least = std::min(least, distance_to(p, edge.a, edge.b));
  return least;
}

bool SliceOverlay::clear(Point2 p) const {
  return std::all_of(edges_.begin(), edges_.end(),
                     [&](const Edge& e) { return on(p, e.a, e.b) || distance_to(p, e.a, e.b) > rounding_; });
}

std::vector<Label> SliceOverlay::round(Point2 p) const {
  std::vector<Point2> directions;
  struct Sector {
    Point2 from{}, to{};  // counter-clockwise
    bool cut = false, inside = false;
  };
  std::vector<Sector> sectors(rings_.size());
  for (std::size_t s = 0; s < rings_.size(); ++s)
    for (const auto& ring : rings_[s]) sectors[s].inside = sectors[s].inside != is_inside(ring, p);
  for (const Edge& edge : edges_) {
    if (!on(p, edge.a, edge.b)) continue;
    Sector& sector = sectors[edge.label - 1];
    sector.cut = true;
    if (!(edge.b == p)) directions.push_back(sector.from = edge.b);
    if (!(edge.a == p)) directions.push_back(sector.to = edge.a);
  }
  std::sort(directions.begin(), directions.end(), [&](Point2 a, Point2 b) { return before(p, a, b); });
  const auto same = [&](Point2 a, Point2 b) { return !before(p, a, b) && !before(p, b, a); };
  directions.erase(std::unique(directions.begin(), directions.end(), same), directions.end());
  const auto number = [&](Point2 d) {
    return std::size_t(std::find_if(directions.begin(), directions.end(), [&](Point2 e) { return same(d, e); }) -
                       directions.begin());
  };
  std::vector<Label> labels;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, directions.size()); ++i) {  // from direction i to the next
    Label label = void_label;
    for (Label candidate : by_rank_) {
      const Sector& sector = sectors[candidate - 1];
      bool inside = sector.inside;
      if (sector.cut) {
        const std::size_t n = directions.size(), from = number(sector.from), span = (number(sector.to) + n - from) % n;
        inside = (i + n - from) % n < span;
      }
      if (!inside) continue;
      label = candidate;
      break;
    }
    if (labels.empty() || labels.back() != label) labels.push_back(label);
  }
  if (labels.size() > 1 && labels.front() == labels.back()) labels.pop_back();
  return labels;
}

/// Notes a point where more than three faces meet, or may, once all is rounded.
void SliceOverlay::consider(Point2 p, bool given) {
  std::set<Label> near;
  std::size_t passes = 0;
  double longest = 0;
  for (const Edge& edge : edges_)
    if (distance_to(p, edge.a, edge.b) <= rounding_) {
      near.insert(edge.label);
      passes += !(edge.b == p);
      longest = std::max(longest, std::hypot(edge.b.x - edge.a.x, edge.b.y - edge.a.y));
    }
  const bool exact = given && clear(p);
  if (exact ? round(p).size() >= 4 : near.size() >= 3 || passes > 2 || (given && passes >= 2))
    cuts_.push_back({p, cut_share * longest});
}

void SliceOverlay::find_cuts() {
  for (const Edge& edge : edges_) consider(edge.a, true);
  for (std::size_t i = 0; i < edges_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Edge &e = edges_[i], &f = edges_[j];
      if (e.label != f.label && cross(e.a, e.b, f.a, f.b)) consider(crossing(e.a, e.b, f.a, f.b), false);
    }
}

bool SliceOverlay::may_be_cut(Point2 p) const {
  return std::any_of(cuts_.begin(), cuts_.end(), [&](const Cut& cut) {
    return std::hypot(p.x - cut.at.x, p.y - cut.at.y) <= cut.radius + rounding_;
  });
}

double SliceOverlay::cut_area() const {
  double area = 0;
  for (const Cut& cut : cuts_) area += 2 * cut.radius * cut.radius;
  return area;
}

std::vector<long double> SliceOverlay::areas() const {
  std::vector<long double> areas(rings_.size(), 0);
  std::vector<double> xs;
  for (const Edge& e : edges_) xs.push_back(e.a.x);
  for (std::size_t i = 0; i < edges_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Edge &e = edges_[i], &f = edges_[j];
      if (cross(e.a, e.b, f.a, f.b)) xs.push_back(crossing(e.a, e.b, f.a, f.b).x);
    }
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    const auto y_at = [](const Edge& e, long double x) {
      return e.a.y + (x - e.a.x) * ((long double)e.b.y - e.a.y) / ((long double)e.b.x - e.a.x);
    };
    const long double left = xs[i], right = xs[i + 1], middle = (left + right) / 2;
    std::vector<std::pair<long double, const Edge*>> across;
    for (const Edge& e : edges_)
      if (std::min(e.a.x, e.b.x) <= left && std::max(e.a.x, e.b.x) >= right) across.emplace_back(y_at(e, middle), &e);
    std::sort(across.begin(), across.end());
    std::vector<bool> inside(rings_.size(), false);
    for (std::size_t k = 0; k + 1 < across.size(); ++k) {
      const Edge &low = *across[k].second, &high = *across[k + 1].second;
      inside[low.label - 1] = !inside[low.label - 1];
      const auto owner = std::find_if(by_rank_.begin(), by_rank_.end(), [&](Label label) { return inside[label - 1]; });
      if (owner == by_rank_.end()) continue;
      areas[*owner - 1] +=
          (right - left) * (y_at(high, left) - y_at(low, left) + y_at(high, right) - y_at(low, right)) / 2;
    }
  }
  return areas;
}

double SliceOverlay::length() const {
  double length = 0;
  for (const Edge& e : edges_) length += std::hypot(e.b.x - e.a.x, e.b.y - e.a.y);
  return length;
}

std::vector<Point2> SliceOverlay::points() const {
  std::vector<Point2> points;
  for (const Edge& e : edges_) points.push_back(e.a);
  return points;
}

}  // namespace odontoscope::test
