#include "recon/mesh/exact_predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <cmath>
#include <limits>

namespace odontoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 to_cgal(const Point3& p) { return {p.x, p.y, p.z}; }

/// Of a difference of two products of differences: its rounding errors add up to less than four units of
/// the products' magnitude, doubled here; the second term covers underflow.
constexpr double relative_error = 8 * std::numeric_limits<double>::epsilon() / 2;
constexpr double underflow = 8 * std::numeric_limits<double>::min();

bool surely_not_zero(double ux, double uy, double vx, double vy) {
  const double left = ux * vy, right = uy * vx;
  return std::abs(left - right) > relative_error * (std::abs(left) + std::abs(right)) + underflow;
}

}  // namespace

int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  // One coordinate of the cross product that is surely not zero is proof enough.
  if (surely_not_zero(ux, uy, vx, vy) || surely_not_zero(uy, uz, vy, vz) || surely_not_zero(uz, ux, vz, vx)) {
    return false;
  }
  return CGAL::collinear(to_cgal(a), to_cgal(b), to_cgal(c));
}

int volume_sign(const SurfaceMesh& mesh, const std::vector<std::size_t>& triangles) {
  using Number = CGAL::Exact_rational;
  Number six_volumes = 0;
  for (const std::size_t t : triangles) {
    const auto [i, j, k] = mesh.triangles[t];
    const Point3 &a = mesh.points[i], &b = mesh.points[j], &c = mesh.points[k];
    const Number ax(a.x), ay(a.y), az(a.z), bx(b.x), by(b.y), bz(b.z), cx(c.x), cy(c.y), cz(c.z);
    six_volumes += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return static_cast<int>(CGAL::sign(six_volumes));
}

}  // namespace odontoscope
