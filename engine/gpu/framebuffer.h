#pragma once
// A picture to draw into: colour textures and, if wanted, depth and stencil.

#include <vector>

#include "engine/gpu/gl_object.h"

namespace odontoscope {

struct PixelSize {
  int width = 0, height = 0;
  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

class Framebuffer {
 public:
  struct Layout {
    PixelSize size;
    std::vector<GLenum> colours;  // internal formats of the colour attachments, e.g. GL_RGBA16F
    GLenum depth = GL_NONE;       // GL_NONE, GL_DEPTH_COMPONENT32F or GL_DEPTH32F_STENCIL8
  };

  Framebuffer() = default;
  /// Textures are filtered by nearest and clamped to the edge. Throws GraphicsError if the driver cannot.
  Framebuffer(const Gl& gl, const Layout& layout);

  /// Draw into all of it.
  void bind() const;
  /// Make colour attachment `index` the texture of unit `unit`.
  void bind_colour(int index, int unit) const;
  GLuint colour(int index) const { return colours_[static_cast<std::size_t>(index)].id(); }
  GLuint id() const { return framebuffer_.id(); }
  PixelSize size() const { return size_; }

 private:
  GlObject framebuffer_;
  std::vector<GlObject> colours_;
  GlObject depth_;
  PixelSize size_;
};

}  // namespace odontoscope
