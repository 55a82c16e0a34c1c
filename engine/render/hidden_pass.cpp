#include "engine/render/hidden_pass.h"

namespace odontoscope {

GpuHidden upload_hidden(const Gl& gl, std::span<const glm::vec2> corners) {
  GpuHidden hidden{make_vertex_array(gl), make_buffer(gl), static_cast<GLsizei>(corners.size())};
  gl.BindVertexArray(hidden.vertex_array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, hidden.corners.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size_bytes()), corners.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
  gl.EnableVertexAttribArray(0);
  gl.BindVertexArray(0);
  return hidden;
}

HiddenPass::HiddenPass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), program_(gl, shaders, {"hidden.vert", "hidden.frag"}) {}

void HiddenPass::cover(const View& view, const GpuHidden& hidden, Writes writes) const {
  draw(view, hidden, writes, Where::nearest);
}
void HiddenPass::uncover(const View& view, const GpuHidden& hidden) const {
  draw(view, hidden, Writes::depth, Where::farthest);
}

void HiddenPass::draw(const View& view, const GpuHidden& hidden, Writes writes, Where where) const {
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_ALWAYS);
  gl_->DepthMask(GL_TRUE);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_CULL_FACE);
  gl_->Disable(GL_STENCIL_TEST);
  const GLboolean written = writes == Writes::depth_and_colours ? GL_TRUE : GL_FALSE;
  gl_->ColorMask(written, written, written, written);
  program_.use();
  program_.set("eye_to_clip", view.eye_to_clip);
  program_.set("far_away", where == Where::farthest ? 1 : 0);
  gl_->BindVertexArray(hidden.vertex_array.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, hidden.count);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->DepthFunc(GL_LESS);
}

}  // namespace odontoscope
