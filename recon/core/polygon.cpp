#include "recon/core/polygon.h"

#include <algorithm>
#include <limits>

#include "recon/core/portable_math.h"

namespace odontoscope {

double signed_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point2 &o = polygon.front(), &a = polygon[i], &b = polygon[i + 1];
    twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return twice / 2;
}

void AreaMoments::add(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const Point2 p{here.x - base_.x, here.y - base_.y}, q{next.x - base_.x, next.y - base_.y};
    const double cross = p.x * q.y - p.y * q.x;
    twice_ += cross;
    x_ += cross * (p.x + q.x);
    y_ += cross * (p.y + q.y);
    squares_ += cross * (p.x * p.x + p.x * q.x + q.x * q.x + p.y * p.y + p.y * q.y + q.y * q.y);
  }
}

Point2 AreaMoments::centroid() const { return {base_.x + x_ / (3 * twice_), base_.y + y_ / (3 * twice_)}; }

double AreaMoments::mean_square() const {
  const double x = x_ / (3 * twice_), y = y_ / (3 * twice_);
  return squares_ / (6 * twice_) - x * x - y * y;
}

Point2 centroid(const Polygon& polygon) {
  const AreaMoments moments(polygon);
  return moments.signed_area() == 0 ? polygon.front() : moments.centroid();
}

int winding(const Polygon& polygon, Point2 place) {
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double side = (b.x - a.x) * (place.y - a.y) - (place.x - a.x) * (b.y - a.y);
    if (a.y <= place.y && b.y > place.y && side > 0) ++turns;
    if (a.y > place.y && b.y <= place.y && side < 0) --turns;
  }
  return turns;
}

double nearest_share(const Point2& p, const Point2& a, const Point2& b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  return square > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0) : 0;
}

double distance_to_edge(const Point2& p, const Point2& a, const Point2& b) {
  const double t = nearest_share(p, a, b);
  return portable::hypot(p.x - a.x - t * (b.x - a.x), p.y - a.y - t * (b.y - a.y));
}

double distance_to_border(const Point2& p, const Polygon& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, distance_to_edge(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

}  // namespace odontoscope
