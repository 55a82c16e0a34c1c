#include "recon/cavity/branches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

#include "recon/cavity/limits.h"

namespace odontoscope::cavity {
namespace {

using NodeIndex = std::uint32_t;
constexpr NodeIndex none = std::numeric_limits<NodeIndex>::max();
constexpr int nobody = -1;

std::tuple<double, double, double> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

NodeIndex widest(const MedialGraph& graph) {
  NodeIndex best = 0;
  for (NodeIndex n = 1; n < graph.nodes.size(); ++n) {
    const auto &a = graph.nodes[n], &b = graph.nodes[best];
    if (a.radius > b.radius || (a.radius == b.radius && coordinates(a.at) < coordinates(b.at))) best = n;
  }
  return best;
}

/// Visits all nodes that can be reached from `from` through nodes for which `enter` is true.
template <class Enter>
void flood(const MedialGraph& graph, NodeIndex from, Enter enter) {
  std::vector<NodeIndex> waiting{from};
  while (!waiting.empty()) {
    const NodeIndex n = waiting.back();
    waiting.pop_back();
    for (std::uint32_t w = graph.first_way[n]; w < graph.first_way[n + 1]; ++w)
      if (enter(graph.ways[w].to)) waiting.push_back(graph.ways[w].to);
  }
}

/// Of the chamber: the ball in which the centroid of all that wide balls fill lies deepest.
NodeIndex centre_of_chamber(const MedialGraph& graph) {
  const NodeIndex start = widest(graph);
  const double least = limits::chamber_share * graph.nodes[start].radius;
  std::vector<char> inside(graph.nodes.size(), 0);
  inside[start] = 1;
  flood(graph, start, [&](NodeIndex n) {
    if (inside[n] || graph.nodes[n].radius < least) return false;
    inside[n] = 1;
    return true;
  });
  Point3 sum;
  double volume = 0;
  for (NodeIndex n = 0; n < graph.nodes.size(); ++n) {
    if (!inside[n]) continue;
    const MedialGraph::Node& node = graph.nodes[n];
    sum = {sum.x + node.volume * node.at.x, sum.y + node.volume * node.at.y, sum.z + node.volume * node.at.z};
    volume += node.volume;
  }
  const Point3 centroid{sum.x / volume, sum.y / volume, sum.z / volume};
  NodeIndex best = start;
  double deepest = -std::numeric_limits<double>::infinity();
  for (NodeIndex n = 0; n < graph.nodes.size(); ++n) {
    if (!inside[n]) continue;
    const double depth = graph.nodes[n].radius - length(graph.nodes[n].at - centroid);
    if (depth > deepest) {
      deepest = depth;
      best = n;
    }
  }
  return best;
}

/// Shortest paths from a root, where a millimetre costs one over the square of the radius.
struct Tree {
  std::vector<NodeIndex> parent;  // none: the root, or out of reach
  std::vector<double> distance;   // along the path, mm; infinite: out of reach
};

Tree shortest_paths(const MedialGraph& graph, NodeIndex root) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Tree tree{std::vector<NodeIndex>(graph.nodes.size(), none), std::vector<double>(graph.nodes.size(), infinity)};
  std::vector<double> cost(graph.nodes.size(), infinity);
  using Waiting = std::pair<double, NodeIndex>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
  cost[root] = tree.distance[root] = 0;
  waiting.push({0, root});
  while (!waiting.empty()) {
    const auto [so_far, n] = waiting.top();
    waiting.pop();
    if (so_far > cost[n]) continue;
    for (std::uint32_t w = graph.first_way[n]; w < graph.first_way[n + 1]; ++w) {
      const MedialGraph::Way& way = graph.ways[w];
      const double radius = (graph.nodes[n].radius + graph.nodes[way.to].radius) / 2;
      const double there = so_far + static_cast<double>(way.length) / (radius * radius);
      if (there >= cost[way.to]) continue;
      cost[way.to] = there;
      tree.parent[way.to] = n;
      tree.distance[way.to] = tree.distance[n] + static_cast<double>(way.length);
      waiting.push({there, way.to});
    }
  }
  return tree;
}

std::vector<NodeIndex> path_to(const Tree& tree, NodeIndex end) {
  std::vector<NodeIndex> path;
  for (NodeIndex n = end; n != none; n = tree.parent[n]) path.push_back(n);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<Point3> places(const MedialGraph& graph, const std::vector<NodeIndex>& path) {
  std::vector<Point3> points;
  for (const NodeIndex n : path) points.push_back(graph.nodes[n].at);
  return points;
}

/// Without the last nodes whose balls reach hardly farther ahead than one a little before them: ways into a corner of the end.
void trim(const MedialGraph& graph, std::vector<NodeIndex>& path) {
  const auto node = [&](std::size_t i) -> const MedialGraph::Node& { return graph.nodes[path[i]]; };
  std::size_t keep = path.size() - 1;
  double since = 0;
  for (std::size_t k = path.size() - 1; k-- > 1;) {
    since += length(node(k + 1).at - node(k).at);
    const double ball = node(k).radius;
    if (since > 2 * ball) break;
    std::size_t behind = k;
    while (behind > 0 && length(node(behind).at - node(k).at) < ball) --behind;
    const Direction way = node(k).at - node(behind).at;
    double reach = ball;
    for (std::size_t i = k + 1; i < path.size(); ++i) reach = std::max(reach, dot(way, node(i).at - node(k).at) / length(way) + node(i).radius);
    if (reach <= (1 + limits::tip_reach) * ball) keep = k;
  }
  path.resize(keep + 1);
}

/// Finds ends one after the other and remembers what their branches cover.
class Explorer {
 public:
  Explorer(const MedialGraph& graph, NodeIndex root)
      : graph_(graph), tree_(shortest_paths(graph, root)), owner_(graph.nodes.size(), nobody), seen_(graph.nodes.size(), 0) {
    for (NodeIndex n = 0; n < graph.nodes.size(); ++n)
      if (std::isfinite(tree_.distance[n])) ends_.push_back(n);
    std::sort(ends_.begin(), ends_.end(), [&](NodeIndex a, NodeIndex b) {
      const double u = reach(a), v = reach(b);
      return u != v ? u > v : coordinates(graph.nodes[a].at) < coordinates(graph.nodes[b].at);
    });
    cover({root}, 0);
  }

  struct Found {
    std::vector<NodeIndex> path;
    double beyond = 0;
  };

  std::vector<Found> explore() {
    std::vector<Found> found;
    double longest = 0, first_mean = 0;
    for (const NodeIndex end : ends_) {
      if (owner_[end] != nobody) continue;
      double beyond = graph_.nodes[end].radius, weight = 0, way = 0;
      NodeIndex n = end;
      while (owner_[n] == nobody && tree_.parent[n] != none) {
        const double step = tree_.distance[n] - tree_.distance[tree_.parent[n]];
        beyond += step;
        way += step;
        weight += step * graph_.nodes[n].radius;
        n = tree_.parent[n];
      }
      const double mean = way > 0 ? weight / way : 0;
      if (found.empty()) first_mean = mean;
      const bool slender = way > 0 && mean >= limits::branch_width * first_mean && beyond >= limits::branch_slenderness * mean &&
                           beyond >= limits::branch_over_root * graph_.nodes[n].radius;
      longest = std::max(longest, slender ? beyond : 0);
      Found one{path_to(tree_, end), beyond};
      const int number = static_cast<int>(found.size());
      if (!slender || beyond < limits::branch_share * longest) {
        cover({end}, owner_[n] == nobody ? 0 : owner_[n]);
        continue;
      }
      // What leads to it, but not a way that is yet to be found: the other half of a ring.
      std::vector<NodeIndex> known;
      const auto own = std::find(one.path.begin(), one.path.end(), n);
      std::copy_if(one.path.begin(), own, std::back_inserter(known), [&](NodeIndex p) { return owner_[p] != nobody; });
      known.insert(known.end(), own, one.path.end());
      cover(known, number);
      found.push_back(std::move(one));
    }
    return found;
  }

  const Tree& tree() const { return tree_; }

 private:
  double reach(NodeIndex n) const { return tree_.distance[n] + graph_.nodes[n].radius; }

  /// All that is within reach of the path's balls and joined to them.
  void cover(const std::vector<NodeIndex>& path, int number) {
    const MedialGraph::Node* last = nullptr;
    for (const NodeIndex p : path) {
      const MedialGraph::Node& ball = graph_.nodes[p];
      if (owner_[p] == nobody) owner_[p] = number;
      if (last != nullptr && p != path.back() && length(ball.at - last->at) < 0.5 * last->radius) continue;
      last = &ball;
      ++stamp_;
      seen_[p] = stamp_;
      flood(graph_, p, [&](NodeIndex n) {
        if (seen_[n] == stamp_ || length(graph_.nodes[n].at - ball.at) > limits::branch_cover * ball.radius) return false;
        seen_[n] = stamp_;
        if (owner_[n] == nobody) owner_[n] = number;
        return true;
      });
    }
  }

  const MedialGraph& graph_;
  Tree tree_;
  std::vector<int> owner_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t stamp_ = 0;
  std::vector<NodeIndex> ends_;
};

double median_radius(const MedialGraph& graph, const std::vector<NodeIndex>& path) {
  std::vector<double> radii;
  for (const NodeIndex n : path) radii.push_back(graph.nodes[n].radius);
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
  return radii[radii.size() / 2];
}

double height(const Point3& p, const std::optional<Direction>& axis) { return axis ? dot(*axis, {p.x, p.y, p.z}) : 0; }

/// One line from the upper end to the lower.
std::vector<NodeIndex> through_tube(const MedialGraph& graph, std::vector<NodeIndex> a, std::vector<NodeIndex> b, const std::optional<Direction>& axis) {
  trim(graph, a);
  trim(graph, b);
  NodeIndex upper = a.back(), lower = b.back();
  const auto key = [&](NodeIndex n) { return std::tuple_cat(std::tuple{-height(graph.nodes[n].at, axis)}, coordinates(graph.nodes[n].at)); };
  if (key(lower) < key(upper)) std::swap(upper, lower);
  return path_to(shortest_paths(graph, upper), lower);
}

/// Where two of the shortest paths from the root meet that have gone round different sides of a handle.
struct Seam {
  NodeIndex a = none, b = none;
  std::vector<NodeIndex> loop;  // from where the paths part, to a, to b, and back
};

/// Half way along both paths from where they part, the straight line from one to the other leaves the void: this is what makes a handle. Of all
/// such places the one whose halves lie farthest apart. Only ways at least half as wide as `radius` count.
Seam find_seam(const MedialGraph& graph, const WallTree& wall, const Tree& tree, double radius) {
  Seam best;
  double farthest = 0;
  for (NodeIndex a = 0; a < graph.nodes.size(); ++a) {
    for (std::uint32_t w = graph.first_way[a]; w < graph.first_way[a + 1]; ++w) {
      const NodeIndex b = graph.ways[w].to;
      if (b <= a || tree.parent[a] == b || tree.parent[b] == a || !std::isfinite(tree.distance[a])) continue;
      if (std::min(graph.nodes[a].radius, graph.nodes[b].radius) < radius / 2) continue;
      NodeIndex u = a, v = b;
      std::vector<NodeIndex> up, down;
      while (u != v) {
        // Away from the root distances grow, so the farther one cannot be above the other.
        NodeIndex& farther = tree.distance[u] >= tree.distance[v] ? u : v;
        (farther == u ? up : down).push_back(farther);
        farther = tree.parent[farther];
      }
      if (up.size() + down.size() < 4) continue;
      const auto half = [&](const std::vector<NodeIndex>& way, NodeIndex end) {
        const double middle = (tree.distance[end] + tree.distance[u]) / 2;
        for (const NodeIndex n : way)
          if (tree.distance[n] <= middle) return n;
        return u;
      };
      const MedialGraph::Node &p = graph.nodes[half(up, a)], &q = graph.nodes[half(down, b)];
      const double apart = length(p.at - q.at);
      if (apart <= farthest || apart <= p.radius + q.radius) continue;
      const Point3 middle{(p.at.x + q.at.x) / 2, (p.at.y + q.at.y) / 2, (p.at.z + q.at.z) / 2};
      if (wall.clearance(middle) > 0) continue;
      farthest = apart;
      best = {a, b, {u}};
      best.loop.insert(best.loop.end(), up.rbegin(), up.rend());
      best.loop.insert(best.loop.end(), down.begin(), down.end());
      best.loop.push_back(u);
    }
  }
  return best;
}

}  // namespace

Branches find_branches(const MedialGraph& graph, const WallTree& wall, long handles, const std::optional<Direction>& axis) {
  Branches result;
  result.root = centre_of_chamber(graph);
  result.root_radius = graph.nodes[result.root].radius;
  Explorer explorer(graph, result.root);
  std::vector<Explorer::Found> found = explorer.explore();
  if (handles > 0 && !found.empty()) {
    const Seam seam = find_seam(graph, wall, explorer.tree(), median_radius(graph, found.front().path));
    if (seam.a != none) {
      result.loops.push_back(places(graph, seam.loop));
      // Both halves of a ring seem to end where they meet.
      const bool ring = std::all_of(found.begin(), found.end(), [&](const Explorer::Found& one) {
        const MedialGraph::Node& tip = graph.nodes[one.path.back()];
        return length(tip.at - graph.nodes[seam.a].at) <= 3 * limits::branch_cover * graph.nodes[seam.a].radius;
      });
      if (ring) found.clear();
    }
  }
  double widths = 0;
  for (const Explorer::Found& one : found) widths = std::max(widths, median_radius(graph, one.path));
  if (found.size() <= 2) result.has_chamber = !found.empty() && result.root_radius > limits::chamber_over_tube * widths;
  if (!result.has_chamber && found.size() == 2 && result.loops.empty()) {
    const std::vector<NodeIndex> path = through_tube(graph, found[0].path, found[1].path, axis);
    result.through = true;
    result.branches.push_back({places(graph, path), found[0].beyond + found[1].beyond});
    return result;
  }
  for (Explorer::Found& one : found) {
    trim(graph, one.path);
    if (one.path.size() >= 2) result.branches.push_back({places(graph, one.path), one.beyond});
  }
  return result;
}

}  // namespace odontoscope::cavity
