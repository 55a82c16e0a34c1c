#include "recon/delaunay/block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/delaunay/limits.h"
#include "recon/delaunay/predicates.h"
#include "recon/delaunay/prism.h"

namespace odontoscope::delaunay {
namespace {

struct Levels {
  double low = 0, middle = 0, high = 0;
};

/// Where the block begins, has its inner point, and ends; empty if there are no such doubles.
std::optional<Levels> levels_between(SlabHeights heights) {
  const auto valid = [&heights](Levels l) {
    return heights.lower < l.low && l.low < l.middle && l.middle < l.high && l.high < heights.upper;
  };
  const auto from = [](double low, double high) { return Levels{low, low + (high - low) / 2, high}; };
  const double step = (heights.upper - heights.lower) * limits::block_height;
  if (const Levels l = from(heights.lower + step, heights.upper - step); valid(l)) return l;
  constexpr double far = std::numeric_limits<double>::infinity();
  double low = std::nextafter(heights.lower, far), high = std::nextafter(heights.upper, -far);
  const Levels nearest = from(low, high);
  low = std::nextafter(low, far);  // leaves a double for plates
  high = std::nextafter(high, -far);
  if (const Levels l = from(low, high); valid(l)) return l;
  if (valid(nearest)) return nearest;
  return std::nullopt;
}

bool points_down(Point2 from, Point2 to) { return to.y < from.y || (to.y == from.y && to.x < from.x); }

/// The hull's points counter-clockwise, from the lowest of them on, the leftmost of the lowest.
std::vector<SlicePoint> hull_of(const Planar& planar) {
  Table<SlicePoint, SlicePoint> next(planar.points.size(), none);
  SlicePoint start;
  for (const PlanarTriangle& triangle : planar.triangles)
    for (int k = 0; k < 3; ++k) {
      if (triangle.nb[k] != none) continue;
      const SlicePoint a = triangle.v[(k + 1) % 3];
      next[a] = triangle.v[(k + 2) % 3];
      if (start == none || points_down(planar.points[start], planar.points[a])) start = a;
    }
  std::vector<SlicePoint> hull{start};
  for (SlicePoint p = next[start]; p != start; p = next[p]) hull.push_back(p);
  return hull;
}

/// Does the edge from a to b come before that from c to d, going round from the direction of x?
bool turns_earlier(Point2 a, Point2 b, Point2 c, Point2 d) {
  const bool first = points_down(a, b), second = points_down(c, d);
  return first != second ? second : turn(a, b, c, d) >= 0;
}

/// The faces of the hull of two convex polygons in parallel planes that lie in neither, counter-clockwise from outside;
/// points of the upper one are counted on from those of the lower.
std::vector<std::array<SlabPoint, 3>> faces_around(const Planar& lower, const Planar& upper) {
  const std::vector<SlicePoint> below = hull_of(lower), above = hull_of(upper);
  const SlabNumbers numbers(lower);
  std::vector<std::array<SlabPoint, 3>> faces;
  std::size_t i = 0, j = 0;
  while (i < below.size() || j < above.size()) {
    const SlicePoint a = below[i % below.size()], b = below[(i + 1) % below.size()];
    const SlicePoint c = above[j % above.size()], d = above[(j + 1) % above.size()];
    const bool along_lower = j == above.size() || (i < below.size() && turns_earlier(lower.points[a], lower.points[b],
                                                                                     upper.points[c], upper.points[d]));
    if (along_lower) {
      faces.push_back({numbers.of_lower(a), numbers.of_lower(b), numbers.of_upper(c)});
      ++i;
    } else {
      faces.push_back({numbers.of_lower(a), numbers.of_upper(d), numbers.of_upper(c)});
      ++j;
    }
  }
  return faces;
}

class Block {
 public:
  Block(const Planar& lower, const Planar& upper, const Levels& levels)
      : faces_(faces_around(lower, upper)), middle_(levels.middle) {
    for (const Point2 p : lower.points) points_.push_back({p.x, p.y, levels.low});
    for (const Point2 p : upper.points) points_.push_back({p.x, p.y, levels.high});
  }

  const std::vector<std::array<SlabPoint, 3>>& faces() const { return faces_; }
  const Table<SlabPoint, Point3>& points() const { return points_; }

  /// A point on the inner side of every face: the mean of the corners, or nearer to one of them.
  std::optional<Point3> inner_point() const {
    Point3 mean{0, 0, middle_};
    const double share = 1 / (3.0 * static_cast<double>(faces_.size()));
    for (const auto& face : faces_)
      for (const SlabPoint v : face) mean = {mean.x + points_[v].x * share, mean.y + points_[v].y * share, middle_};
    if (is_inner(mean)) return mean;
    for (double step = 0.5; step > limits::block_steps; step /= 2)
      for (const auto& face : faces_) {
        const Point3& corner = points_[face[0]];
        const Point3 p{mean.x + step * (corner.x - mean.x), mean.y + step * (corner.y - mean.y), middle_};
        if (is_inner(p)) return p;
      }
    return std::nullopt;
  }

 private:
  bool is_inner(const Point3& p) const {
    return std::all_of(faces_.begin(), faces_.end(),
                       [&](const auto& f) { return orientation(points_[f[0]], points_[f[2]], points_[f[1]], p) > 0; });
  }

  std::vector<std::array<SlabPoint, 3>> faces_;
  Table<SlabPoint, Point3> points_;
  double middle_;
};

}  // namespace

Blocked block(const Planar& lower, const Planar& upper, SlabHeights heights, std::uint32_t whole_lower,
              std::uint32_t whole_upper, SlabSolid& solid) {
  const std::optional<Levels> levels = levels_between(heights);
  if (!levels) return Blocked::no_height;
  const Block hull(lower, upper, *levels);
  const std::optional<Point3> inner = hull.inner_point();
  if (!inner) return Blocked::no_place;

  const auto first = static_cast<std::uint32_t>(whole_lower + whole_upper + solid.added.size());
  const auto in_lower = static_cast<std::uint32_t>(lower.points.size());
  const auto apex = static_cast<std::uint32_t>(first + hull.points().size());
  solid.added.insert(solid.added.end(), hull.points().begin(), hull.points().end());
  solid.added.push_back(*inner);
  const auto fan = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    solid.tetrahedra.push_back({first + a, first + b, first + c, apex});
  };
  for (const auto& face : hull.faces()) fan(face[0], face[2], face[1]);
  for (const PlanarTriangle& t : lower.triangles) {
    fan(t.v[0], t.v[1], t.v[2]);
    if (t.region == none) continue;
    add_prism(
        t, [&](SlicePoint p) { return lower.slice_point[p]; }, [&](SlicePoint p) { return first + p; },
        Thickened::upwards, solid.tetrahedra);
  }
  for (const PlanarTriangle& t : upper.triangles) {
    fan(in_lower + t.v[0], in_lower + t.v[2], in_lower + t.v[1]);
    if (t.region == none) continue;
    add_prism(
        t, [&](SlicePoint p) { return whole_lower + upper.slice_point[p]; },
        [&](SlicePoint p) { return first + in_lower + p; }, Thickened::downwards, solid.tetrahedra);
  }
  solid.raised = true;
  return Blocked::yes;
}

}  // namespace odontoscope::delaunay
