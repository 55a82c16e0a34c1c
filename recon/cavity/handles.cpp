#include "recon/cavity/handles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace odontoscope::cavity {
namespace {

/// Where two paths of the tree meet that are not the same.
struct Seam {
  double cost = 0;  // of both paths and the way between
  NodeIndex a = no_node, b = no_node;
};

/// What the path from the root to each node adds. Parents first: by cost they do not always come first, for a way
/// between two nodes in one place costs nothing.
std::vector<std::uint64_t> shares_from_root(const MedialGraph& graph, const PathTree& tree, const Linking& linking) {
  std::vector<std::uint64_t> from_root(graph.nodes.size(), 0);
  std::vector<char> known(graph.nodes.size(), 0);
  std::vector<NodeIndex> waiting;
  for (NodeIndex n = 0; n < graph.nodes.size(); ++n) {
    for (NodeIndex up = n; up != no_node && !known[up]; up = tree.parent[up]) waiting.push_back(up);
    for (; !waiting.empty(); waiting.pop_back()) {
      const NodeIndex here = waiting.back(), p = tree.parent[here];
      if (p != no_node) from_root[here] = from_root[p] + linking.contribution(graph.nodes[p].at, graph.nodes[here].at);
      known[here] = 1;
    }
  }
  return from_root;
}

/// The best one for each class of closed ways that can be drawn to one another.
std::vector<Seam> seams_of(const MedialGraph& graph, const PathTree& tree, const Linking& linking) {
  std::vector<NodeIndex> order;
  for (NodeIndex n = 0; n < graph.nodes.size(); ++n)
    if (std::isfinite(tree.cost[n])) order.push_back(n);
  std::sort(order.begin(), order.end(),
            [&](NodeIndex a, NodeIndex b) { return std::tie(tree.cost[a], a) < std::tie(tree.cost[b], b); });
  const std::vector<std::uint64_t> from_root = shares_from_root(graph, tree, linking);
  std::map<std::uint64_t, Seam> best;
  for (const NodeIndex a : order) {
    for (std::uint32_t w = graph.first_way[a]; w < graph.first_way[a + 1]; ++w) {
      const NodeIndex b = graph.ways[w].to;
      if (b <= a || tree.parent[a] == b || tree.parent[b] == a) continue;
      const std::uint64_t round =
          from_root[a] + linking.contribution(graph.nodes[a].at, graph.nodes[b].at) - from_root[b];
      if (round == 0) continue;
      const double cost = tree.cost[a] + tree.cost[b] + cost_of(graph, a, graph.ways[w]);
      Seam& seam = best[std::min(round, 0 - round)];  // either way round
      if (seam.a == no_node || std::tie(cost, a, b) < std::tie(seam.cost, seam.a, seam.b)) seam = {cost, a, b};
    }
  }
  std::vector<Seam> seams;
  for (const auto& [round, seam] : best) seams.push_back(seam);
  std::sort(seams.begin(), seams.end(),
            [](const Seam& u, const Seam& v) { return std::tie(u.cost, u.a, u.b) < std::tie(v.cost, v.a, v.b); });
  return seams;
}

Handle handle_at(const PathTree& tree, const Seam& seam) {
  Handle handle{no_node, path_to(tree, seam.a), path_to(tree, seam.b)};
  std::size_t same = 0;
  while (same < handle.one.size() && same < handle.other.size() && handle.one[same] == handle.other[same]) ++same;
  handle.fork = handle.one[same - 1];
  handle.one.erase(handle.one.begin(), handle.one.begin() + static_cast<std::ptrdiff_t>(same));
  handle.other.erase(handle.other.begin(), handle.other.begin() + static_cast<std::ptrdiff_t>(same));
  return handle;
}

/// Rows of numbers modulo a prime, none of which the others make up.
class Independent {
 public:
  /// Keeps the row if it is new.
  bool add(const std::vector<std::int64_t>& numbers) {
    std::vector<std::int64_t> row;
    for (const std::int64_t n : numbers) row.push_back(((n % prime) + prime) % prime);
    for (const auto& [lead, known] : rows_) {
      const std::int64_t times = row[lead];
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = (row[i] + (prime - times) * known[i]) % prime;
    }
    const auto lead = std::find_if(row.begin(), row.end(), [](std::int64_t n) { return n != 0; });
    if (lead == row.end()) return false;
    const std::int64_t by = inverse(*lead);
    const auto place = static_cast<std::size_t>(lead - row.begin());
    for (std::int64_t& n : row) n = n * by % prime;
    rows_.emplace_back(place, std::move(row));
    return true;
  }

 private:
  static constexpr std::int64_t prime = 2147483647;
  static std::int64_t inverse(std::int64_t n) {  // Fermat
    std::int64_t result = 1;
    for (std::int64_t e = prime - 2; e > 0; e /= 2) {
      if (e % 2 == 1) result = result * n % prime;
      n = n * n % prime;
    }
    return result;
  }
  std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> rows_;
};

}  // namespace

std::vector<NodeIndex> Handle::loop() const {
  std::vector<NodeIndex> closed{fork};
  closed.insert(closed.end(), one.begin(), one.end());
  closed.insert(closed.end(), other.rbegin(), other.rend());
  closed.push_back(fork);
  return closed;
}

std::vector<Handle> handles_of(const MedialGraph& graph, const PathTree& tree, const Linking& linking, double radius) {
  std::vector<Handle> handles;
  if (linking.loops() == 0) return handles;
  Independent known;
  std::size_t found = 0;
  for (const Seam& seam : seams_of(graph, tree, linking)) {
    if (2 * found == linking.loops()) break;  // as many as the genus
    Handle handle = handle_at(tree, seam);
    const std::vector<NodeIndex> loop = handle.loop();
    std::vector<Point3> way = places(graph, loop);
    way.pop_back();
    if (!known.add(linking.linked(way))) continue;
    ++found;
    if (std::all_of(loop.begin(), loop.end(), [&](NodeIndex n) { return graph.nodes[n].radius >= radius; }))
      handles.push_back(std::move(handle));
  }
  return handles;
}

}  // namespace odontoscope::cavity
