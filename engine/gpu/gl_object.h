#pragma once
// Owners of OpenGL names: moved, never copied, deleted with their owner while the context is current (see gl.h).

#include <cstddef>
#include <utility>

#include "engine/gpu/gl.h"

namespace odontoscope {

class GlObject {
 public:
  using Delete = void (*)(const Gl&, GLuint);

  GlObject() = default;
  GlObject(const Gl& gl, GLuint id, Delete destroy) : gl_(&gl), id_(id), destroy_(destroy) {}
  GlObject(GlObject&& other) noexcept { swap(other); }
  GlObject& operator=(GlObject&& other) noexcept {
    swap(other);
    return *this;
  }
  ~GlObject() {
    if (id_ != 0) destroy_(*gl_, id_);
  }

  GLuint id() const { return id_; }
  const Gl& gl() const { return *gl_; }

 private:
  void swap(GlObject& other) {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    std::swap(destroy_, other.destroy_);
  }
  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
  Delete destroy_ = nullptr;
};

GlObject make_buffer(const Gl& gl);
GlObject make_vertex_array(const Gl& gl);
GlObject make_texture(const Gl& gl);
GlObject make_framebuffer(const Gl& gl);

}  // namespace odontoscope
