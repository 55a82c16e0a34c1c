#include "engine/render/gpu_value_grid.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/gpu/graphics_error.h"

namespace odontoscope {

GpuValueGrid upload(const Gl& gl, const ValueGrid& grid, const GpuModel& model) {
  const auto refuse = [&] {
    throw GraphicsError(
        "volume-too-large",
        fmt::format("this OpenGL has no room for {} x {} x {} grey values", grid.size[0], grid.size[1], grid.size[2]),
        "Let the cap show the material.");
  };
  GLint longest = 0;
  gl.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longest);
  if (*std::max_element(grid.size.begin(), grid.size.end()) > static_cast<std::size_t>(longest)) refuse();
  GpuValueGrid uploaded;
  uploaded.texture = make_texture(gl);
  uploaded.first = glm::vec3(metres_per_mm * (grid.first_mm - model.origin_mm));
  uploaded.step = glm::vec3(metres_per_mm * grid.step_mm);
  uploaded.size = glm::vec3(grid.size[0], grid.size[1], grid.size[2]);
  uploaded.usual = grid.usual;
  gl.BindTexture(GL_TEXTURE_3D, uploaded.texture.id());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_R32F, static_cast<GLsizei>(grid.size[0]), static_cast<GLsizei>(grid.size[1]),
                static_cast<GLsizei>(grid.size[2]), 0, GL_RED, GL_FLOAT, grid.values.data());
  if (gl.GetError() == GL_OUT_OF_MEMORY) refuse();
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
  gl.BindTexture(GL_TEXTURE_3D, 0);
  return uploaded;
}

}  // namespace odontoscope
