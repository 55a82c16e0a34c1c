#pragma once
// A volume in the graphics processor's memory, ready to cast rays through. Preparing a look never uploads the values
// again.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

#include "engine/gpu/gl_object.h"
#include "engine/raycast/brick_grid.h"
#include "engine/scene/volume_look.h"

namespace odontoscope {

/// The texture of a grid's values, which somebody else owns, and where they lie: metres, relative to the model's
/// origin.
struct FieldTexture {
  GLuint texture = 0;
  glm::vec3 first{0}, step{1}, size{1};
};

class GpuVolume {
 public:
  GpuVolume() = default;
  /// `field` holds the values of `grid` and outlives this. Keeps a copy of neither.
  GpuVolume(const Gl& gl, const ValueGrid& grid, const FieldTexture& field);

  /// Lays out transfer function and empty bricks for such a look; at once if it is the last one's. Precondition:
  /// sensible(look.transfer) if it is shaded. `look.transfer` may then hold values of any size.
  void prepare(const VolumeLook& look);

  const FieldTexture& field() const { return field_; }
  GLuint bricks() const { return brick_texture_.id(); }
  /// The transfer function summed over the values: colour times extinction, and extinction for each metre.
  GLuint transfer() const { return transfer_texture_.id(); }
  const ValueWindow& range() const { return range_; }
  /// Its corners, half a step beyond the outermost values: metres.
  glm::vec3 low() const { return field_.first - 0.5f * field_.step; }
  glm::vec3 high() const { return low() + field_.size * field_.step; }
  /// Length of a step, metres: half the smallest distance of two values, or more where a ray would take over
  /// `most_steps`.
  float stride() const;
  /// So many times as long: for pictures that must not take long. 1 at first.
  void set_coarseness(float times) { coarseness_ = times; }

  /// Values a metre, beyond which a slope is a surface for sure: a sixteenth of their range from one value to the next.
  float clear_slope() const;

  static constexpr float most_steps = 8192;

 private:
  void lay_out_transfer(const VolumeLook& look);

  const Gl* gl_ = nullptr;
  FieldTexture field_;
  BrickGrid bricks_;
  ValueWindow range_;
  float coarseness_ = 1;
  GlObject brick_texture_, transfer_texture_;
  std::optional<VolumeLook> prepared_;
};

}  // namespace odontoscope
