#pragma once
// What is nearest at each pixel, left in the target's depth buffer for whoever shows the picture.

#include "engine/gpu/program.h"
#include "engine/render/layer.h"
#include "engine/render/resolve_pass.h"

namespace odontoscope {

class DepthPass {
 public:
  DepthPass(const Gl& gl, const ShaderLibrary& shaders);

  /// `first` null: there is no translucent layer. Precondition: the target has depth.
  void draw(const FramePlan& plan, const Layer& opaque, const Layer* first, const Target& target) const;

 private:
  const Gl* gl_;
  Program program_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
