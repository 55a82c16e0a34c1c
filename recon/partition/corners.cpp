#include "recon/partition/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/delaunay/predicates.h"
#include "recon/partition/limits.h"

namespace odontoscope::partition {
namespace {

/// A border seen from one end.
struct Ray {
  std::uint32_t piece = 0, to = 0;
  Label left = void_label, right = void_label;   // looking away from the end
};

class CornerCutter {
 public:
  CornerCutter(Borders& borders, const Materials& materials) : borders_(borders), materials_(materials) {}

  std::size_t run() {
    std::vector<std::uint32_t> degree(borders_.points.size(), 0);
    for (const Border& piece : borders_.pieces) {
      ++degree[piece.a];
      ++degree[piece.b];
    }
    std::size_t cuts = 0;
    const auto points = static_cast<std::uint32_t>(borders_.points.size());
    for (std::uint32_t p = 0; p < points; ++p)
      for (std::uint32_t left = degree[p]; left > 3; left = static_cast<std::uint32_t>(rays_at(p).size())) {
        cut(p, rays_at(p));
        ++cuts;
      }
    return cuts;
  }

 private:
  std::vector<Ray> rays_at(std::uint32_t p) const {
    std::vector<Ray> rays;
    for (std::uint32_t i = 0; i < borders_.pieces.size(); ++i) {
      const Border& piece = borders_.pieces[i];
      if (piece.a == p) rays.push_back({i, piece.b, piece.left, piece.right});
      if (piece.b == p) rays.push_back({i, piece.a, piece.right, piece.left});
    }
    const Point2 at = borders_.points[p];
    const auto half = [&](const Ray& ray) {
      const Point2 to = borders_.points[ray.to];
      return to.y > at.y || (to.y == at.y && to.x > at.x) ? 0 : 1;
    };
    std::sort(rays.begin(), rays.end(), [&](const Ray& a, const Ray& b) {
      if (half(a) != half(b)) return half(a) < half(b);
      return delaunay::turn(at, borders_.points[a.to], at, borders_.points[b.to]) > 0;
    });
    return rays;
  }

  double angle(std::uint32_t p, const Ray& from, const Ray& to) const {
    const Point2 at = borders_.points[p], a = borders_.points[from.to], b = borders_.points[to.to];
    const double turned = std::atan2(b.y - at.y, b.x - at.x) - std::atan2(a.y - at.y, a.x - at.x);
    return turned < 0 ? turned + 2 * std::numbers::pi : turned;
  }

  /// The face between ray i and the next one loses its corner to the neighbour that wins.
  void cut(std::uint32_t p, const std::vector<Ray>& rays) {
    const std::size_t count = rays.size();
    const auto repeated = [&](Label label) {
      return std::count_if(rays.begin(), rays.end(), [label](const Ray& ray) { return ray.left == label; }) > 1;
    };
    const auto class_of = [&](Label label) { return !repeated(label) ? 2 : label == void_label ? 1 : 0; };
    std::size_t chosen = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) {
      const Label label = rays[i].left;
      const double turned = angle(p, rays[i], rays[(i + 1) % count]);
      if (turned >= std::numbers::pi) continue;
      const double cost = 100.0 * class_of(label) + turned;
      if (cost < least) {
        least = cost;
        chosen = i;
      }
    }
    const Ray first = rays[chosen], second = rays[(chosen + 1) % count];
    const Label one = first.right, other = second.left;
    const bool parted = class_of(first.left) == 0;   // the corner of a material that meets itself: rather to void
    const bool takes_one = parted ? one == void_label || (other != void_label && materials_.wins(one, other)) : materials_.wins(one, other);
    cut_off(p, first, second, takes_one ? one : other);
  }

  void cut_off(std::uint32_t p, const Ray& first, const Ray& second, Label taker) {
    const double reach = limits::corner_share * room(p);
    const std::uint32_t a = point_on(p, first.to, reach), b = point_on(p, second.to, reach);
    const Label loser = first.left;
    replace(first.piece, p, a, first.to, taker, first.right, first.left);
    replace(second.piece, p, b, second.to, second.left, taker, second.left, second.right);
    borders_.pieces.push_back({a, b, taker, loser});
    std::erase_if(borders_.pieces, [](const Border& piece) { return piece.left == piece.right; });
  }

  /// The piece from p to `to` becomes p-middle with these sides and middle-to with its own.
  void replace(std::uint32_t piece, std::uint32_t p, std::uint32_t middle, std::uint32_t to, Label left, Label right, Label far_left) {
    replace(piece, p, middle, to, left, right, far_left, right);
  }
  void replace(std::uint32_t piece, std::uint32_t p, std::uint32_t middle, std::uint32_t to, Label left, Label right, Label far_left, Label far_right) {
    borders_.pieces[piece] = {middle, to, far_left, far_right};
    borders_.pieces.push_back({p, middle, left, right});
  }

  std::uint32_t point_on(std::uint32_t p, std::uint32_t to, double reach) {
    const Point2 from = borders_.points[p], end = borders_.points[to];
    const double share = reach / std::hypot(end.x - from.x, end.y - from.y);
    borders_.points.push_back({from.x + share * (end.x - from.x), from.y + share * (end.y - from.y)});
    return static_cast<std::uint32_t>(borders_.points.size() - 1);
  }

  /// The distance to the nearest border that does not end at p, and to the nearest other end of those that do.
  double room(std::uint32_t p) const {
    double least = std::numeric_limits<double>::max();
    const Point2 at = borders_.points[p];
    const auto distance = [&](Point2 q) { return std::hypot(q.x - at.x, q.y - at.y); };
    for (const Border& piece : borders_.pieces) {
      const Point2 a = borders_.points[piece.a], b = borders_.points[piece.b];
      if (piece.a != p) least = std::min(least, distance(a));
      if (piece.b != p) least = std::min(least, distance(b));
      if (piece.a == p || piece.b == p) continue;
      const double x = b.x - a.x, y = b.y - a.y;
      const double t = std::clamp(((at.x - a.x) * x + (at.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
      least = std::min(least, distance({a.x + t * x, a.y + t * y}));
    }
    return least;
  }

  Borders& borders_;
  const Materials& materials_;
};

}  // namespace

std::size_t part_corners(Borders& borders, const Materials& materials) { return CornerCutter(borders, materials).run(); }

}  // namespace odontoscope::partition
