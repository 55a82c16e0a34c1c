#include "engine/render/resolve_pass.h"

namespace odontoscope {

ResolvePass::ResolvePass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), program_(gl, shaders, {"fullscreen.vert", "resolve.frag"}), no_vertices_(make_vertex_array(gl)) {}

void ResolvePass::draw(const FramePlan& plan, const Framebuffer& picture, const Background& background,
                       const Target& target) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_->Viewport(target.left, target.bottom, target.size.width, target.size.height);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_CULL_FACE);
  const bool plain = background.kind == Background::Kind::plain;
  program_.use();
  program_.set("picture", 0);
  program_.set("side", plan.side);
  program_.set("corner", glm::ivec2(target.left, target.bottom));
  program_.set("pixels", glm::vec2(target.size.width, target.size.height));
  program_.set("background_top", linear(background.top));
  program_.set("background_bottom", linear(plain ? background.top : background.bottom));
  program_.set("transparent", background.kind == Background::Kind::transparent ? 1 : 0);
  picture.bind_colour(0, 0);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace odontoscope
