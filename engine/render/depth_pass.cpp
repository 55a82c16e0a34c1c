#include "engine/render/depth_pass.h"

namespace odontoscope {

DepthPass::DepthPass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), program_(gl, shaders, {"fullscreen.vert", "nearest_depth.frag"}), no_vertices_(make_vertex_array(gl)) {}

void DepthPass::draw(const FramePlan& plan, const Layer& opaque, const Layer* first, const Target& target) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_->Viewport(target.left, target.bottom, target.size.width, target.size.height);
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Disable(GL_BLEND);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_ALWAYS);
  gl_->DepthMask(GL_TRUE);
  gl_->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  program_.use();
  program_.set("opaque_depth", 0);
  program_.set("first_depth", 1);
  program_.set("side", plan.side);
  program_.set("corner", glm::ivec2(target.left, target.bottom));
  program_.set("low", plan.touched.low);
  program_.set("high", plan.touched.high);
  opaque.bind_depth(0);
  (first ? *first : opaque).bind_depth(1);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->DepthFunc(GL_LESS);
}

}  // namespace odontoscope
