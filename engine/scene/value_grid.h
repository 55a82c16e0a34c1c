#pragma once
// The part of a volume that a section through the model can show: its grey values around the model.
//
// Value (i, j, k) belongs to the place first_mm + (i, j, k) * step_mm in the user's coordinates, where recon/volume has
// the centre of the voxel and its contours their points; between such places it is interpolated, beyond the outermost
// it stays the same.

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/scene.h"
#include "recon/volume/volume.h"

namespace odontoscope {

struct ValueGrid {
  std::array<std::size_t, 3> size{};
  glm::dvec3 first_mm{0}, step_mm{1};
  std::vector<float> values;  // x runs fastest, then y, then z
  ValueWindow range;          // lowest and highest of `values`; highest is more, even if all are equal
  /// From the `usual_low` to the `usual_high` quantile of the values, so that a few metal voxels do not darken the
  /// rest.
  ValueWindow usual;
  /// Voxels that became one value, along each axis.
  std::array<std::size_t, 3> merged{1, 1, 1};
};

inline constexpr double usual_low = 0.005, usual_high = 0.995;

struct ValueGridLimits {
  std::size_t most_values = 128u << 20;  // 512 MiB
  std::size_t longest_side = 2048;       // what every OpenGL 4.1 has for textures of three dimensions
};

/// Precondition: `volume` passes validate_volume. Keeps the voxels in `bounds_mm` and one more all around. Where that
/// is more than `limits` allow, blocks of voxels become their mean, finest axis first; a block that reaches beyond the
/// volume repeats its last voxel.
ValueGrid value_grid(const Volume& volume, const Box& bounds_mm, const ValueGridLimits& limits = {});
/// The same, of a volume that nobody needs any more: where all of it is kept as it is, nothing is copied.
ValueGrid value_grid(Volume&& volume, const Box& bounds_mm, const ValueGridLimits& limits = {});

}  // namespace odontoscope
