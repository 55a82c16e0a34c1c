#pragma once
// A turn and a shift: lengths, angles and handedness stay.

#include <array>
#include <cstddef>

#include "recon/core/geometry.h"

namespace odontoscope {

struct RigidMotion {
  /// Rows of an orthogonal matrix of determinant 1.
  std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  /// Added after the turn, mm.
  Point3 shift;

  Point3 operator()(const Point3& p) const;
  RigidMotion inverse() const;
  /// By how much it turns, 0 to 180 degrees.
  double degrees() const;
  /// Rows of the matrix that takes (x, y, z, 1) there.
  std::array<std::array<double, 4>, 4> matrix() const;
};

/// Sums over points from which their principal axes follow.
class Moments {
 public:
  void add(const Point3& at);
  std::size_t count() const { return count_; }
  Point3 centre() const;
  struct Axes {
    /// Of the points along each axis, mm^2; the largest first.
    std::array<double, 3> variance{};
    /// Unit vectors.
    std::array<std::array<double, 3>, 3> direction{};
  };
  /// Precondition: at least one point.
  Axes axes() const;

 private:
  std::size_t count_ = 0;
  Point3 first_;  // sums are about it, so that a distant origin costs no digits
  std::array<double, 3> sum_{};
  std::array<std::array<double, 3>, 3> products_{};
};

/// The least turn about `centre` that takes the line along unit vector `axis` to the z axis: by 90 degrees at most, so
/// that what was above stays above.
RigidMotion turn_to_z(const std::array<double, 3>& axis, const Point3& centre);

}  // namespace odontoscope
