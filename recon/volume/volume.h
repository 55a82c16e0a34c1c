#pragma once
// A scalar volume image (CT, micro-CT, CBCT or a label map) as plain values on a grid that is aligned with the axes.
//
// Units are millimetres. Voxel (i, j, k) has its centre at origin + (i, j, k) * spacing; all spacings are positive, so
// that growing indices mean growing coordinates and nothing is ever mirrored by the grid itself.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/input/patient_origin.h"

namespace odontoscope {

/// What a label map's file calls one of its values.
struct VolumeLabel {
  std::int64_t value = 0;
  std::string name;
};

/// A value that voxels have which are of several labels at once.
struct LabelOverlap {
  std::int64_t value = 0;
  std::vector<std::int64_t> labels;  // ascending
};

struct Volume {
  /// Voxels along x, y and z.
  std::array<std::size_t, 3> size{};
  std::array<double, 3> spacing{1, 1, 1};
  /// Centre of voxel (0, 0, 0).
  Point3 origin;
  /// x runs fastest, then y, then z.
  std::vector<float> values;
  /// Name of the file it came from, for messages; may be empty.
  std::string source;
  /// How far the image's own axes were turned away from the coordinate axes in the file, degrees. read_volume drops
  /// this turn (see there); the shape is untouched.
  double tilt_degrees = 0;
  /// The turn itself, and the DICOM series that it came from.
  PatientOrigin patient;
  /// By value; only some formats name them.
  std::vector<VolumeLabel> labels;
  /// By value. None of the values is a label.
  std::vector<LabelOverlap> overlaps;
  /// Voxels of the file that became one of these, along x, y and z: of a large file that was not wanted whole
  /// (VolumePart).
  std::array<std::size_t, 3> merged{1, 1, 1};
  /// How many there were along x, y and z before that, which need be no multiple; zeros if none were merged.
  std::array<std::size_t, 3> size_before{};
  /// What the file does not say and was assumed, and what was left out: one line each, to be told.
  std::vector<std::string> remarks;

  std::size_t pixels_per_slice() const { return size[0] * size[1]; }
  const float* slice(std::size_t k) const { return values.data() + k * pixels_per_slice(); }
};

/// Whether a voxel's value is of several labels at once, and so no label itself.
bool is_overlap(const Volume& volume, float value);

/// Whether a voxel's value makes it one of a label's.
class LabelValues {
 public:
  LabelValues(const Volume& volume, std::int64_t label);
  bool operator()(float value) const {
    if (value == label_) return true;
    for (const float shared : shared_)
      if (value == shared) return true;
    return false;
  }
  bool any_shared() const { return !shared_.empty(); }

 private:
  float label_;
  std::vector<float> shared_;
};

struct ValueRange {
  float lowest = 0, highest = 0;
};

/// Everything about a volume but its voxels, to be checked before memory is asked for.
/// Throws InputError: empty-volume (a size of 0), single-slice (fewer than two slices: no solid has one),
/// too-many-voxels, bad-spacing (not finite, not positive, below limits::smallest_spacing), not-finite or too-large (a
/// corner of the grid).
void validate_grid(const Volume& volume);

/// validate_grid, then the voxels: InputError not-finite names the first voxel that is NaN or infinite;
/// wrong-voxel-count if `values` does not hold size[0] * size[1] * size[2] of them. Returns their range.
ValueRange validate_volume(const Volume& volume);

}  // namespace odontoscope
