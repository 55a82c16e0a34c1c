#pragma once
// The last pass: samples to pixels, background, linear light to sRGB.

#include "engine/gpu/program.h"
#include "engine/render/frame_plan.h"

namespace odontoscope {

/// Where a picture goes: part of a framebuffer of 8 bits a channel that does no sRGB encoding of its own.
struct Target {
  GLuint framebuffer = 0;
  int left = 0, bottom = 0;
  PixelSize size;
  /// The framebuffer has a depth buffer that may be used, and whose content is worth nothing before and after. Saves a
  /// copy of the picture.
  bool with_depth = false;
  /// What is nearest at each pixel is to be left in that depth buffer, the background as far as can be.
  bool keep_depth = false;
};

class ResolvePass {
 public:
  ResolvePass(const Gl& gl, const ShaderLibrary& shaders);
  void draw(const FramePlan& plan, const Framebuffer& picture, const Background& background,
            const Target& target) const;

 private:
  const Gl* gl_;
  Program program_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
