#include "engine/render/layer.h"

namespace odontoscope {

Layer::Layer(const Gl& gl, PixelSize size)
    : gl_(&gl), pixels_(gl, {size, {GL_RGBA16F, GL_RGBA16F, GL_R32F}, GL_DEPTH32F_STENCIL8}) {}

void Layer::begin() const {
  constexpr GLfloat nothing[4] = {0, 0, 0, 0};
  constexpr GLfloat far_away[4] = {1, 1, 1, 1};
  pixels_.bind();
  gl_->DepthMask(GL_TRUE);
  gl_->StencilMask(0xff);
  gl_->ClearBufferfv(GL_COLOR, 0, nothing);
  gl_->ClearBufferfv(GL_COLOR, 1, nothing);
  gl_->ClearBufferfv(GL_COLOR, 2, far_away);
  gl_->ClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
}

}  // namespace odontoscope
