#include "recon/segmentation/keyholes.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "recon/core/error.h"
#include "recon/core/polygon.h"
#include "recon/mesh/exact_predicates.h"

namespace odontoscope {
namespace {

int turn(const Point2& a, const Point2& b, const Point2& c) {
  return orientation(Point3{a.x, a.y, 0}, Point3{b.x, b.y, 0}, Point3{c.x, c.y, 0}, Point3{a.x, a.y, 1});
}

/// Precondition: `p` is not on the ring.
bool holds(const Ring& ring, const Point2& p) {
  return encloses(ring, p, [&](const Point2& a, const Point2& b) { return (turn(a, b, p) > 0) == (a.y < b.y); });
}

bool less(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Does `p`, which lies on the line through a and b, lie between them, ends counted?
bool between(const Point2& a, const Point2& b, const Point2& p) {
  return !less(p, std::min(a, b, less)) && !less(std::max(a, b, less), p);
}

/// Have the two anything in common but ends that both share?
bool in_the_way(const Point2& p, const Point2& q, const Point2& a, const Point2& b) {
  // Most edges are far away.
  if (std::max(a.x, b.x) < std::min(p.x, q.x) || std::min(a.x, b.x) > std::max(p.x, q.x)) return false;
  if (std::max(a.y, b.y) < std::min(p.y, q.y) || std::min(a.y, b.y) > std::max(p.y, q.y)) return false;
  const int pa = turn(p, q, a), pb = turn(p, q, b), ap = turn(a, b, p), aq = turn(a, b, q);
  if (pa * pb < 0 && ap * aq < 0) return true;
  const auto on = [](int sense, const Point2& from, const Point2& to, const Point2& x) {
    return sense == 0 && !(x == from) && !(x == to) && between(from, to, x);
  };
  return on(pa, p, q, a) || on(pb, p, q, b) || on(ap, a, b, p) || on(aq, a, b, q);
}

bool any_in_the_way(const Point2& p, const Point2& q, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (in_the_way(p, q, ring[i], ring[(i + 1) % ring.size()])) return true;
  }
  return false;
}

std::size_t leftmost(const Ring& ring) {
  return static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), less) - ring.begin());
}

/// The number of the line's point that the bridge ends in.
std::size_t bridge_end(const Ring& line, const Point2& from, const std::vector<const Ring*>& holes) {
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double x = line[i].x - from.x, y = line[i].y - from.y;
    by_distance.emplace_back(x * x + y * y, i);
  }
  std::sort(by_distance.begin(), by_distance.end());
  for (const auto& [distance, i] : by_distance) {
    if (any_in_the_way(from, line[i], line)) continue;
    const auto blocks = [&, end = i](const Ring* hole) { return any_in_the_way(from, line[end], *hole); };
    if (std::none_of(holes.begin(), holes.end(), blocks)) return i;
  }
  throw InternalError("a hole has no point of its outline in view");
}

Ring joined(Ring line, std::vector<const Ring*> holes) {
  std::sort(holes.begin(), holes.end(),
            [](const Ring* a, const Ring* b) { return less((*a)[leftmost(*a)], (*b)[leftmost(*b)]); });
  while (!holes.empty()) {
    const Ring& hole = *holes.front();
    const std::size_t first = leftmost(hole), end = bridge_end(line, hole[first], holes);
    Ring detour(hole.begin() + static_cast<std::ptrdiff_t>(first), hole.end());
    detour.insert(detour.end(), hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(first) + 1);
    detour.push_back(line[end]);
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(end) + 1, detour.begin(), detour.end());
    holes.erase(holes.begin());
  }
  return line;
}

}  // namespace

std::vector<Ring> with_keyholes(const std::vector<Ring>& contours) {
  std::vector<std::size_t> outers;
  std::vector<double> areas;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    areas.push_back(signed_area(contours[c]));
    if (areas[c] > 0) outers.push_back(c);
  }
  std::vector<std::vector<const Ring*>> holes(contours.size());
  for (std::size_t c = 0; c < contours.size(); ++c) {
    if (areas[c] > 0) continue;
    std::size_t owner = contours.size();
    double least = std::numeric_limits<double>::max();
    for (const std::size_t outer : outers) {
      if (areas[outer] >= least || !holds(contours[outer], contours[c].front())) continue;
      owner = outer;
      least = areas[outer];
    }
    if (owner == contours.size()) throw InternalError("a hole lies in no outline");
    holes[owner].push_back(&contours[c]);
  }
  std::vector<Ring> lines;
  for (const std::size_t outer : outers) lines.push_back(joined(contours[outer], holes[outer]));
  return lines;
}

}  // namespace odontoscope
