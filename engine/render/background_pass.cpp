#include "engine/render/background_pass.h"

namespace odontoscope {

namespace {

/// Enough that no pixel is off by more than rounding even from black to white.
constexpr int bands = 64;

}  // namespace

BackgroundPass::BackgroundPass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), gradient_(gl, shaders, {"background.vert", "background.frag"}), no_vertices_(make_vertex_array(gl)) {}

void BackgroundPass::draw_gradient(const Background& background, PixelSize size) {
  drawn_ = Framebuffer(*gl_, {size, {GL_RGBA8}});
  drawn_background_ = background;
  drawn_.bind();
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_CULL_FACE);
  gradient_.use();
  gradient_.set("bands", static_cast<float>(bands));
  gradient_.set("background_top", linear(background.top));
  gradient_.set("background_bottom", linear(background.bottom));
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (bands + 1));
}

void BackgroundPass::fill(const Background& background, const Target& target) {
  const bool gradient = background.kind == Background::Kind::gradient;
  if (gradient && (drawn_.size() != target.size || drawn_background_ != background))
    draw_gradient(background, target.size);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_->Viewport(target.left, target.bottom, target.size.width, target.size.height);
  gl_->Enable(GL_SCISSOR_TEST);  // a clear knows no viewport
  gl_->Scissor(target.left, target.bottom, target.size.width, target.size.height);
  constexpr GLfloat far_away = 1;
  gl_->DepthMask(GL_TRUE);
  gl_->ClearBufferfv(GL_DEPTH, 0, &far_away);
  if (!gradient) {
    const bool transparent = background.kind == Background::Kind::transparent;
    const GLfloat flat[4] = {background.top.red, background.top.green, background.top.blue, 1};
    constexpr GLfloat nothing[4] = {0, 0, 0, 0};
    gl_->ClearBufferfv(GL_COLOR, 0, transparent ? nothing : flat);
  }
  gl_->Disable(GL_SCISSOR_TEST);
  if (!gradient) return;
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
  gl_->BlitFramebuffer(0, 0, target.size.width, target.size.height, target.left, target.bottom,
                       target.left + target.size.width, target.bottom + target.size.height, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
}

}  // namespace odontoscope
