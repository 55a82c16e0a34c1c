#include "recon/cavity/medial_paths.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace odontoscope::cavity {

double cost_of(const MedialGraph& graph, NodeIndex from, const MedialGraph::Edge& way) {
  const double radius = (graph.nodes[from].radius + graph.nodes[way.to].radius) / 2;
  return static_cast<double>(way.length) / (radius * radius);
}

PathTree shortest_paths(const MedialGraph& graph, NodeIndex root, NodeIndex until) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t count = graph.nodes.size();
  PathTree tree{std::vector<NodeIndex>(count, no_node), std::vector<double>(count, infinity),
                std::vector<double>(count, infinity)};
  using Waiting = std::pair<double, NodeIndex>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
  tree.cost[root] = tree.distance[root] = 0;
  waiting.push({0, root});
  while (!waiting.empty()) {
    const auto [so_far, n] = waiting.top();
    waiting.pop();
    if (n == until) break;
    if (so_far > tree.cost[n]) continue;
    for (std::uint32_t w = graph.first_way[n]; w < graph.first_way[n + 1]; ++w) {
      const MedialGraph::Edge& way = graph.ways[w];
      const double there = so_far + cost_of(graph, n, way);
      if (there >= tree.cost[way.to]) continue;
      tree.cost[way.to] = there;
      tree.parent[way.to] = n;
      tree.distance[way.to] = tree.distance[n] + static_cast<double>(way.length);
      waiting.push({there, way.to});
    }
  }
  return tree;
}

std::vector<NodeIndex> path_to(const PathTree& tree, NodeIndex end) {
  std::vector<NodeIndex> path;
  for (NodeIndex n = end; n != no_node; n = tree.parent[n]) path.push_back(n);
  std::reverse(path.begin(), path.end());
  return path;
}

double median_radius(const MedialGraph& graph, const std::vector<NodeIndex>& path) {
  std::vector<double> radii;
  for (const NodeIndex n : path) radii.push_back(graph.nodes[n].radius);
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
  return radii[radii.size() / 2];
}

std::vector<Point3> places(const MedialGraph& graph, const std::vector<NodeIndex>& path) {
  std::vector<Point3> points;
  for (const NodeIndex n : path) points.push_back(graph.nodes[n].at);
  return points;
}

}  // namespace odontoscope::cavity
