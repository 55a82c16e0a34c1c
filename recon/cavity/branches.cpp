#include "recon/cavity/branches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "recon/cavity/limits.h"
#include "recon/cavity/linking.h"
#include "recon/cavity/medial_paths.h"
#include "recon/cavity/rejoining.h"

namespace odontoscope::cavity {
namespace {

constexpr int nobody = -1, handle_side = -2;

NodeIndex widest(const MedialGraph& graph) {
  NodeIndex best = 0;
  for (NodeIndex n = 1; n < graph.nodes.size(); ++n) {
    const auto &a = graph.nodes[n], &b = graph.nodes[best];
    if (a.radius > b.radius || (a.radius == b.radius && coordinates(a.at) < coordinates(b.at))) best = n;
  }
  return best;
}

struct Chamber {
  std::vector<char> inside;  // of each node: it is wide, and joined to the widest through such
  NodeIndex centre = no_node;
};

/// Its centre is the ball in which the centroid of all that wide balls fill lies deepest.
Chamber chamber_of(const MedialGraph& graph) {
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
  return {std::move(inside), best};
}

/// Does the way stay in the chamber but for its tip, and lead aside from where the longest one does? It is a lobe of a
/// chamber much wider than thick. Opposite the longest way lie horns, and the other arm of a taper.
bool is_lobe(const MedialGraph& graph, const Chamber& chamber, const std::vector<NodeIndex>& path,
             const std::vector<NodeIndex>& longest) {
  const double radius = graph.nodes[chamber.centre].radius;
  double outside = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!chamber.inside[path[i]]) outside += length(graph.nodes[path[i]].at - graph.nodes[path[i - 1]].at);
  if (outside > limits::lobe_tip * radius) return false;
  const Point3& from = graph.nodes[chamber.centre].at;
  const Direction aside = graph.nodes[path.back()].at - from, along = graph.nodes[longest.back()].at - from;
  return dot(aside, along) > -limits::lobe_aside * length(aside) * length(along);
}

/// Without the last nodes whose balls reach hardly farther ahead than one a little before them: ways into a corner of
/// the end.
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
    for (std::size_t i = k + 1; i < path.size(); ++i)
      reach = std::max(reach, dot(way, node(i).at - node(k).at) / length(way) + node(i).radius);
    if (reach <= (1 + limits::tip_reach) * ball) keep = k;
  }
  path.resize(keep + 1);
}

/// Finds ends one after the other and remembers what their branches cover. Where the two sides of a handle meet is no
/// end.
class Explorer {
 public:
  Explorer(const MedialGraph& graph, const PathTree& tree, NodeIndex root, const std::vector<Handle>& handles)
      : graph_(graph), tree_(tree), owner_(graph.nodes.size(), nobody), seen_(graph.nodes.size(), 0) {
    for (NodeIndex n = 0; n < graph.nodes.size(); ++n)
      if (std::isfinite(tree_.distance[n])) ends_.push_back(n);
    std::sort(ends_.begin(), ends_.end(), [&](NodeIndex a, NodeIndex b) {
      const double u = reach(a), v = reach(b);
      return u != v ? u > v : coordinates(graph.nodes[a].at) < coordinates(graph.nodes[b].at);
    });
    cover({root}, 0);
    for (const Handle& handle : handles) {
      loops_.push_back(handle.loop());
      cover(loops_.back(), handle_side);
    }
  }

  std::vector<MedialCanal> explore() {
    std::vector<MedialCanal> found;
    double longest = 0, first_mean = 0;
    for (const NodeIndex end : ends_) {
      if (owner_[end] != nobody) continue;
      double beyond = graph_.nodes[end].radius, weight = 0, way = 0;
      NodeIndex n = end;
      while (owner_[n] == nobody && tree_.parent[n] != no_node) {
        const double step = tree_.distance[n] - tree_.distance[tree_.parent[n]];
        beyond += step;
        way += step;
        weight += step * graph_.nodes[n].radius;
        n = tree_.parent[n];
      }
      const double mean = way > 0 ? weight / way : 0;
      if (found.empty()) first_mean = mean;
      const bool slender = way > 0 && mean >= limits::branch_width * first_mean &&
                           beyond >= limits::branch_slenderness * mean &&
                           beyond >= limits::branch_over_root * graph_.nodes[n].radius;
      const double through = slender ? through_handles(n) : 0;
      longest = std::max(longest, slender ? beyond + through : 0);
      MedialCanal one{path_to(tree_, end), beyond + through};
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
      take_handles(one.path, number);
      found.push_back(std::move(one));
    }
    return found;
  }

 private:
  double reach(NodeIndex n) const { return tree_.distance[n] + graph_.nodes[n].radius; }

  /// How far the way to here leads along handles that no branch has led along yet: the first one that goes on below
  /// gets their length.
  double through_handles(NodeIndex n) const {
    double way = 0;
    for (; owner_[n] == handle_side && tree_.parent[n] != no_node; n = tree_.parent[n])
      way += tree_.distance[n] - tree_.distance[tree_.parent[n]];
    return way;
  }

  void take_handles(const std::vector<NodeIndex>& path, int number) {
    for (const std::vector<NodeIndex>& loop : loops_)
      if (std::any_of(path.begin(), path.end(), [&](NodeIndex p) {
            return owner_[p] == handle_side && std::find(loop.begin(), loop.end(), p) != loop.end();
          }))
        for (const NodeIndex p : loop) owner_[p] = owner_[p] == handle_side ? number : owner_[p];
  }

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
        if (seen_[n] == stamp_ || length(graph_.nodes[n].at - ball.at) > limits::branch_cover * ball.radius)
          return false;
        seen_[n] = stamp_;
        if (owner_[n] == nobody) owner_[n] = number;
        return true;
      });
    }
  }

  const MedialGraph& graph_;
  const PathTree& tree_;
  std::vector<std::vector<NodeIndex>> loops_;
  std::vector<int> owner_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t stamp_ = 0;
  std::vector<NodeIndex> ends_;
};

double height(const Point3& p, const std::optional<Direction>& axis) { return axis ? dot(*axis, {p.x, p.y, p.z}) : 0; }

/// The upper one first.
std::pair<NodeIndex, NodeIndex> ends_of_tube(const MedialGraph& graph, std::vector<NodeIndex> a,
                                             std::vector<NodeIndex> b, const std::optional<Direction>& axis) {
  trim(graph, a);
  trim(graph, b);
  NodeIndex upper = a.back(), lower = b.back();
  const auto key = [&](NodeIndex n) {
    return std::tuple_cat(std::tuple{-height(graph.nodes[n].at, axis)}, coordinates(graph.nodes[n].at));
  };
  if (key(lower) < key(upper)) std::swap(upper, lower);
  return {upper, lower};
}

/// Half as wide as what leads to the place that is farthest from the root.
double least_handle(const MedialGraph& graph, const PathTree& tree) {
  NodeIndex farthest = no_node;
  double reach = -1;
  for (NodeIndex n = 0; n < graph.nodes.size(); ++n) {
    if (!std::isfinite(tree.distance[n]) || tree.distance[n] + graph.nodes[n].radius <= reach) continue;
    farthest = n;
    reach = tree.distance[n] + graph.nodes[n].radius;
  }
  return limits::handle_width * median_radius(graph, path_to(tree, farthest));
}

}  // namespace

Branches find_branches(const MedialGraph& graph, const SurfaceMesh& wall, long handles,
                       const std::optional<Direction>& axis) {
  Branches result;
  Chamber chamber = chamber_of(graph);
  result.root = chamber.centre;
  result.root_radius = graph.nodes[result.root].radius;
  PathTree tree = shortest_paths(graph, result.root);
  std::optional<Linking> linking;
  std::vector<Handle> found_handles;
  if (handles > 0) {
    linking.emplace(wall);
    found_handles = handles_of(graph, tree, *linking, least_handle(graph, tree));
  }
  std::vector<MedialCanal> found = Explorer(graph, tree, result.root, found_handles).explore();
  std::vector<MedialCanal> all = std::exchange(found, {});
  for (MedialCanal& one : all)
    if (found.empty() || !is_lobe(graph, chamber, one.path, all.front().path)) found.push_back(one);
  double widths = 0;
  for (const MedialCanal& one : found) widths = std::max(widths, median_radius(graph, one.path));
  for (const Handle& handle : found_handles) widths = std::max(widths, median_radius(graph, handle.loop()));
  if (found.size() <= 2) {
    // An incisor's chamber has no floor, and is wider than what leads from it both ways.
    const bool both_ways =
        found.size() == 2 && std::min(found[0].beyond, found[1].beyond) > limits::chamber_arms * result.root_radius;
    result.has_chamber =
        widths > 0 && result.root_radius > (both_ways ? limits::chamber_over_arms : limits::chamber_over_tube) * widths;
  }
  if (!result.has_chamber) std::fill(chamber.inside.begin(), chamber.inside.end(), 0);
  if (!result.has_chamber && found.size() == 2) {
    const auto [upper, lower] = ends_of_tube(graph, found[0].path, found[1].path, axis);
    const double beyond = found[0].beyond + found[1].beyond;
    tree = shortest_paths(graph, upper);
    found = {{path_to(tree, lower), beyond}};
    if (linking) found_handles = handles_of(graph, tree, *linking, least_handle(graph, tree));
    result.through = true;
  } else {
    for (MedialCanal& one : found) trim(graph, one.path);
  }
  if (!found_handles.empty() && (result.has_chamber || result.through)) {
    Rejoined ways = rejoined(graph, tree, std::move(found), found_handles, chamber.inside);
    found = std::move(ways.canals);
    for (const std::vector<NodeIndex>& isthmus : ways.isthmuses) result.isthmuses.push_back(places(graph, isthmus));
  }
  for (const MedialCanal& one : found)
    if (one.path.size() >= 2) result.branches.push_back({places(graph, one.path), one.beyond});
  for (const Handle& handle : found_handles) result.loops.push_back(places(graph, handle.loop()));
  return result;
}

}  // namespace odontoscope::cavity
