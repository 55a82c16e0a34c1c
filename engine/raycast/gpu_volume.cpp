#include "engine/raycast/gpu_volume.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace odontoscope {

namespace {

constexpr std::size_t transfer_entries = 4096;

void set_sampling(const Gl& gl, GLenum target, GLint filter) {
  for (const GLenum which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) gl.TexParameteri(target, which, filter);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
}

/// Can a brick of such values change the picture?
bool shows(const VolumeLook& look, float lowest, float highest) {
  const auto low = static_cast<double>(lowest), high = static_cast<double>(highest);
  switch (look.cast) {
    case VolumeLook::Cast::shaded:
      return any_extinction(look.transfer, low, high);
    case VolumeLook::Cast::surface:
      return low < look.iso && high >= look.iso;
    case VolumeLook::Cast::radiograph:
      return low != look.black || high != look.black;
    case VolumeLook::Cast::maximum:
    case VolumeLook::Cast::average:
      break;
  }
  return high > look.black;
}

}  // namespace

GpuVolume::GpuVolume(const Gl& gl, const ValueGrid& grid, const FieldTexture& field)
    : gl_(&gl),
      field_(field),
      bricks_(brick_grid(grid)),
      range_(grid.range),
      brick_texture_(make_texture(gl)),
      transfer_texture_(make_texture(gl)) {}

float GpuVolume::stride() const {
  const float finest = 0.5f * std::min({field_.step.x, field_.step.y, field_.step.z});
  return coarseness_ * std::max(finest, glm::length(field_.size * field_.step) / most_steps);
}

float GpuVolume::clear_slope() const {
  return 0.0625f * static_cast<float>(range_.high - range_.low) /
         std::max({field_.step.x, field_.step.y, field_.step.z});
}

void GpuVolume::prepare(const VolumeLook& look) {
  if (prepared_ == look) return;
  const std::vector<std::uint8_t> distances =
      distances_to_shown(bricks_, [&](float low, float high) { return shows(look, low, high); });
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_3D, brick_texture_.id());
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage3D(GL_TEXTURE_3D, 0, GL_R8, static_cast<GLsizei>(bricks_.size[0]), static_cast<GLsizei>(bricks_.size[1]),
                  static_cast<GLsizei>(bricks_.size[2]), 0, GL_RED, GL_UNSIGNED_BYTE, distances.data());
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  set_sampling(*gl_, GL_TEXTURE_3D, GL_NEAREST);
  gl_->BindTexture(GL_TEXTURE_3D, 0);
  lay_out_transfer(look);
  prepared_ = look;
}

void GpuVolume::lay_out_transfer(const VolumeLook& look) {
  constexpr double metres_to_mm = 1000;  // extinction for each metre
  std::vector<glm::vec4> sums;
  glm::dvec4 sum(0), before(0);
  const double step = (range_.high - range_.low) / (transfer_entries - 1);
  for (std::size_t i = 0; i < transfer_entries; ++i) {
    const glm::dvec4 entry(transferred(look.transfer, range_.low + step * static_cast<double>(i)));
    const glm::dvec4 here = metres_to_mm * entry.a * glm::dvec4(glm::dvec3(entry), 1);
    if (i > 0) sum += 0.5 * step * (before + here);
    before = here;
    sums.emplace_back(sum);
  }
  gl_->BindTexture(GL_TEXTURE_2D, transfer_texture_.id());
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, transfer_entries, 1, 0, GL_RGBA, GL_FLOAT, sums.data());
  set_sampling(*gl_, GL_TEXTURE_2D, GL_NEAREST);
  gl_->BindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace odontoscope
