#pragma once
// A volume on another grid: a part of it, larger or smaller voxels, or turned so that what it shows stands upright.
//
// **Between voxels.** Grey values are interpolated linearly; on a coarser grid each is the mean of the voxels around
// it, weighted by a tent as wide as the new voxels, so that nothing thin is skipped (as image libraries scale pictures
// down; Smith, "A pixel is not a little square", 1995). Labels are not numbers to be averaged: each new voxel has the
// nearest old one's.
//
// Coordinates stay where they were but for `upright`, which tells its turn.

#include <array>
#include <functional>

#include "recon/core/progress.h"
#include "recon/core/rigid_motion.h"
#include "recon/volume/volume.h"

namespace odontoscope {

enum class Sampling { linear, nearest };

/// mm, as coordinates of contours are.
struct VolumeBox {
  Point3 low, high;
};

/// The voxels whose centres lie in the box. Throws InputError crop-misses if there are none, single-slice.
Volume cropped(Volume&& volume, const VolumeBox& box);

/// Voxels of `spacing` mm along all axes, on a grid with the same middle and the same extent but for half a voxel at
/// most. Throws InputError too-many-voxels, single-slice, bad-spacing; FileError for more memory than there is. Stage
/// "resample". The result does not depend on the number of threads.
Volume resampled(const Volume& volume, double spacing, Sampling sampling, const Progress& progress = {});

struct UprightVolume {
  Volume volume;
  /// From the given volume's coordinates to the new one's.
  RigidMotion motion;
};

/// What `belongs` to the object (by value) is turned about its centre of mass by the least turn that brings its longest
/// principal axis to z; by 90 degrees at most, so that what was above stays above. The new grid has voxels of `spacing`
/// mm and holds the object with two voxels around it; where the old grid ends, `outside` stands. Throws InputError
/// no-long-axis if nothing belongs or no axis stands out (limits::long_axis), and what resampled throws. Stage
/// "upright".
UprightVolume upright(const Volume& volume, const std::function<bool(float)>& belongs, double spacing,
                      Sampling sampling, float outside, const Progress& progress = {});

}  // namespace odontoscope
