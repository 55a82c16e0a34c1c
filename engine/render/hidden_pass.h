#pragma once
// The part of an eye's picture that the lenses of a headset hide: nothing is drawn there, and no time spent on it.

#include <span>

#include "engine/gpu/program.h"
#include "engine/scene/camera.h"

namespace odontoscope {

/// Triangles in tangents from the line of sight, in the graphics processor's memory.
struct GpuHidden {
  GlObject vertex_array, corners;
  GLsizei count = 0;
};

GpuHidden upload_hidden(const Gl& gl, std::span<const glm::vec2> corners);

class HiddenPass {
 public:
  HiddenPass(const Gl& gl, const ShaderLibrary& shaders);

  /// Puts it before everything, in the framebuffer that is bound; `colours`: which is a layer, and is empty there then.
  void cover(const View& view, const GpuHidden& hidden, bool colours) const;
  /// Puts it as far away as the background, once all is drawn; colours stay.
  void uncover(const View& view, const GpuHidden& hidden) const;

 private:
  void draw(const View& view, const GpuHidden& hidden, bool colours, bool far_away) const;

  const Gl* gl_;
  Program program_;
};

}  // namespace odontoscope
