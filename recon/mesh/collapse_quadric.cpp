#include "recon/mesh/collapse_quadric.h"

namespace odontoscope {
namespace {

/// Directions in which the error grows less than this share of the whole are left alone: surfaces that bend by less
/// than one degree.
constexpr double flat_share = 3e-4;
/// Sum of normals over the root of the sum of their squares, below which they cancel and volume tells nothing.
constexpr double cancelled = 1e-3;

/// Solves for a symmetric, positive definite matrix (xx, xy, xz, yy, yz, zz).
Direction solved(const std::array<double, 6>& m, const Direction& right) {
  const double l11 = std::sqrt(m[0]), l21 = m[1] / l11, l31 = m[2] / l11;
  const double l22 = std::sqrt(m[3] - l21 * l21), l32 = (m[4] - l31 * l21) / l22;
  const double l33 = std::sqrt(m[5] - l31 * l31 - l32 * l32);
  const double y1 = right.x / l11, y2 = (right.y - l21 * y1) / l22, y3 = (right.z - l31 * y1 - l32 * y2) / l33;
  const double z = y3 / l33, y = (y2 - l32 * z) / l22;
  return {(y1 - l21 * y - l31 * z) / l11, y, z};
}

}  // namespace

void CollapseQuadric::add_triangle(const Direction& a, const Direction& b, const Direction& c) {
  constexpr double half_of_sixth_squared = 1.0 / 72;
  const auto minus = [](const Direction& u, const Direction& v) { return Direction{u.x - v.x, u.y - v.y, u.z - v.z}; };
  const Direction n = cross(minus(b, a), minus(c, a));
  const double d = dot(n, a), w = half_of_sixth_squared;
  square_[0] += w * n.x * n.x, square_[1] += w * n.x * n.y, square_[2] += w * n.x * n.z;
  square_[3] += w * n.y * n.y, square_[4] += w * n.y * n.z, square_[5] += w * n.z * n.z;
  linear_ = linear_ + w * d * n;
  constant_ += w * d * d;
  normals_ = normals_ + n;
  offset_ += d;
  areas_ += dot(n, n);
}

void CollapseQuadric::add_line(const Direction& p, const Direction& q, double square) {
  const double w = square / 8;  // half of the squared area of a triangle
  const Direction u{q.x - p.x, q.y - p.y, q.z - p.z};
  const double uu = dot(u, u);
  const std::array<double, 6> m{uu - u.x * u.x, -u.x * u.y, -u.x * u.z, uu - u.y * u.y, -u.y * u.z, uu - u.z * u.z};
  const Direction mp{m[0] * p.x + m[1] * p.y + m[2] * p.z, m[1] * p.x + m[3] * p.y + m[4] * p.z,
                     m[2] * p.x + m[4] * p.y + m[5] * p.z};
  for (std::size_t i = 0; i < m.size(); ++i) square_[i] += w * m[i];
  linear_ = linear_ + w * mp;
  constant_ += w * dot(mp, p);
}

Direction CollapseQuadric::best(bool keep_volume) const {
  const double trace = square_[0] + square_[3] + square_[5];
  if (!(trace > 0)) return {};
  std::array<double, 6> m = square_;
  for (const std::size_t i : {0u, 3u, 5u}) m[i] += flat_share * trace;
  const Direction free = solved(m, linear_);
  if (!keep_volume || dot(normals_, normals_) < cancelled * cancelled * areas_) return free;
  const Direction along = solved(m, normals_);
  return free + (offset_ - dot(normals_, free)) / dot(normals_, along) * along;
}

double CollapseQuadric::cost(const Direction& at) const {
  const auto& m = square_;
  const Direction mx{m[0] * at.x + m[1] * at.y + m[2] * at.z, m[1] * at.x + m[3] * at.y + m[4] * at.z,
                     m[2] * at.x + m[4] * at.y + m[5] * at.z};
  return dot(mx, at) - 2 * dot(linear_, at) + constant_;
}

}  // namespace odontoscope
