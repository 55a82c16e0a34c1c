#pragma once
// What lies behind the model, where it is not mixed with anything.

#include "engine/gpu/program.h"
#include "engine/render/resolve_pass.h"
#include "engine/scene/scene.h"

namespace odontoscope {

class BackgroundPass {
 public:
  BackgroundPass(const Gl& gl, const ShaderLibrary& shaders);

  /// Fills the target, which has depth, and leaves it bound. A gradient is drawn once and copied as long as it stays
  /// the same: that takes a driver that draws in software a tenth of the time.
  void fill(const Background& background, const Target& target);

 private:
  void draw_gradient(const Background& background, PixelSize size);

  const Gl* gl_;
  Framebuffer drawn_;
  Background drawn_background_;
  Program gradient_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
