#pragma once
// Voxels on a grid, and which of them belong to which structure.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

/// Voxel (i, j, k) has its centre at origin + (i, j, k) * spacing, as computed in doubles; mm, in the model's axes.
struct VoxelGrid {
  std::array<std::size_t, 3> size{};
  std::array<double, 3> spacing{1, 1, 1};
  Point3 origin;

  double x(std::size_t i) const { return origin.x + static_cast<double>(i) * spacing[0]; }
  double y(std::size_t j) const { return origin.y + static_cast<double>(j) * spacing[1]; }
  double z(std::size_t k) const { return origin.z + static_cast<double>(k) * spacing[2]; }
  std::size_t voxels() const { return size[0] * size[1] * size[2]; }
};

/// One bit a voxel; each row of x begins with a word of its own.
class VoxelBits {
 public:
  explicit VoxelBits(const std::array<std::size_t, 3>& size)
      : size_(size), words_((size[0] + 63) / 64), bits_(words_ * size[1] * size[2]) {}
  bool at(std::size_t i, std::size_t j, std::size_t k) const { return (bits_[word(i, j, k)] >> (i % 64) & 1) != 0; }
  void toggle(std::size_t i, std::size_t j, std::size_t k) { bits_[word(i, j, k)] ^= std::uint64_t{1} << (i % 64); }
  /// Is any voxel of slice k set?
  bool any(std::size_t k) const;
  std::size_t count() const;
  const std::vector<std::uint64_t>& words() const { return bits_; }

 private:
  std::size_t word(std::size_t i, std::size_t j, std::size_t k) const { return (k * size_[1] + j) * words_ + i / 64; }

  std::array<std::size_t, 3> size_;
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

struct Segment {
  std::string name;
  VoxelBits voxels;
};

/// Segments may overlap.
struct Segmentation {
  VoxelGrid grid;
  std::vector<Segment> segments;
};

struct Box3 {
  Point3 low, high;
};

/// Around all points. Precondition: there is one.
Box3 box_of(const ContourStack& stack);

/// Voxels of such a size around `box`, their centres on whole multiples of it, with an empty one on each side.
/// UsageError if they are more than limits::voxels, or if `spacing` is not positive or too small.
VoxelGrid grid_around(const Box3& box, const std::array<double, 3>& spacing);

/// The same with the first voxel's centre at `origin`. UsageError if the box reaches below half a voxel before it.
VoxelGrid grid_from(const Point3& origin, const Box3& box, const std::array<double, 3>& spacing);

/// UsageError for more voxels than limits::voxels.
void check_grid(const VoxelGrid& grid);

}  // namespace odontoscope
