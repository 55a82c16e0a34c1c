#include "recon/exchange/unbridge.h"

#include <map>
#include <utility>

namespace odontoscope {
namespace {

using Ring = std::vector<Point2>;
using Ends = std::pair<std::pair<double, double>, std::pair<double, double>>;

Ends ends_of(const Ring& ring, std::size_t i) {
  const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
  return {{a.x, a.y}, {b.x, b.y}};
}

/// Two edges that are each other's way back, each with no other partner: the first of such.
std::vector<std::pair<std::size_t, std::size_t>> bridges_of(const Ring& ring) {
  std::map<Ends, std::size_t> known;
  std::vector<std::pair<std::size_t, std::size_t>> bridges;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Ends ends = ends_of(ring, i);
    if (const auto back = known.find({ends.second, ends.first}); back != known.end()) {
      bridges.emplace_back(back->second, i);
      known.erase(back);
    } else {
      known.emplace(ends, i);
    }
  }
  return bridges;
}

}  // namespace

std::vector<Ring> without_bridges(const Ring& points) {
  const std::vector<std::pair<std::size_t, std::size_t>> bridges = bridges_of(points);
  if (bridges.empty()) return {points};
  // After edge i (to point i + 1) the line goes on where its partner j ends: there and back is left out.
  const std::size_t n = points.size();
  std::vector<std::size_t> next(n);
  std::vector<bool> gone(n, false);  // by the edge that begins at the point
  for (std::size_t i = 0; i < n; ++i) next[i] = (i + 1) % n;
  for (const auto& [i, j] : bridges) gone[i] = gone[j] = true;
  std::map<std::size_t, std::size_t> partner;
  for (const auto& [i, j] : bridges) {
    partner[i] = j;
    partner[j] = i;
  }
  std::vector<bool> done(n, false);
  std::vector<Ring> rings;
  for (std::size_t first = 0; first < n; ++first) {
    if (gone[first] || done[first]) continue;
    Ring ring;
    for (std::size_t at = first; !done[at];) {
      done[at] = true;
      ring.push_back(points[at]);
      at = next[at];
      while (gone[at]) at = next[partner[at]];
    }
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace odontoscope
