#pragma once
// Shortest ways through a void's medial graph that prefer width.

#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "recon/cavity/medial_graph.h"

namespace odontoscope::cavity {

using NodeIndex = std::uint32_t;
inline constexpr NodeIndex no_node = std::numeric_limits<NodeIndex>::max();

/// To order by, where nothing else decides.
inline std::tuple<double, double, double> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

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

/// Shortest paths from a root, where a millimetre costs one over the square of the radius.
struct PathTree {
  std::vector<NodeIndex> parent;  // no_node: the root, or out of reach
  std::vector<double> distance;   // along the path, mm; infinite: out of reach
  std::vector<double> cost;
};

double cost_of(const MedialGraph& graph, NodeIndex from, const MedialGraph::Edge& way);
/// `until`: it is enough to know the path to this node.
PathTree shortest_paths(const MedialGraph& graph, NodeIndex root, NodeIndex until = no_node);
/// From the root.
std::vector<NodeIndex> path_to(const PathTree& tree, NodeIndex end);

double median_radius(const MedialGraph& graph, const std::vector<NodeIndex>& path);
std::vector<Point3> places(const MedialGraph& graph, const std::vector<NodeIndex>& path);

}  // namespace odontoscope::cavity
