#include "recon/core/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "recon/core/portable_math.h"
#include "recon/core/symmetric_matrix.h"

namespace odontoscope {

Point3 RigidMotion::operator()(const Point3& p) const {
  const auto& r = rotation;
  return {r[0][0] * p.x + r[0][1] * p.y + r[0][2] * p.z + shift.x,
          r[1][0] * p.x + r[1][1] * p.y + r[1][2] * p.z + shift.y,
          r[2][0] * p.x + r[2][1] * p.y + r[2][2] * p.z + shift.z};
}

RigidMotion RigidMotion::inverse() const {
  RigidMotion back;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) back.rotation[i][j] = rotation[j][i];
  const Point3 moved = back(shift);
  back.shift = {-moved.x, -moved.y, -moved.z};
  return back;
}

double RigidMotion::degrees() const {
  const double trace = rotation[0][0] + rotation[1][1] + rotation[2][2];
  return portable::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::array<std::array<double, 4>, 4> RigidMotion::matrix() const {
  const auto& r = rotation;
  return {{{r[0][0], r[0][1], r[0][2], shift.x},
           {r[1][0], r[1][1], r[1][2], shift.y},
           {r[2][0], r[2][1], r[2][2], shift.z},
           {0, 0, 0, 1}}};
}

void Moments::add(const Point3& at) {
  if (count_++ == 0) first_ = at;
  const std::array<double, 3> d{at.x - first_.x, at.y - first_.y, at.z - first_.z};
  for (std::size_t i = 0; i < 3; ++i) {
    sum_[i] += d[i];
    for (std::size_t j = 0; j < 3; ++j) products_[i][j] += d[i] * d[j];
  }
}

Point3 Moments::centre() const {
  const auto n = static_cast<double>(count_);
  return {first_.x + sum_[0] / n, first_.y + sum_[1] / n, first_.z + sum_[2] / n};
}

Moments::Axes Moments::axes() const {
  const auto n = static_cast<double>(count_);
  Matrix3 a{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) a[i][j] = products_[i][j] / n - sum_[i] / n * (sum_[j] / n);
  const Matrix3 v = eigenvectors(a);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&a](std::size_t i, std::size_t j) { return std::pair(-a[i][i], i) < std::pair(-a[j][j], j); });
  Axes axes;
  for (std::size_t i = 0; i < 3; ++i) {
    axes.variance[i] = a[order[i]][order[i]];
    for (std::size_t k = 0; k < 3; ++k) axes.direction[i][k] = v[k][order[i]];
  }
  return axes;
}

RigidMotion turn_to_z(const std::array<double, 3>& axis, const Point3& centre) {
  const double up = axis[2] < 0 ? -1 : 1;
  const double x = up * axis[0], y = up * axis[1], z = up * axis[2];
  // Rodrigues' formula about (y, -x, 0), with cosine z.
  RigidMotion turn;
  turn.rotation = {
      {{1 - x * x / (1 + z), -x * y / (1 + z), -x}, {-x * y / (1 + z), 1 - y * y / (1 + z), -y}, {x, y, z}}};
  const Point3 moved = turn(centre);
  turn.shift = {centre.x - moved.x, centre.y - moved.y, centre.z - moved.z};
  return turn;
}

}  // namespace odontoscope
