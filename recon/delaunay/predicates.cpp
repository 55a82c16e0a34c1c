#include "recon/delaunay/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace odontoscope::delaunay {
namespace {

using Exact = CGAL::Mpzf;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A rounded operation is off by at most half of this, relatively. The factors in front of it below count the roundings
// on the longest path to a result, generously; each is a bound, not a fit.
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Products of tiny numbers can underflow without any relative error bound; sums below this are left to exact
// arithmetic.
constexpr double underflow_guard = 1e-280;

int sign_of(double x) { return (x > 0) - (x < 0); }
int sign_of(const Exact& x) { return static_cast<int>(x.sign()); }

// The sign that the perturbation gives to a tie between p and q.
int tie(Point2 p, Point2 q, Side sites) {
  const int larger = p.x != q.x ? sign_of(p.x - q.x) : sign_of(p.y - q.y);
  return sites == Side::upper ? larger : -larger;
}

struct ExactCentre {  // the circumcentre is (nx, ny) / d, d > 0
  Exact nx, ny, d;
};

ExactCentre exact_centre(const Planar& of, TriangleIndex triangle) {
  const auto& v = of.triangles[triangle].v;
  const Point2 a = of.points[v[0]], b = of.points[v[1]], c = of.points[v[2]];
  const Exact ax(a.x), ay(a.y);
  const Exact bx = Exact(b.x) - ax, by = Exact(b.y) - ay, cx = Exact(c.x) - ax, cy = Exact(c.y) - ay;
  const Exact bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  ExactCentre centre;
  centre.d = Exact(2.0) * (bx * cy - by * cx);
  centre.nx = ax * centre.d + (cy * bb - by * cc);
  centre.ny = ay * centre.d + (bx * cc - cx * bb);
  return centre;
}

}  // namespace

Circumcentre circumcentre(Point2 a, Point2 b, Point2 c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double d = 2 * (bx * cy - by * cx);
  const double nx = cy * bb - by * cc, ny = bx * cc - cx * bb;
  const double d_error = 8 * epsilon * 2 * (std::abs(bx * cy) + std::abs(by * cx)) + underflow_guard;
  const double nx_error = 12 * epsilon * (std::abs(cy) * bb + std::abs(by) * cc) + underflow_guard;
  const double ny_error = 12 * epsilon * (std::abs(bx) * cc + std::abs(cx) * bb) + underflow_guard;
  Circumcentre centre;
  const double safe = std::abs(d) - 2 * d_error;
  if (!(safe > 0)) {
    centre.at = a;
    centre.error = std::numeric_limits<double>::infinity();
    return centre;
  }
  const double x = nx / d, y = ny / d;
  centre.at = {a.x + x, a.y + y};
  const double in_x = (nx_error + std::abs(x) * d_error) / safe + 4 * epsilon * (std::abs(x) + std::abs(a.x));
  const double in_y = (ny_error + std::abs(y) * d_error) / safe + 4 * epsilon * (std::abs(y) + std::abs(a.y));
  centre.error = 1.01 * std::max(in_x, in_y);
  if (!std::isfinite(centre.error)) centre.error = std::numeric_limits<double>::infinity();
  return centre;
}

int nearer_to_centre(const Planar& of, TriangleIndex triangle, Point2 p, Point2 q, Side sites) {
  // |c-p|^2 - |c-q|^2 = (q-p).(2c-p-q)
  const Circumcentre& centre = of.centres[triangle];
  const double dx = q.x - p.x, dy = q.y - p.y;
  const double sx = 2 * centre.at.x - p.x - q.x, sy = 2 * centre.at.y - p.y - q.y;
  const double value = dx * sx + dy * sy;
  const double ex = 2 * centre.error + 4 * epsilon * (2 * std::abs(centre.at.x) + std::abs(p.x) + std::abs(q.x));
  const double ey = 2 * centre.error + 4 * epsilon * (2 * std::abs(centre.at.y) + std::abs(p.y) + std::abs(q.y));
  const double bound = 1.01 * (std::abs(dx) * ex + std::abs(dy) * ey) +
                       4 * epsilon * (std::abs(dx * sx) + std::abs(dy * sy)) + underflow_guard;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  const ExactCentre c = exact_centre(of, triangle);
  const Exact two(2.0), px(p.x), py(p.y), qx(q.x), qy(q.y);
  const Exact exact = (qx - px) * (two * c.nx - (px + qx) * c.d) + (qy - py) * (two * c.ny - (py + qy) * c.d);
  const int sign = sign_of(exact);
  return sign != 0 ? sign : tie(p, q, sites);
}

int nearer_to_midpoint(Point2 a, Point2 b, Point2 p, Point2 q, Side sites) {
  const double dx = q.x - p.x, dy = q.y - p.y;
  const double sx = (a.x - p.x) + (b.x - q.x), sy = (a.y - p.y) + (b.y - q.y);
  const double value = dx * sx + dy * sy;
  const double ex = std::abs(a.x - p.x) + std::abs(b.x - q.x), ey = std::abs(a.y - p.y) + std::abs(b.y - q.y);
  const double bound = 8 * epsilon * (std::abs(dx) * ex + std::abs(dy) * ey) + underflow_guard;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  const Exact px(p.x), py(p.y), qx(q.x), qy(q.y);
  const Exact exact = (qx - px) * (Exact(a.x) + Exact(b.x) - px - qx) + (qy - py) * (Exact(a.y) + Exact(b.y) - py - qy);
  const int sign = sign_of(exact);
  return sign != 0 ? sign : tie(p, q, sites);
}

int centre_left_of(const Planar& of, TriangleIndex triangle, Point2 p, Point2 q, Side wedge) {
  const Circumcentre& centre = of.centres[triangle];
  const double dx = q.x - p.x, dy = q.y - p.y;
  const double rx = centre.at.x - p.x, ry = centre.at.y - p.y;
  const double value = dx * ry - dy * rx;
  const double ex = centre.error + 2 * epsilon * std::abs(rx), ey = centre.error + 2 * epsilon * std::abs(ry);
  const double bound = 1.01 * (std::abs(dx) * ey + std::abs(dy) * ex) +
                       6 * epsilon * (std::abs(dx * ry) + std::abs(dy * rx)) + underflow_guard;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  const ExactCentre c = exact_centre(of, triangle);
  const Exact px(p.x), py(p.y);
  const Exact exact = (Exact(q.x) - px) * (c.ny - py * c.d) - (Exact(q.y) - py) * (c.nx - px * c.d);
  const int sign = sign_of(exact);
  if (sign != 0) return sign;
  // The centre moves by (e, e^2) relative to the line if it is the upper one, against it otherwise:
  // (q-p) x (e, e^2) = dx e^2 - dy e.
  const int moved = dy != 0 ? -sign_of(dy) : sign_of(dx);
  return wedge == Side::lower ? moved : -moved;
}

int turn(Point2 a, Point2 b, Point2 c, Point2 d) {
  const double x1 = b.x - a.x, y1 = b.y - a.y, x2 = d.x - c.x, y2 = d.y - c.y;
  const double value = x1 * y2 - y1 * x2;
  const double bound = 6 * epsilon * (std::abs(x1 * y2) + std::abs(y1 * x2)) + underflow_guard;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return sign_of((Exact(b.x) - Exact(a.x)) * (Exact(d.y) - Exact(c.y)) -
                 (Exact(b.y) - Exact(a.y)) * (Exact(d.x) - Exact(c.x)));
}

int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto point = [](const Point3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

}  // namespace odontoscope::delaunay
