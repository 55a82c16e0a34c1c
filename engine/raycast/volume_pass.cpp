#include "engine/raycast/volume_pass.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <string_view>

namespace odontoscope {

namespace {

constexpr int values_unit = 0, bricks_unit = 1, transfer_unit = 2, from_unit = 3, to_unit = 4, opaque_unit = 5, sums_unit = 6;
constexpr float metres_to_mm = 1000;

ProgramFiles files_of(VolumeLook::Cast cast) {
  switch (cast) {
    case VolumeLook::Cast::maximum: return {"fullscreen.vert", "volume.frag", {}, {"MAXIMUM"}};
    case VolumeLook::Cast::average: return {"fullscreen.vert", "volume.frag", {}, {"AVERAGE"}};
    case VolumeLook::Cast::radiograph: return {"fullscreen.vert", "volume.frag", {}, {"RADIOGRAPH"}};
    case VolumeLook::Cast::surface: return {"fullscreen.vert", "volume_surface.frag"};
    case VolumeLook::Cast::shaded: break;
  }
  return {"fullscreen.vert", "volume.frag", {}, {"SHADED"}};
}

void bind(const Gl& gl, int unit, GLenum target, GLuint texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(target, texture);
}

}  // namespace

VolumePass::VolumePass(const Gl& gl, const ShaderLibrary& shaders) : gl_(&gl), shaders_(shaders), no_vertices_(make_vertex_array(gl)) {}

Program& VolumePass::program(VolumeLook::Cast cast) {
  const auto found = programs_.find(cast);
  return found != programs_.end() ? found->second : programs_.emplace(cast, Program(*gl_, shaders_, files_of(cast))).first->second;
}

void VolumePass::set_view(const Program& program, const CastView& view, const GpuVolume& volume) const {
  program.use();
  program.set("eye_to_world", glm::inverse(view.world_to_eye));
  program.set("eye_to_clip", view.eye_to_clip);
  program.set("clip_to_eye", glm::inverse(view.eye_to_clip));
  program.set("pixels", glm::vec2(view.size.width, view.size.height));
  program.set("parallel", view.parallel ? 1 : 0);
  program.set("section", view.section);
  program.set("lamp", view.lamp);
  program.set("first", volume.field().first);
  program.set("spacing", volume.field().step);
  program.set("size", volume.field().size);
  program.set("stride", volume.stride());
  program.set("brick_side", static_cast<float>(brick_side));
  program.set("values", values_unit);
  program.set("bricks", bricks_unit);
  bind(*gl_, values_unit, GL_TEXTURE_3D, volume.field().texture);
  bind(*gl_, bricks_unit, GL_TEXTURE_3D, volume.bricks());
}

void VolumePass::cover() const {
  gl_->Disable(GL_CULL_FACE);
  gl_->Disable(GL_STENCIL_TEST);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->Disable(GL_BLEND);
  gl_->ActiveTexture(GL_TEXTURE0);
}

void VolumePass::cover_behind(const Framebuffer& picture) const {
  picture.bind();
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Enable(GL_BLEND);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  cover();
}

void VolumePass::draw_between(const CastView& view, const GpuVolume& volume, const VolumeLook& look, const CastDepths& depths, const Framebuffer& picture) {
  const Program& cast = program(VolumeLook::Cast::shaded);
  set_view(cast, view, volume);
  cast.set("transfer", transfer_unit);
  cast.set("sums", sums_unit);
  cast.set("transfer_range", glm::vec2(volume.range().low, volume.range().high));
  cast.set("lit", look.lit ? 1 : 0);
  cast.set("clear_slope", volume.clear_slope());
  cast.set("depth_from", from_unit);
  cast.set("depth_to", to_unit);
  cast.set("depth_opaque", opaque_unit);
  cast.set("from_the_eye", depths.from == 0 ? 1 : 0);
  bind(*gl_, transfer_unit, GL_TEXTURE_2D, volume.transfer());
  bind(*gl_, sums_unit, GL_TEXTURE_2D, volume.sums());
  bind(*gl_, from_unit, GL_TEXTURE_2D, depths.from != 0 ? depths.from : depths.opaque);
  bind(*gl_, to_unit, GL_TEXTURE_2D, depths.to != 0 ? depths.to : depths.opaque);
  bind(*gl_, opaque_unit, GL_TEXTURE_2D, depths.opaque);
  cover_behind(picture);
}

void VolumePass::draw_projection(const CastView& view, const GpuVolume& volume, const VolumeLook& look, const Framebuffer& picture) {
  const Program& cast = program(look.cast);
  set_view(cast, view, volume);
  cast.set("low", static_cast<float>(look.black));
  cast.set("high", static_cast<float>(look.white));
  cast.set("attenuation", metres_to_mm * static_cast<float>(look.attenuation));
  cast.set("latitude", static_cast<float>(look.latitude));
  cover_behind(picture);
}

void VolumePass::draw_surface(const CastView& view, const GpuVolume& volume, const VolumeLook& look) {
  const Program& cast = program(look.cast);
  set_view(cast, view, volume);
  cast.set("iso", static_cast<float>(look.iso));
  cast.set("colour", linear(look.iso_colour));
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->Disable(GL_BLEND);
  cover();
}

}  // namespace odontoscope
