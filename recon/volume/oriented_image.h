#pragma once
// From an image in a file's own axes to a Volume along x, y and z. Inner part of read_volume.h, which states the rules.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "recon/volume/read_volume.h"
#include "recon/volume/volume.h"

namespace odontoscope {

using Vector3 = std::array<double, 3>;
inline double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// An image as its file has it: axis 0 runs fastest.
struct FileImage {
  std::array<std::size_t, 3> size{1, 1, 1};
  Vector3 spacing{1, 1, 1};
  /// Centre of the first voxel.
  Vector3 origin{0, 0, 0};
  /// Unit vector along which axis n runs.
  std::array<Vector3, 3> direction{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::vector<float> values;
  std::string source;
  /// As in Volume, along the file's axes.
  std::array<std::size_t, 3> merged{1, 1, 1}, size_before{};
};

/// Voxels along an axis: from `first` on.
struct IndexRange {
  std::size_t first = 0, count = 0;
};

/// Those of the image, along its own axes, that lie within bounds along x, y and z of its Volume, mm, and one more at
/// either end; never none. Precondition: oriented_grid(image) does not throw.
std::array<IndexRange, 3> index_ranges(const FileImage& image, const VolumeBounds& bounds);

/// The grid of `image` along x, y, z without values. Throws InputError sheared-volume and what validate_grid throws.
Volume oriented_grid(const FileImage& image);

/// The same with its values, which are moved or reordered.
Volume oriented(FileImage&& image);

}  // namespace odontoscope
