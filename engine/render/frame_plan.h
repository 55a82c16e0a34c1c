#pragma once
// What one frame draws, worked out from model, scene and view before any pass runs.

#include <vector>

#include "engine/gpu/framebuffer.h"
#include "engine/gpu/program.h"
#include "engine/render/gpu_model.h"
#include "engine/scene/scene.h"

namespace odontoscope {

struct DrawnPart {
  const GpuPart* part = nullptr;
  glm::vec3 colour{0};     // linear
  float opacity = 1;
  bool inside_out = false; // clockwise is the front
};

/// A solid whose section is closed, by all its surfaces, whether they are shown or not.
struct CappedSolid {
  std::vector<const GpuPart*> surfaces;
  glm::vec3 colour{0};     // linear
  double box_volume = 0;
};

struct FramePlan {
  View view;
  PixelSize size;                       // that the passes draw: the picture's size times `side`
  int side = 1;                         // samples a pixel along one axis
  std::vector<DrawnPart> opaque;
  std::vector<DrawnPart> translucent;
  std::vector<CappedSolid> capped;       // largest first; empty if the section is off or seen from its far side
  glm::vec4 section{0, 0, 0, 1};        // keeps what has dot(xyz, position) <= w; this one keeps everything
  glm::vec3 centre{0};                  // metres
  float radius = 1;
  BackFaces back_faces = BackFaces::cull;
  bool wire = false;
  bool parallel = false;
  Occlusion occlusion;

  float occlusion_reach() const { return occlusion.reach * radius; }
};

/// `side` squared is the number of samples a pixel.
FramePlan plan_frame(const GpuModel& model, const Scene& scene, const View& view, PixelSize size, int side);

/// Sets the uniforms that every pass over surfaces shares. The program is in use.
void set_view(const Program& program, const FramePlan& plan);

}  // namespace odontoscope
