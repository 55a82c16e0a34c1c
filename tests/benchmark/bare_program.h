#pragma once
// The least that draws a lit mesh: one program, one light, one target of 8 bits with depth. What our renderer is
// measured against.

#include "engine/gpu/framebuffer.h"
#include "engine/gpu/program.h"
#include "engine/render/gpu_model.h"
#include "engine/scene/camera.h"

namespace odontoscope {

class BareProgram {
 public:
  BareProgram(const Gl& gl, PixelSize size);
  void draw(const GpuModel& model, const View& view, bool culled) const;

 private:
  const Gl* gl_;
  GlObject program_;
  Framebuffer pixels_;
};

}  // namespace odontoscope
