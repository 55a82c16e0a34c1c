#pragma once
// The points that contours of a volume may have: a lattice on which every coordinate is computed without rounding.
//
// Voxels 0.2 mm apart are no doubles: origin + i * spacing, rounded anew for every i, leaves edges that should be
// parallel off by 1e-16 and squares that should be cocircular not quite so. What is decided exactly later then sees
// slivers that nobody meant. So spacing and origin are rounded once, to multiples of `step`, and all that follows is
// whole numbers: voxel centres are multiples of `step`, points between them of `step / 2`. Edges that are parallel on
// the voxel grid are exactly parallel, points that are cocircular there exactly cocircular.
//
// `step` is 2^-30 mm, a picometre (limits::lattice_step), which leaves a double for a tooth's coordinates 15 bits and
// more to halve edges with later. It is a smaller power of two where a voxel would hold fewer than
// limits::lattice_steps_per_voxel of them, as far as doubles reach at the volume's place.
//
// Dyadic spacings (0.25, 0.5 mm) are not changed at all. Others place voxel i at most (i + 1) * step / 2 away from
// where the file has it: `largest_shift` says how far that comes to.

#include <cstddef>
#include <cstdint>

#include "recon/core/geometry.h"
#include "recon/volume/volume.h"

namespace odontoscope {

/// Precondition for all of it: validate_grid passed.
class Lattice {
 public:
  explicit Lattice(const Volume& volume);

  /// mm.
  double step() const { return 2 * half_step_; }
  /// Between where the file has a voxel's centre and where the lattice has it, mm; the largest along any axis.
  double largest_shift() const { return largest_shift_; }

  double x(std::ptrdiff_t i) const { return at(0, 2 * i); }
  double y(std::ptrdiff_t j) const { return at(1, 2 * j); }
  double z(std::size_t k) const { return at(2, 2 * static_cast<std::ptrdiff_t>(k)); }
  /// So many quarters of the way from i to i + 1, exactly, as far as doubles reach; on the lattice if that is half or
  /// all.
  double x_quarters(std::ptrdiff_t i, int quarters) const { return quarters_from(0, i, quarters); }
  double y_quarters(std::ptrdiff_t j, int quarters) const { return quarters_from(1, j, quarters); }
  /// Between neighbours: the lattice point nearest to the given part of the way from i to i + 1, which lies in (0, 1).
  double x_between(std::ptrdiff_t i, double part) const { return between(0, i, part); }
  double y_between(std::ptrdiff_t j, double part) const { return between(1, j, part); }

 private:
  /// In halves of `step`; spacing and origin are even.
  struct Axis {
    std::int64_t origin = 0, spacing = 0;
  };
  double at(std::size_t axis, std::ptrdiff_t halves) const;
  double quarters_from(std::size_t axis, std::ptrdiff_t index, int quarters) const;
  double between(std::size_t axis, std::ptrdiff_t index, double part) const;

  double half_step_ = 0, largest_shift_ = 0;
  Axis axes_[3];
};

}  // namespace odontoscope
