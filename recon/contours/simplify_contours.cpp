#include "recon/contours/simplify_contours.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <queue>
#include <set>
#include <utility>
#include <vector>

#include "recon/contours/point_tree.h"
#include "recon/core/error.h"
#include "recon/core/polygon.h"

namespace odontoscope {
namespace {

using VertexId = std::uint32_t;
constexpr VertexId none = std::numeric_limits<VertexId>::max();

double squared_distance(Point2 p, Point2 a, Point2 b) {
  const double along = nearest_share(p, a, b);
  const double ex = p.x - (a.x + along * (b.x - a.x)), ey = p.y - (a.y + along * (b.y - a.y));
  return ex * ex + ey * ey;
}

bool before(Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// The union of a slice's contours as a graph: every distinct point and every distinct edge once.
class SliceGraph {
 public:
  SliceGraph(const Slice& slice, double tolerance) : limit_(tolerance * tolerance) {
    number_points(slice);
    join_points();
  }

  void simplify() {
    if (points_.empty()) return;
    PointTree tree(points_);
    for (VertexId v = 0; v < points_.size(); ++v) offer(v);
    // Points that stood in another's way may have gone since: try again until nothing moves.
    while (remove_cheapest(tree)) {
      for (const VertexId v : std::exchange(blocked_, {})) offer(v);
    }
  }

  /// What is left of the slice's contour `c`.
  std::vector<Point2> contour(std::size_t c) const {
    std::vector<Point2> left;
    for (const VertexId v : contours_[c]) {
      if (!vertices_[v].removed) left.push_back(points_[v]);
    }
    return left;
  }

  double largest_squared_deviation() const { return largest_; }

 private:
  struct Vertex {
    std::array<VertexId, 2> original{none, none};  // neighbours along the contour before and
    std::array<VertexId, 2> now{none, none};       // after what was removed so far; only of points with two
    std::uint32_t version = 0;
    bool junction = false;  // edges to more than two points meet here: contours part, so it stays
    bool removed = false;
  };
  struct Offer {
    double cost;
    VertexId vertex;
    std::uint32_t version;
    bool operator<(const Offer& other) const {  // the cheapest comes out of the queue first
      return cost != other.cost ? cost > other.cost : vertex > other.vertex;
    }
  };

  /// Numbers follow from the places alone, and so does every later choice between equals.
  void number_points(const Slice& slice) {
    for (const Contour& contour : slice.contours)
      points_.insert(points_.end(), contour.points.begin(), contour.points.end());
    std::sort(points_.begin(), points_.end(), before);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    vertices_.resize(points_.size());
    for (const Contour& contour : slice.contours) {
      std::vector<VertexId>& ids = contours_.emplace_back();
      for (const Point2 p : contour.points) {
        ids.push_back(
            static_cast<VertexId>(std::lower_bound(points_.begin(), points_.end(), p, before) - points_.begin()));
      }
    }
  }

  void join_points() {
    for (const std::vector<VertexId>& ids : contours_) {
      for (std::size_t n = 0; n < ids.size(); ++n) {
        const VertexId a = ids[n], b = ids[(n + 1) % ids.size()];
        add_neighbour(a, b);
        add_neighbour(b, a);
      }
    }
    for (const std::vector<VertexId>& ids : contours_) {
      for (std::size_t n = 0; n < ids.size(); ++n) {
        const VertexId a = ids[n], b = ids[(n + 1) % ids.size()];
        if (vertices_[a].junction && vertices_[b].junction) junction_edges_.insert(std::minmax(a, b));
      }
    }
    for (Vertex& vertex : vertices_) vertex.now = vertex.original;
  }

  void add_neighbour(VertexId v, VertexId neighbour) {
    for (VertexId& known : vertices_[v].original) {
      if (known == neighbour) return;
      if (known == none) {
        known = neighbour;
        return;
      }
    }
    vertices_[v].junction = true;
  }

  bool joined(VertexId a, VertexId b) const {
    const auto knows = [this](VertexId v, VertexId w) { return vertices_[v].now[0] == w || vertices_[v].now[1] == w; };
    if (!vertices_[a].junction) return knows(a, b);
    if (!vertices_[b].junction) return knows(b, a);
    return junction_edges_.contains(std::minmax(a, b));
  }

  /// Largest squared distance from the points that the edge between v's neighbours would stand for, v among them.
  double cost(VertexId v) const {
    const auto [a, b] = vertices_[v].now;
    double largest = squared_distance(points_[v], points_[a], points_[b]);
    for (const VertexId first : vertices_[v].original) {
      VertexId from = v, at = first;
      while (vertices_[at].removed) {
        largest = std::max(largest, squared_distance(points_[at], points_[a], points_[b]));
        const auto [one, other] = vertices_[at].original;
        from = std::exchange(at, one == from ? other : one);
      }
    }
    return largest;
  }

  void offer(VertexId v) {
    Vertex& vertex = vertices_[v];
    if (vertex.junction || vertex.removed) return;
    ++vertex.version;
    const double c = cost(v);
    if (c <= limit_) queue_.push({c, v, vertex.version});
  }

  bool remove_cheapest(PointTree& tree) {
    bool any = false;
    while (!queue_.empty()) {
      const Offer offered = queue_.top();
      queue_.pop();
      const VertexId v = offered.vertex;
      if (vertices_[v].removed || vertices_[v].version != offered.version) continue;
      const auto [a, b] = vertices_[v].now;
      if (joined(a, b) || tree.any_in_triangle(a, v, b)) {
        blocked_.push_back(v);
        continue;
      }
      any = true;
      remove(v, offered.cost);
      tree.remove(v);
    }
    return any;
  }

  void remove(VertexId v, double cost) {
    const auto [a, b] = vertices_[v].now;
    vertices_[v].removed = true;
    largest_ = std::max(largest_, cost);
    if (vertices_[a].junction && vertices_[b].junction) junction_edges_.insert(std::minmax(a, b));
    replace_neighbour(a, v, b);
    replace_neighbour(b, v, a);
    offer(a);
    offer(b);
  }

  void replace_neighbour(VertexId at, VertexId old, VertexId by) {
    if (vertices_[at].junction) return;
    VertexId& slot = vertices_[at].now[0] == old ? vertices_[at].now[0] : vertices_[at].now[1];
    slot = by;
  }

  double limit_;
  double largest_ = 0;
  std::vector<Point2> points_;
  std::vector<Vertex> vertices_;
  std::vector<std::vector<VertexId>> contours_;
  std::set<std::pair<VertexId, VertexId>> junction_edges_;
  std::priority_queue<Offer> queue_;
  std::vector<VertexId> blocked_;
};

std::size_t count_points(const ContourStack& stack) {
  std::size_t count = 0;
  for (const Slice& slice : stack.slices) {
    for (const Contour& contour : slice.contours) count += contour.points.size();
  }
  return count;
}

}  // namespace

SimplifiedSlice simplify_slice(const Slice& slice, double tolerance) {
  SliceGraph graph(slice, tolerance);
  graph.simplify();
  SimplifiedSlice result{{slice.z, {}}, std::sqrt(graph.largest_squared_deviation())};
  for (std::size_t c = 0; c < slice.contours.size(); ++c) {
    result.slice.contours.push_back({slice.contours[c].structure, graph.contour(c)});
  }
  return result;
}

SimplifiedContours simplify_contours(const ContourStack& stack, const SimplifyContoursOptions& options,
                                     const Progress& progress) {
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    throw UsageError(fmt::format("the tolerance {} is not a finite number of at least 0", options.tolerance),
                     "give a distance in millimetres (--simplify E)");
  }
  std::vector<SimplifiedSlice> slices(stack.slices.size());
  std::mutex telling;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, slices.size(), [&](std::size_t s) {
    progress.check();
    slices[s] = simplify_slice(stack.slices[s], options.tolerance);
    const std::scoped_lock lock(telling);
    progress.tell("simplify", static_cast<double>(++done) / static_cast<double>(slices.size()));
  });
  SimplifiedContours result;
  result.stack.source = stack.source;
  result.points_before = count_points(stack);
  for (SimplifiedSlice& slice : slices) {
    result.largest_deviation = std::max(result.largest_deviation, slice.largest_deviation);
    result.stack.slices.push_back(std::move(slice.slice));
  }
  result.points_after = count_points(result.stack);
  return result;
}

}  // namespace odontoscope
