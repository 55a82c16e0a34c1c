#include "tests/cavity/section_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace odontoscope::test {
namespace {

struct Vector {
  double x, y, z;
};
Vector minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double scalar(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector vector_product(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double to_edge(const Point3& p, const Point3& a, const Point3& b) {
  const Vector ab = minus(b, a), ap = minus(p, a);
  const double square = scalar(ab, ab), t = square > 0 ? std::clamp(scalar(ap, ab) / square, 0.0, 1.0) : 0;
  return std::hypot(ap.x - t * ab.x, ap.y - t * ab.y, ap.z - t * ab.z);
}

/// The plane's distance where the foot lies within all three edges, else that of the nearest edge.
double to_triangle(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
  const Vector n = vector_product(minus(b, a), minus(c, a));
  const double size = std::sqrt(scalar(n, n));
  const auto inner = [&](const Point3& u, const Point3& v) {
    return scalar(vector_product(minus(v, u), minus(p, u)), n) >= 0;
  };
  if (size > 0 && inner(a, b) && inner(b, c) && inner(c, a)) return std::abs(scalar(minus(p, a), n)) / size;
  return std::min({to_edge(p, a, b), to_edge(p, b, c), to_edge(p, c, a)});
}

}  // namespace

double brute_distance(const SurfaceMesh& wall, const Point3& from) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : wall.triangles)
    nearest = std::min(nearest, to_triangle(from, wall.points[t[0]], wall.points[t[1]], wall.points[t[2]]));
  return nearest;
}

double widest_in_section(const SurfaceMesh& wall, const Point3& from, const Point3& along, double step, double reach) {
  // Only triangles that can matter: none farther away than the search goes and its result can be.
  SurfaceMesh near;
  near.points = wall.points;
  for (const Triangle& t : wall.triangles) {
    double low = std::numeric_limits<double>::infinity(), longest = 0;
    for (int k = 0; k < 3; ++k) {
      const Vector d = minus(wall.points[t[static_cast<std::size_t>(k)]], from),
                   e = minus(wall.points[t[static_cast<std::size_t>((k + 1) % 3)]],
                             wall.points[t[static_cast<std::size_t>(k)]]);
      low = std::min(low, std::sqrt(scalar(d, d)));
      longest = std::max(longest, std::sqrt(scalar(e, e)));
    }
    if (low <= 2 * reach + longest) near.triangles.push_back(t);
  }
  const double size = std::sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
  const Vector n{along.x / size, along.y / size, along.z / size};
  const Vector some = std::abs(n.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  Vector u = vector_product(n, some);
  const double length = std::sqrt(scalar(u, u));
  u = {u.x / length, u.y / length, u.z / length};
  const Vector v = vector_product(n, u);
  std::map<std::pair<int, int>, double> known;
  std::vector<std::pair<int, int>> waiting;
  double widest = 0;
  const auto enter = [&](int i, int j) {
    if (known.contains({i, j}) || std::hypot(i * step, j * step) > reach) return;
    const double a = i * step, b = j * step;
    const double clear =
        brute_distance(near, {from.x + a * u.x + b * v.x, from.y + a * u.y + b * v.y, from.z + a * u.z + b * v.z});
    known[{i, j}] = clear;
    if (clear < step) return;  // a wall may lie between this place and the next
    widest = std::max(widest, clear);
    waiting.emplace_back(i, j);
  };
  enter(0, 0);
  while (!waiting.empty()) {
    const auto [i, j] = waiting.back();
    waiting.pop_back();
    enter(i + 1, j);
    enter(i - 1, j);
    enter(i, j + 1);
    enter(i, j - 1);
  }
  return widest;
}

}  // namespace odontoscope::test
