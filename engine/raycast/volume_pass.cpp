#include "engine/raycast/volume_pass.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string_view>

namespace odontoscope {

namespace {

constexpr int values_unit = 0, bricks_unit = 1, transfer_unit = 2, from_unit = 3, to_unit = 4, opaque_unit = 5,
              coarse_unit = 6, alike_unit = 7;
constexpr int furthest_apart = 8;
constexpr float metres_to_mm = 1000;
constexpr float greys_are_stricter = 0.5;  // maxima have creases

ProgramFiles files_of(const VolumeLook& look) {
  switch (look.cast) {
    case VolumeLook::Cast::maximum:
      return {"fullscreen.vert", "volume.frag", {}, {"MAXIMUM"}};
    case VolumeLook::Cast::average:
      return {"fullscreen.vert", "volume.frag", {}, {"AVERAGE"}};
    case VolumeLook::Cast::radiograph:
      return {"fullscreen.vert", "volume.frag", {}, {"RADIOGRAPH"}};
    case VolumeLook::Cast::surface:
      return {"fullscreen.vert", "volume_surface.frag"};
    case VolumeLook::Cast::shaded:
      break;
  }
  if (look.slopes.count()) return {"fullscreen.vert", "volume.frag", {}, {"SHADED", "BY_SLOPE"}};
  return {"fullscreen.vert", "volume.frag", {}, {"SHADED"}};
}

void bind(const Gl& gl, int unit, GLenum target, GLuint texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(target, texture);
}

/// The largest distance of two neighbouring rays within the volume: metres.
float sample_width(const CastView& view, const GpuVolume& volume) {
  const float side = 2 / (view.eye_to_clip[1][1] * static_cast<float>(view.size.height));
  if (view.parallel) return side;
  const glm::vec3 middle = 0.5f * (volume.low() + volume.high());
  const float depth = -(view.world_to_eye * glm::vec4(middle, 1)).z + 0.5f * glm::length(volume.high() - volume.low());
  return side * std::max(depth, 0.0f);
}

void keep_to(const Gl& gl, const CastView& view, int apart) {
  const int margin = apart > 1 ? 3 : 0;  // rays between others look at those, and at one more on either side
  const glm::ivec2 low = glm::max(view.touched_low / apart - margin, glm::ivec2(0)),
                   size = (view.touched_high + apart - 1) / apart + margin - low;
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(low.x, low.y, std::max(size.x, 0), std::max(size.y, 0));
}

}  // namespace

std::vector<int> ray_distances(const CastView& view, const GpuVolume& volume) {
  const glm::vec3& step = volume.field().step;
  const float width = sample_width(view, volume), finest = std::min({step.x, step.y, step.z});
  int apart = 1;
  while (!view.every_ray && apart < furthest_apart && 2 * static_cast<float>(apart) * width <= finest) apart *= 2;
  std::vector<int> distances;
  for (; apart >= 1; apart /= 2) distances.push_back(apart);
  return distances;
}

VolumePass::VolumePass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), shaders_(shaders), no_vertices_(make_vertex_array(gl)) {}

Program& VolumePass::program(const VolumeLook& look) {
  const std::pair kind{look.cast, look.cast == VolumeLook::Cast::shaded && look.slopes.count()};
  const auto found = programs_.find(kind);
  return found != programs_.end() ? found->second
                                  : programs_.emplace(kind, Program(*gl_, shaders_, files_of(look))).first->second;
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
  gl_->ActiveTexture(GL_TEXTURE0);
}

Program& VolumePass::program(const char* fragment) {
  const auto found = between_.find(fragment);
  return found != between_.end()
             ? found->second
             : between_.emplace(fragment, Program(*gl_, shaders_, {"fullscreen.vert", fragment})).first->second;
}

const VolumePass::Coarse& VolumePass::coarse_for(int apart, PixelSize size) {
  const PixelSize fewer{(size.width + apart - 1) / apart, (size.height + apart - 1) / apart};
  Coarse& coarse = coarse_[apart];
  if (coarse.seen.size() != fewer)
    coarse = {Framebuffer(*gl_, {fewer, {GL_RGBA16F}, GL_DEPTH_COMPONENT32F}), Framebuffer(*gl_, {fewer, {GL_R8}})};
  return coarse;
}

void VolumePass::judge(const CastView& view, const GpuVolume& volume, Among among, int apart, bool last) {
  const Coarse& coarse = coarse_for(apart, view.size);
  const Program& judge = program("volume_alike.frag");
  judge.use();
  judge.set("apart", apart);
  judge.set("stride", volume.stride());
  judge.set("parallel", view.parallel ? 1 : 0);
  judge.set("eye_to_clip", view.eye_to_clip);
  judge.set("alike", (among == Among::greys ? greys_are_stricter : 1) * (last ? alike : alike_far_apart));
  judge.set("among_surfaces", among == Among::surfaces ? 1 : 0);
  judge.set("depth_from", from_unit);
  judge.set("depth_to", to_unit);
  judge.set("depth_opaque", opaque_unit);
  judge.set("coarse", coarse_unit);
  coarse.seen.bind_colour(0, coarse_unit);
  coarse.alike.bind();
  keep_to(*gl_, view, apart);
  cover();
}

void VolumePass::tell(int apart, int coarser) {
  const Program& tell = program("volume_told.frag");
  tell.use();
  tell.set("coarse", coarse_unit);
  tell.set("alike", alike_unit);
  tell.set("coarser", coarser / apart);
  coarse_.at(coarser).seen.bind_colour(0, coarse_unit);
  coarse_.at(coarser).alike.bind_colour(0, alike_unit);
  gl_->DepthMask(GL_TRUE);
  constexpr GLfloat nothing_told = 1;
  gl_->ClearBufferfv(GL_DEPTH, 0, &nothing_told);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_ALWAYS);
}

void VolumePass::cover_behind(const Program& cast, const CastView& view, const GpuVolume& volume, Among among,
                              const Framebuffer& picture) {
  const std::vector<int> distances = ray_distances(view, volume);
  gl_->ActiveTexture(GL_TEXTURE0 + coarse_unit);  // making textures unbinds what is bound there
  for (const int apart : distances)
    if (apart > 1) coarse_for(apart, view.size);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  int coarser = 0;
  for (const int apart : distances) {
    gl_->Disable(GL_DEPTH_TEST);
    gl_->Disable(GL_BLEND);
    if (coarser > 0) judge(view, volume, among, coarser, apart == 1);
    (apart > 1 ? coarse_for(apart, view.size).seen : picture).bind();
    keep_to(*gl_, view, apart);
    (apart > 1 ? gl_->Disable : gl_->Enable)(GL_BLEND);
    if (coarser > 0) {
      tell(apart, coarser);
      cover();
      gl_->DepthFunc(GL_LESS);
    }
    cast.use();
    cast.set("apart", apart);
    cover();
    coarser = apart;
  }
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
}

void VolumePass::draw_between(const CastView& view, const GpuVolume& volume, const VolumeLook& look,
                              const CastDepths& depths, const Framebuffer& picture) {
  const Program& cast = program(look);
  set_view(cast, view, volume);
  cast.set("transfer", transfer_unit);
  cast.set("transfer_range", glm::vec2(volume.range().low, volume.range().high));
  cast.set("lit", look.lit ? 1 : 0);
  cast.set("clear_slope", volume.clear_slope());
  cast.set("slopes", metres_to_mm * glm::vec2(look.slopes.flat, look.slopes.steep));
  cast.set("depth_from", from_unit);
  cast.set("depth_to", to_unit);
  cast.set("depth_opaque", opaque_unit);
  cast.set("from_the_eye", depths.from == 0 ? 1 : 0);
  cast.set("among_surfaces", depths.any ? 1 : 0);
  bind(*gl_, transfer_unit, GL_TEXTURE_2D, volume.transfer());
  bind(*gl_, from_unit, GL_TEXTURE_2D, depths.from != 0 ? depths.from : depths.opaque);
  bind(*gl_, to_unit, GL_TEXTURE_2D, depths.to != 0 ? depths.to : depths.opaque);
  bind(*gl_, opaque_unit, GL_TEXTURE_2D, depths.opaque);
  cover_behind(cast, view, volume, depths.any ? Among::surfaces : Among::nothing, picture);
}

void VolumePass::draw_projection(const CastView& view, const GpuVolume& volume, const VolumeLook& look,
                                 const Framebuffer& picture) {
  const Program& cast = program(look);
  set_view(cast, view, volume);
  cast.set("low", static_cast<float>(look.black));
  cast.set("high", static_cast<float>(look.white));
  cast.set("attenuation", metres_to_mm * static_cast<float>(look.attenuation));
  cast.set("latitude", static_cast<float>(look.latitude));
  cast.set("inverted", look.inverted ? 1 : 0);
  cast.set("film", glm::vec2(look.film_mm) / metres_to_mm);
  cast.set("film_centre", view.film_centre);
  cover_behind(cast, view, volume, Among::greys, picture);
}

void VolumePass::draw_surface(const CastView& view, const GpuVolume& volume, const VolumeLook& look) {
  const Program& cast = program(look);
  set_view(cast, view, volume);
  cast.set("iso", static_cast<float>(look.iso));
  cast.set("colour", linear(look.iso_colour));
  cast.set("apart", 1);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->Disable(GL_BLEND);
  cover();
}

}  // namespace odontoscope
