#include "engine/render/compose_pass.h"

namespace odontoscope {

namespace {

/// Part of the occlusion's reach within which two neighbours lie on one surface.
constexpr float same_surface = 0.25f;

}  // namespace

ComposePass::ComposePass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), program_(gl, shaders, {"fullscreen.vert", "compose.frag"}), no_vertices_(make_vertex_array(gl)) {}

void ComposePass::draw(const FramePlan& plan, const Layer& layer, const Framebuffer* occlusion,
                       const Framebuffer& picture) const {
  picture.bind();
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_BLEND);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  program_.use();
  program_.set("light", 0);
  program_.set("ambient", 1);
  program_.set("occlusion", 2);
  program_.set("low", plan.touched.low);
  program_.set("high", plan.touched.high);
  program_.set("occluded", occlusion ? 1 : 0);
  program_.set("same_surface", same_surface * plan.occlusion_reach());
  layer.bind_light(0);
  layer.bind_ambient(1);
  if (occlusion)
    occlusion->bind_colour(0, 2);
  else
    layer.bind_light(2);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->Disable(GL_BLEND);
}

}  // namespace odontoscope
