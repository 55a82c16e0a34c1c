#pragma once
// Screen-space ambient occlusion of one layer; see shaders/occlusion.frag.

#include "engine/gpu/program.h"
#include "engine/render/frame_plan.h"
#include "engine/render/layer.h"

namespace odontoscope {

class OcclusionPass {
 public:
  OcclusionPass(const Gl& gl, const ShaderLibrary& shaders);

  /// Fills `occlusion` (GL_RG32F: light let through, distance from the eye in metres) from the layer's depths.
  void draw(const FramePlan& plan, const Layer& layer, const Framebuffer& occlusion) const;

 private:
  const Gl* gl_;
  Program program_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
