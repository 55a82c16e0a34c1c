#pragma once
// What one frame draws, worked out from model, scene and view before any pass runs.

#include <vector>

#include "engine/gpu/framebuffer.h"
#include "engine/gpu/program.h"
#include "engine/render/gpu_model.h"
#include "engine/render/gpu_overlay.h"
#include "engine/render/gpu_value_grid.h"
#include "engine/scene/scene.h"

namespace odontoscope {

struct DrawnPart {
  const GpuPart* part = nullptr;
  glm::vec3 colour{0};  // linear
  float opacity = 1;
  bool inside_out = false;  // clockwise is the front
  bool wire = false;        // with its triangles' edges, whatever the frame says
  bool whole = false;       // the section leaves it as it is
};

/// A solid whose section is closed, by all its surfaces, whether they are shown or not.
struct CappedSolid {
  std::vector<const GpuPart*> surfaces;
  glm::vec3 colour{0};  // linear
  double box_volume = 0;
};

struct DrawnLines {
  const GpuLines* lines = nullptr;
  bool whole = false;
};

/// Pixels from the lower left corner; the upper right one lies outside.
struct PixelRectangle {
  glm::ivec2 low{0}, high{0};
};

struct FramePlan {
  View view;
  PixelSize size;          // that the passes draw: the picture's size times `side`
  PixelRectangle touched;  // holds all that is drawn, with a margin: whole pictures are mostly background
  int side = 1;            // samples a pixel along one axis
  std::vector<DrawnPart> opaque;
  std::vector<DrawnPart> translucent;
  std::vector<CappedSolid> capped;           // largest first; empty if the section is off or seen from its far side
  const GpuValueGrid* cap_values = nullptr;  // what the caps show; null: the solids' colours
  bool cap_grain = true;                     // with a texture
  ValueWindow cap_window;
  std::vector<DrawnLines> lines;
  glm::vec4 section{0, 0, 0, 1};  // keeps what has dot(xyz, position) <= w; this one keeps everything
  glm::vec3 centre{0};            // metres
  float radius = 1;
  BackFaces back_faces = BackFaces::cull;
  bool wire = false;
  std::optional<DataColours> data_colours;  // on parts that have deviations
  bool parallel = false;
  bool wall_depth = false;      // on parts that have depths
  bool wall_thickness = false;  // in its place, on parts that have thicknesses
  Occlusion occlusion;
  glm::vec4 lamp{0};  // where the eye's lamp is, metres from the eye, and its reach; reach 0: the studio's lights

  bool cut() const { return section != glm::vec4(0, 0, 0, 1); }
  float occlusion_reach() const { return occlusion.reach * radius; }
};

/// `side` squared is the number of samples a pixel; `overlay` null: none; `values` null: caps show the material.
FramePlan plan_frame(const GpuModel& model, const Scene& scene, const View& view, PixelSize size, int side,
                     const GpuOverlay* overlay = nullptr, const GpuValueGrid* values = nullptr);

/// Makes room in `plan.touched` for a box that is drawn besides the model: metres.
void touch_box(const glm::vec3& low, const glm::vec3& high, FramePlan& plan);

/// Sets the uniforms that every pass over surfaces shares. The program is in use.
void set_view(const Program& program, const FramePlan& plan);

/// The section, or for what stays whole one that keeps everything.
void set_section(const Program& program, const FramePlan& plan, bool whole);

}  // namespace odontoscope
