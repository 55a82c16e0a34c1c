#include "recon/volume/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "recon/core/limits.h"

namespace odontoscope {
namespace {

/// The largest power of two up to `value`.
double power_of_two_below(double value) { return std::ldexp(1.0, std::ilogb(value)); }

/// Half a step must be told apart by doubles everywhere in the volume and one voxel around it.
double finest_step(const Volume& volume, const std::array<double, 3>& origin) {
  double farthest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double beyond = static_cast<double>(volume.size[axis] + 1) * volume.spacing[axis];
    farthest = std::max(farthest, std::abs(origin[axis]) + beyond);
  }
  constexpr double spare = 4;
  return 2 * spare * std::numeric_limits<double>::epsilon() * power_of_two_below(farthest);
}

}  // namespace

Lattice::Lattice(const Volume& volume) {
  const std::array<double, 3> origin{volume.origin.x, volume.origin.y, volume.origin.z};
  const double finest_voxel = *std::min_element(volume.spacing.begin(), volume.spacing.end());
  const double wanted =
      std::min(limits::lattice_step, power_of_two_below(finest_voxel) / limits::lattice_steps_per_voxel);
  const double step = std::max(wanted, finest_step(volume, origin));
  half_step_ = step / 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes_[axis] = {2 * std::llround(origin[axis] / step), 2 * std::llround(volume.spacing[axis] / step)};
    const double origin_shift = at(axis, 0) - origin[axis];
    const double spacing_shift = static_cast<double>(axes_[axis].spacing) * half_step_ - volume.spacing[axis];
    const double last = origin_shift + static_cast<double>(volume.size[axis] - 1) * spacing_shift;
    largest_shift_ = std::max({largest_shift_, std::abs(origin_shift), std::abs(last)});
  }
}

double Lattice::at(std::size_t axis, std::ptrdiff_t halves) const {
  const auto half_spacing = axes_[axis].spacing / 2;
  return static_cast<double>(axes_[axis].origin + halves * half_spacing) * half_step_;
}

double Lattice::quarters_from(std::size_t axis, std::ptrdiff_t index, int quarters) const {
  const Axis& a = axes_[axis];
  return static_cast<double>(4 * a.origin + (4 * index + quarters) * a.spacing) * (half_step_ / 4);
}

double Lattice::between(std::size_t axis, std::ptrdiff_t index, double part) const {
  const Axis& a = axes_[axis];
  const std::int64_t along = std::llround(part * static_cast<double>(a.spacing));
  return static_cast<double>(a.origin + index * a.spacing + std::clamp<std::int64_t>(along, 1, a.spacing - 1)) *
         half_step_;
}

}  // namespace odontoscope
