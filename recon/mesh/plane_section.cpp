#include "recon/mesh/plane_section.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace odontoscope {
namespace {

class Tracer {
 public:
  Tracer(const SurfaceMesh& mesh, const EdgeMates& mates, const std::vector<std::uint32_t>& crossing, double height,
         Side side)
      : mesh_(mesh), mates_(mates), height_(height), side_(side) {
    taken_.reserve(crossing.size());
    for (const std::uint32_t t : crossing) taken_.emplace(t, false);
  }

  /// The trace through triangle `t`, forwards until it closes or ends, then backwards from `t` if it ended.
  SectionTrace through(std::uint32_t t) {
    SectionTrace trace;
    const HalfEdge entry = downward(t);
    trace.edges.push_back(entry);
    trace.closed = walk(t, upward(t), entry, trace.edges);
    if (trace.closed) return trace;
    std::vector<HalfEdge> back;
    const HalfEdge before = mates_.mate[entry];
    if (passable(before) && !taken_.at(before / 3)) walk(before / 3, other(before), entry, back);
    std::reverse(back.begin(), back.end());
    trace.edges.insert(trace.edges.begin(), back.begin(), back.end());
    return trace;
  }

  bool is_taken(std::uint32_t t) const { return taken_.at(t); }

 private:
  bool above(PointIndex v) const { return lies_above(mesh_.points[v], height_, side_); }
  bool crosses(HalfEdge h) const { return above(start(mesh_, h)) != above(end(mesh_, h)); }
  /// The half-edge of a crossed triangle that runs down through the plane, or up. From the one to the other the
  /// material is left.
  HalfEdge downward(std::uint32_t t) const {
    for (HalfEdge h = 3 * t;; ++h) {
      if (crosses(h) && above(start(mesh_, h))) return h;
    }
  }
  HalfEdge upward(std::uint32_t t) const {
    for (HalfEdge h = 3 * t;; ++h) {
      if (crosses(h) && !above(start(mesh_, h))) return h;
    }
  }
  HalfEdge other(HalfEdge h) const {
    const HalfEdge n = next(h);
    return crosses(n) ? n : next(n);
  }
  static bool passable(HalfEdge mate) { return mate < EdgeMates::no_edge; }

  /// Leaves triangle `t` by `exit` and goes on, noting each exit. True if that leads back through `entry`.
  bool walk(std::uint32_t t, HalfEdge exit, HalfEdge entry, std::vector<HalfEdge>& edges) {
    taken_.at(t) = true;
    for (;;) {
      const HalfEdge mate = mates_.mate[exit];
      if (mate == entry) return true;
      edges.push_back(exit);
      if (!passable(mate) || taken_.at(mate / 3)) return false;
      taken_.at(mate / 3) = true;
      exit = other(mate);
    }
  }

  const SurfaceMesh& mesh_;
  const EdgeMates& mates_;
  double height_;
  Side side_;
  std::unordered_map<std::uint32_t, bool> taken_;
};

void cut(const SurfaceMesh& surface, const Triangle& t, double height, Side side,
         std::vector<SectionSegment>& segments) {
  std::array<Point2, 2> ends;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &a = surface.points[t[k]], &b = surface.points[t[(k + 1) % 3]];
    if (lies_above(a, height, side) != lies_above(b, height, side)) ends[count++] = crossing_point(a, b, height);
  }
  if (count == 2 && !(ends[0] == ends[1])) segments.push_back({ends[0], ends[1]});
}

}  // namespace

Point2 crossing_point(const Point3& a, const Point3& b, double height) {
  const Point3 &low = b.z < a.z ? b : a, &high = b.z < a.z ? a : b;
  if (high.z == height) return {high.x, high.y};
  if (low.z == height) return {low.x, low.y};
  const double share = (height - low.z) / (high.z - low.z);
  return {low.x + share * (high.x - low.x), low.y + share * (high.y - low.y)};
}

std::vector<std::vector<Point2>> section_loops(const SurfaceMesh& surface, double height, Side side) {
  using Edge = std::pair<PointIndex, PointIndex>;  // from below to above
  // Through each triangle that is cut, from the edge where one enters its section to the edge where one leaves it.
  std::map<Edge, Edge> onward;
  const auto above = [&](PointIndex p) { return lies_above(surface.points[p], height, side); };
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
  std::vector<std::vector<Point2>> loops;
  while (!onward.empty()) {
    std::vector<Point2> loop;
    for (auto at = onward.begin(); at != onward.end();) {
      loop.push_back(crossing_point(surface.points[at->first.first], surface.points[at->first.second], height));
      const Edge next = at->second;
      onward.erase(at);
      at = onward.find(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<SectionTrace> section_traces(const SurfaceMesh& mesh, const EdgeMates& mates,
                                         const std::vector<std::uint32_t>& crossing, double height, Side side) {
  Tracer tracer(mesh, mates, crossing, height, side);
  std::vector<SectionTrace> traces;
  for (const std::uint32_t t : crossing) {
    if (!tracer.is_taken(t)) traces.push_back(tracer.through(t));
  }
  return traces;
}

std::vector<PlaneSection> sections(const SurfaceMesh& surface, const std::vector<double>& heights) {
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  std::vector<PlaneSection> result(heights.size());
  for (const Triangle& t : surface.triangles) {
    const auto [low, high] = std::minmax({surface.points[t[0]].z, surface.points[t[1]].z, surface.points[t[2]].z});
    const auto first =
        std::lower_bound(order.begin(), order.end(), low, [&](std::size_t i, double z) { return heights[i] < z; });
    for (auto i = first; i != order.end() && heights[*i] <= high; ++i) {
      cut(surface, t, heights[*i], Side::below, result[*i].below);
      cut(surface, t, heights[*i], Side::above, result[*i].above);
    }
  }
  return result;
}

}  // namespace odontoscope
