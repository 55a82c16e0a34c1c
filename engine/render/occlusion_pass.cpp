#include "engine/render/occlusion_pass.h"

#include <glm/matrix.hpp>

namespace odontoscope {

OcclusionPass::OcclusionPass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), program_(gl, shaders, {"fullscreen.vert", "occlusion.frag"}), no_vertices_(make_vertex_array(gl)) {}

void OcclusionPass::draw(const FramePlan& plan, const Layer& layer, const Framebuffer& occlusion) const {
  occlusion.bind();
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_CULL_FACE);
  program_.use();
  program_.set("depth", 0);
  program_.set("eye_to_clip", plan.view.eye_to_clip);
  program_.set("clip_to_eye", glm::inverse(plan.view.eye_to_clip));
  program_.set("pixels", glm::vec2(plan.size.width, plan.size.height));
  program_.set("low", plan.touched.low);
  program_.set("high", plan.touched.high);
  program_.set("reach", plan.occlusion_reach());
  program_.set("strength", plan.occlusion.strength);
  layer.bind_depth(0);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace odontoscope
