#pragma once
// An overlay in the graphics processor's memory. Uploading never compiles a shader.

#include <string>
#include <vector>

#include "engine/render/gpu_model.h"
#include "engine/scene/overlay.h"

namespace odontoscope {

struct GpuLines {
  LineKind kind = LineKind::contour;
  std::string structure;
  GlObject vertex_array, ends;  // an instance a line: its two ends
  GLsizei count = 0;

  /// Each line as a strip of four vertices.
  void draw() const;
};

struct GpuOverlay {
  std::vector<GpuLines> lines;  // those with at least one line
  std::vector<GpuPart> slab;
};

GpuOverlay upload(const Gl& gl, const Overlay& overlay);

}  // namespace odontoscope
