#pragma once
// A volume's grey values in the graphics processor's memory, as a texture of three dimensions. Uploading never compiles
// a shader.

#include <glm/vec3.hpp>

#include "engine/gpu/gl_object.h"
#include "engine/raycast/gpu_volume.h"
#include "engine/render/gpu_model.h"
#include "engine/scene/value_grid.h"

namespace odontoscope {

struct GpuValueGrid {
  GlObject texture;  // one float a value; interpolated, clamped to its edge
  glm::vec3 first{0},
      step{1};  // metres, relative to the model's origin: where the first value's place is, and from one to the next
  glm::vec3 size{1};  // values along each axis
  ValueWindow usual;

  FieldTexture field() const { return {texture.id(), first, step, size}; }
};

/// To be shown with `model`. Throws GraphicsError "volume-too-large" if the driver has no room for it.
GpuValueGrid upload(const Gl& gl, const ValueGrid& grid, const GpuModel& model);

}  // namespace odontoscope
