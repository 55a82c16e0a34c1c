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

  /// What is written where nothing is to be seen: depth alone, or colours too, of a layer, which is empty there then.
  enum class Writes { depth, depth_and_colours };
  /// Puts it before everything, in the framebuffer that is bound.
  void cover(const View& view, const GpuHidden& hidden, Writes writes) const;
  /// Puts it as far away as the background, once all is drawn; colours stay.
  void uncover(const View& view, const GpuHidden& hidden) const;

 private:
  enum class Where { nearest, farthest };
  void draw(const View& view, const GpuHidden& hidden, Writes writes, Where where) const;

  const Gl* gl_;
  Program program_;
};

}  // namespace odontoscope
