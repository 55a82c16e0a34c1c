#include "recon/cavity/canal_graph.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "recon/cavity/limits.h"

namespace odontoscope {
namespace {

struct Place {
  std::size_t canal = 0, point = 0;
};

/// Points [first, last] of a canal, beside what is known already or by themselves.
struct Run {
  std::size_t first = 0, last = 0;
  bool together = false;
};

class Weaver {
 public:
  explicit Weaver(const CentreLines& lines) : lines_(lines) {
    if (lines.canals.empty()) return;
    graph_.nodes.push_back(lines.has_chamber ? lines.chamber : lines.canals.front().start);
    for (std::size_t canal = 0; canal < lines.canals.size(); ++canal) weave(canal);
  }

  CanalGraph take() { return std::move(graph_); }

 private:
  const CentrePoint& point(std::size_t canal, std::size_t i) const { return lines_.canals[canal].points[i]; }
  const CentrePoint& point(const Place& place) const { return point(place.canal, place.point); }
  bool close(const CentrePoint& a, const CentrePoint& b) const {
    return length(a.at - b.at) < limits::together * std::min(a.radius, b.radius);
  }

  /// The nearest of all parts' points.
  std::optional<Place> beside(const CentrePoint& p) const {
    std::optional<Place> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (const CanalPart& part : graph_.parts) {
      for (std::size_t i = part.first; i <= part.last; ++i) {
        const double far = length(point(part.canals.front(), i).at - p.at);
        if (far >= nearest) continue;
        nearest = far;
        best = Place{part.canals.front(), i};
      }
    }
    return best && close(point(*best), p) ? best : std::nullopt;
  }

  bool short_run(std::size_t canal, const Run& run) const {
    const CentrePoint &a = point(canal, run.first), &b = point(canal, run.last);
    return b.along - a.along < a.radius + b.radius;
  }

  std::vector<Run> runs(std::size_t canal, const std::vector<std::optional<Place>>& known) const {
    std::vector<Run> found;
    const auto add = [&](const Run& run) {
      if (!found.empty() && found.back().together == run.together)
        found.back().last = run.last;
      else
        found.push_back(run);
    };
    const std::size_t orifice = lines_.canals[canal].orifice, last = lines_.canals[canal].points.size() - 1;
    for (std::size_t i = orifice; i <= last; ++i) add({i, i, known[i].has_value()});
    const std::vector<Run> all = std::move(found);
    found.clear();
    for (std::size_t r = 0; r < all.size(); ++r) {
      const bool at_end = r + 1 == all.size();
      Run run = all[r];
      if (all.size() > 1 && short_run(canal, run) && !(run.together && at_end)) run.together = !run.together;
      add(run);
    }
    return found;
  }

  void weave(std::size_t canal) {
    const CentreLine& line = lines_.canals[canal];
    std::vector<std::optional<Place>> known(line.points.size());
    for (std::size_t i = line.orifice; i < line.points.size(); ++i) known[i] = beside(line.points[i]);
    const std::vector<Run> all = runs(canal, known);
    std::size_t node = 0;
    for (std::size_t r = 0; r < all.size(); ++r) {
      const bool at_end = r + 1 == all.size();
      const Run& run = all[r];
      if (run.together) {
        const std::size_t next = at_end ? end_beside(canal, known, run) : node_at(known, run.last, run.first);
        share(canal, run);
        node = next;
        continue;
      }
      const std::size_t to = at_end ? new_node(line.end) : node_at(known, all[r + 1].first, all[r + 1].last);
      if (to != node) graph_.parts.push_back({node, to, {canal}, run.first, run.last});
      node = to;
    }
  }

  std::size_t new_node(const Point3& at) {
    graph_.nodes.push_back(at);
    return graph_.nodes.size() - 1;
  }

  /// Where the canal's point `i`, or the first one from there towards `other` that has a place, lies beside others.
  std::size_t node_at(const std::vector<std::optional<Place>>& known, std::size_t i, std::size_t other) {
    while (!known[i] && i != other) i = i < other ? i + 1 : i - 1;
    return known[i] ? split(*known[i]) : 0;
  }

  std::size_t end_beside(std::size_t canal, const std::vector<std::optional<Place>>& known, const Run& run) {
    const std::size_t node = node_at(known, run.last, run.first);
    return graph_.leading_from(node) == 0 ? node : new_node(lines_.canals[canal].end);
  }

  /// The node there: an end of the part if it is no more than a width away, else a new one.
  std::size_t split(const Place& place) {
    const auto found = std::find_if(graph_.parts.begin(), graph_.parts.end(), [&](const CanalPart& part) {
      return part.canals.front() == place.canal && part.first <= place.point && place.point <= part.last;
    });
    const CentrePoint& p = point(place);
    const auto width_from = [&](std::size_t i) { return length(point(place.canal, i).at - p.at) < 2 * p.radius; };
    if (width_from(found->first)) return found->from;
    if (width_from(found->last)) return found->to;
    CanalPart below = *found;
    const std::size_t node = new_node(p.at);
    below.from = found->to = node;
    below.first = found->last = place.point;
    graph_.parts.insert(found + 1, below);
    return node;
  }

  /// The parts whose middle this stretch passes are the canal's, too.
  void share(std::size_t canal, const Run& run) {
    for (CanalPart& part : graph_.parts) {
      if (part.canals.back() == canal) continue;
      const CentrePoint& middle = point(part.canals.front(), (part.first + part.last) / 2);
      for (std::size_t i = run.first; i <= run.last && part.canals.back() != canal; ++i)
        if (close(point(canal, i), middle)) part.canals.push_back(canal);
    }
  }

  const CentreLines& lines_;
  CanalGraph graph_;
};

}  // namespace

std::size_t CanalGraph::leading_to(std::size_t node) const {
  return static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(), [&](const CanalPart& part) { return part.to == node; }));
}

std::size_t CanalGraph::leading_from(std::size_t node) const {
  return static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(), [&](const CanalPart& part) { return part.from == node; }));
}

const char* CanalGraph::kind(std::size_t node) const {
  if (node == 0) return "chamber";
  const std::size_t to = leading_to(node), from = leading_from(node);
  return from == 0 ? "end" : to > 1 ? (from > 1 ? "crossing" : "join") : "fork";
}

CanalGraph canal_graph(const CentreLines& lines) { return Weaver(lines).take(); }

}  // namespace odontoscope
