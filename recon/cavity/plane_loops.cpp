#include "recon/cavity/plane_loops.h"

#include <map>
#include <utility>

namespace odontoscope::cavity {

std::vector<Loop> loops_at(const SurfaceMesh& surface, double z) {
  using Edge = std::pair<PointIndex, PointIndex>;  // from below to above
  // Through each triangle that is cut, from the edge where one enters its section to the edge where one leaves it.
  std::map<Edge, Edge> onward;
  const auto above = [&](PointIndex p) { return surface.points[p].z >= z; };
  for (const Triangle& t : surface.triangles) {
    Edge up{}, down{};
    int crossings = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const PointIndex a = t[k], b = t[(k + 1) % 3];
      if (above(a) == above(b)) continue;
      ++crossings;
      (above(b) ? up : down) = above(b) ? Edge{a, b} : Edge{b, a};
    }
    if (crossings == 2) onward[up] = down;
  }
  std::vector<Loop> loops;
  while (!onward.empty()) {
    Loop loop;
    for (auto at = onward.begin(); at != onward.end();) {
      const auto& [low, high] = at->first;
      const Point3 &a = surface.points[low], &b = surface.points[high];
      const double share = (z - a.z) / (b.z - a.z);
      loop.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
      const Edge next = at->second;
      onward.erase(at);
      at = onward.find(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

bool is_inside(const Loop& loop, const Point2& place) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y > place.y) == (b.y > place.y)) continue;
    if (place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

}  // namespace odontoscope::cavity
