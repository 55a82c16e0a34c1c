#pragma once
// Casts rays through a volume: between two depths of every pixel, so that surfaces, caps and lines before, in and behind it are where they are.
//
// A ray runs through the volume's box, half a step of its grid beyond its outermost values, and through what a section leaves; it takes steps of
// GpuVolume::stride from where it enters, each cut off at what the depths say. From one end of a step to the other values are taken to run straight, and the transfer function is
// integrated over them (Engel, Kraus and Ertl, "High-quality pre-integrated volume rendering", 2001), with the colour that their middle has. A step takes a part
// 1 - exp(-extinction * length) of what is left to see (Max, "Optical models for direct volume rendering", IEEE TVCG 1(2), 1995). Projections sample each step in
// its middle. Bricks with nothing to show are passed over, which changes nothing.
// The eye may be inside.

#include <map>

#include "engine/gpu/framebuffer.h"
#include "engine/gpu/program.h"
#include "engine/raycast/gpu_volume.h"

namespace odontoscope {

/// Who looks, at how many samples, and what is cut away.
struct CastView {
  glm::mat4 world_to_eye{1}, eye_to_clip{1};
  bool parallel = false;
  PixelSize size;
  glm::vec4 section{0, 0, 0, 1};   // as in FramePlan
  glm::vec4 lamp{0};               // as in FramePlan
};

/// Textures of window depths of as many pixels as the view has; 0: none.
struct CastDepths {
  GLuint from = 0;     // rays begin behind these; none: at the eye
  GLuint to = 0;       // and end at these
  GLuint opaque = 0;   // and these
};

class VolumePass {
 public:
  /// Programs are compiled when they are needed first.
  VolumePass(const Gl& gl, const ShaderLibrary& shaders);

  /// Blends what lies between the depths under what `picture` holds. Precondition: `volume` is prepared for `look`, whose cast is shaded.
  void draw_between(const CastView& view, const GpuVolume& volume, const VolumeLook& look, const CastDepths& depths, const Framebuffer& picture);

  /// Covers what the box covers with greys, black for nothing. Precondition: look.projects(), `volume` is prepared for it.
  void draw_projection(const CastView& view, const GpuVolume& volume, const VolumeLook& look, const Framebuffer& picture);

  /// The surface of look.iso, into the layer that is bound, with light, ambient light and depth. Precondition as above.
  void draw_surface(const CastView& view, const GpuVolume& volume, const VolumeLook& look);

 private:
  Program& program(VolumeLook::Cast cast);
  void set_view(const Program& program, const CastView& view, const GpuVolume& volume) const;
  void cover() const;
  /// What the picture holds already stays in front.
  void cover_behind(const Framebuffer& picture) const;

  const Gl* gl_;
  ShaderLibrary shaders_;
  std::map<VolumeLook::Cast, Program> programs_;
  GlObject no_vertices_;
};

}  // namespace odontoscope
