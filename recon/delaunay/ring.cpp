#include "recon/delaunay/ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/portable_math.h"

namespace odontoscope::delaunay {
namespace {

/// Twice the signed area of the triangle.
double twice_triangle(Point2 a, Point2 b, Point2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  return (twice_triangle(a, b, c) > 0) != (twice_triangle(a, b, d) > 0) &&
         (twice_triangle(c, d, a) > 0) != (twice_triangle(c, d, b) > 0);
}

double distance_to_segment(Point2 p, Point2 a, Point2 b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0) : 0;
  return portable::hypot(a.x + t * x - p.x, a.y + t * y - p.y);
}

}  // namespace

double signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice += twice_triangle(ring.front(), ring[i], ring[i + 1]);  // far from the origin nothing is lost
  return twice / 2;
}

Point2 centroid(const Ring& ring) {
  const Point2 o = ring.front();
  double weight = 0, x = 0, y = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const double area = twice_triangle(o, ring[i], ring[i + 1]);
    weight += area;
    x += area * (ring[i].x - o.x + ring[i + 1].x - o.x) / 3;
    y += area * (ring[i].y - o.y + ring[i + 1].y - o.y) / 3;
  }
  return weight == 0 ? o : Point2{o.x + x / weight, o.y + y / weight};
}

bool encloses(const Ring& ring, Point2 p) {
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
  }
  return in;
}

double gap_between(const Ring& a, const Ring& b) {
  if (encloses(a, b.front()) || encloses(b, a.front())) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Point2 a1 = a[i], a2 = a[(i + 1) % a.size()], b1 = b[j], b2 = b[(j + 1) % b.size()];
      if (cross(a1, a2, b1, b2)) return 0;
      least = std::min({least, distance_to_segment(a1, b1, b2), distance_to_segment(b1, a1, a2)});
    }
  return least;
}

}  // namespace odontoscope::delaunay
