#pragma once
// Lays one layer under those composed before it, front to back.

#include "engine/gpu/program.h"
#include "engine/render/frame_plan.h"
#include "engine/render/layer.h"

namespace odontoscope {

class ComposePass {
 public:
  ComposePass(const Gl& gl, const ShaderLibrary& shaders);

  /// `occlusion` null: ambient light is not darkened. `picture` is premultiplied, linear, GL_RGBA16F.
  void draw(const FramePlan& plan, const Layer& layer, const Framebuffer* occlusion, const Framebuffer& picture) const;

 private:
  const Gl* gl_;
  Program program_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
