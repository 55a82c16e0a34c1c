#include "recon/exchange/plane_trace.h"

#include <algorithm>
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
  Trace through(std::uint32_t t) {
    Trace trace;
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

}  // namespace

std::vector<Trace> trace_plane(const SurfaceMesh& mesh, const EdgeMates& mates,
                               const std::vector<std::uint32_t>& crossing, double height, Side side) {
  Tracer tracer(mesh, mates, crossing, height, side);
  std::vector<Trace> traces;
  for (const std::uint32_t t : crossing) {
    if (!tracer.is_taken(t)) traces.push_back(tracer.through(t));
  }
  return traces;
}

Point2 crossing_point(const SurfaceMesh& mesh, HalfEdge edge, double height) {
  const Point3* low = &mesh.points[start(mesh, edge)];
  const Point3* high = &mesh.points[end(mesh, edge)];
  if (high->z < low->z) std::swap(low, high);
  if (high->z == height) return {high->x, high->y};
  if (low->z == height) return {low->x, low->y};
  const double share = (height - low->z) / (high->z - low->z);
  return {low->x + share * (high->x - low->x), low->y + share * (high->y - low->y)};
}

}  // namespace odontoscope
