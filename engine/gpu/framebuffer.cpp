#include "engine/gpu/framebuffer.h"

#include <fmt/format.h>

#include "engine/gpu/graphics_error.h"

namespace odontoscope {

namespace {

struct Transfer {
  GLenum format, type;
};

/// What goes with an internal format when there is nothing to upload: any legal pair will do.
Transfer transfer_of(GLenum internal_format) {
  switch (internal_format) {
    case GL_DEPTH32F_STENCIL8:
      return {GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV};
    case GL_DEPTH_COMPONENT32F:
      return {GL_DEPTH_COMPONENT, GL_FLOAT};
    case GL_R32F:
    case GL_R8:
      return {GL_RED, GL_FLOAT};
    case GL_RG16F:
    case GL_RG32F:
      return {GL_RG, GL_FLOAT};
    default:
      return {GL_RGBA, GL_FLOAT};
  }
}

GlObject make_attachment(const Gl& gl, GLenum internal_format, PixelSize size) {
  GlObject texture = make_texture(gl);
  const Transfer transfer = transfer_of(internal_format);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), size.width, size.height, 0, transfer.format,
                transfer.type, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

Framebuffer::Framebuffer(const Gl& gl, const Layout& layout) : framebuffer_(make_framebuffer(gl)), size_(layout.size) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  std::vector<GLenum> targets;
  for (const GLenum format : layout.colours) {
    colours_.push_back(make_attachment(gl, format, size_));
    targets.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(targets.size()));
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, targets.back(), GL_TEXTURE_2D, colours_.back().id(), 0);
  }
  if (layout.depth != GL_NONE) {
    depth_ = make_attachment(gl, layout.depth, size_);
    const GLenum point = layout.depth == GL_DEPTH32F_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, depth_.id(), 0);
  }
  gl.DrawBuffers(static_cast<GLsizei>(targets.size()), targets.data());
  if (gl.GetError() == GL_OUT_OF_MEMORY || gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw GraphicsError("out-of-graphics-memory",
                        fmt::format("no framebuffer of {} x {} pixels can be made", size_.width, size_.height),
                        "Ask for a smaller picture or fewer samples.");
}

void Framebuffer::bind() const {
  const Gl& gl = framebuffer_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.Viewport(0, 0, size_.width, size_.height);
}

void Framebuffer::bind_colour(int index, int unit) const {
  const Gl& gl = framebuffer_.gl();
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, colours_[static_cast<std::size_t>(index)].id());
}

}  // namespace odontoscope
