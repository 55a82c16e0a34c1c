#include "engine/ui/interface_pass.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace odontoscope {

// Any number but that of the letters, which is 0.
void* grey_picture() { return reinterpret_cast<void*>(std::intptr_t{1}); }

InterfacePass::InterfacePass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl),
      program_(gl, shaders, {"interface.vert", "interface.frag"}),
      vertex_array_(make_vertex_array(gl)),
      vertices_(make_buffer(gl)),
      indices_(make_buffer(gl)),
      letters_(make_texture(gl)),
      picture_(make_texture(gl)) {
  gl.BindVertexArray(vertex_array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  const auto place = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), place(offsetof(ImDrawVert, pos)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), place(offsetof(ImDrawVert, uv)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), place(offsetof(ImDrawVert, col)));
  for (GLuint i = 0; i < 3; ++i) gl.EnableVertexAttribArray(i);
  gl.BindVertexArray(0);
}

void InterfacePass::upload_letters(const Interface& interface) {
  if (font_version_ == interface.font_version()) return;
  font_version_ = interface.font_version();
  unsigned char* texels = nullptr;
  int width = 0, height = 0;
  interface.font_atlas().GetTexDataAsAlpha8(&texels, &width, &height);
  gl_->BindTexture(GL_TEXTURE_2D, letters_.id());
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, texels);
}

void InterfacePass::upload(const GreyPicture& picture) {
  gl_->BindTexture(GL_TEXTURE_2D, picture_.id());
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, static_cast<GLsizei>(picture.width), static_cast<GLsizei>(picture.height), 0,
                  GL_RED, GL_UNSIGNED_BYTE, picture.grey.data());
}

void InterfacePass::draw(const Interface& interface, const ImDrawData& drawn, const Target& target,
                         const GreyPicture* picture) {
  gl_->ActiveTexture(GL_TEXTURE0);
  upload_letters(interface);
  if (picture && !picture->grey.empty()) upload(*picture);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_->Viewport(target.left, target.bottom, target.size.width, target.size.height);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Disable(GL_STENCIL_TEST);
  gl_->Enable(GL_BLEND);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->Enable(GL_SCISSOR_TEST);
  program_.use();
  program_.set("letters", 0);
  program_.set("pixels", glm::vec2(target.size.width, target.size.height));
  gl_->BindVertexArray(vertex_array_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  for (int i = 0; i < drawn.CmdListsCount; ++i) {
    const ImDrawList& list = *drawn.CmdLists[i];
    gl_->BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
    gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImVec4& clip = command.ClipRect;
      if (clip.z <= clip.x || clip.w <= clip.y) continue;
      const int left = std::max(static_cast<int>(clip.x), 0), top = std::max(static_cast<int>(clip.y), 0);
      gl_->Scissor(target.left + left, target.bottom + target.size.height - static_cast<int>(clip.w),
                   std::max(static_cast<int>(clip.z) - left, 0), std::max(static_cast<int>(clip.w) - top, 0));
      const bool grey = command.GetTexID() == grey_picture();
      program_.set("grey", grey ? 1.0f : 0.0f);
      gl_->BindTexture(GL_TEXTURE_2D, grey ? picture_.id() : letters_.id());
      constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
      gl_->DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type,
                                  reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                                  static_cast<GLint>(command.VtxOffset));
    }
  }
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_BLEND);
  gl_->BindVertexArray(0);
}

}  // namespace odontoscope
