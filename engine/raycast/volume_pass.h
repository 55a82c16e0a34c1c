#pragma once
// Casts rays through a volume: between two depths of every pixel, so that surfaces, caps and lines before, in and
// behind it are where they are.
//
// A ray runs through the volume's box, half a step of its grid beyond its outermost values, and through what a section
// leaves; it takes steps of GpuVolume::stride from where it enters, each cut off at what the depths say. From one end
// of a step to the other values are taken to run straight, and the transfer function is integrated over them (Engel,
// Kraus and Ertl, "High-quality pre-integrated volume rendering", 2001): extinction, and colour in proportion to it. A
// step takes a part 1 - exp(-extinction * length) of what is left to see (Max, "Optical models for direct volume
// rendering", IEEE TVCG 1(2), 1995). Projections sample each step in its middle. Bricks with nothing to show are passed
// over, which changes nothing. The eye may be inside.
//
// Where a voxel covers several samples of the picture, rays are cast some samples apart first, then between those only
// that saw things unlike (by more than `alike`) or have a surface's edge between them; elsewhere what they saw is
// interpolated.

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/gpu/framebuffer.h"
#include "engine/gpu/program.h"
#include "engine/raycast/gpu_volume.h"

namespace odontoscope {

/// Who looks, at how many samples, and what is cut away.
struct CastView {
  glm::mat4 world_to_eye{1}, eye_to_clip{1};
  bool parallel = false;
  PixelSize size;
  glm::vec4 section{0, 0, 0, 1};               // as in FramePlan
  glm::vec4 lamp{0};                           // as in FramePlan
  glm::ivec2 touched_low{0}, touched_high{0};  // as in FramePlan: elsewhere nothing is cast
  bool every_ray = false;                      // through every sample, however alike its neighbours are
  glm::vec3 film_centre{0, 0, -1};             // of a radiograph, in eye space: before the eye
};

/// How far what rays in a row saw may stray from a straight run, of 1 as a screen shows it, if others between them are
/// interpolated; by twice as much they may differ. The first is for the last rays; what is told between others passes
/// on what it is off by to more samples.
inline constexpr float alike = 8.0f / 255, alike_far_apart = 3.0f / 255;

/// How many samples apart rays are cast, the coarsest first; each a multiple of the next, the last 1. No two of the
/// first are further apart than the grid's values.
std::vector<int> ray_distances(const CastView& view, const GpuVolume& volume);

/// Textures of window depths of as many pixels as the view has; 0: none.
struct CastDepths {
  GLuint from = 0;    // rays begin behind these; none: at the eye
  GLuint to = 0;      // and end at these
  GLuint opaque = 0;  // and these
  bool any = true;    // false: there is nothing in them
};

class VolumePass {
 public:
  /// Programs are compiled when they are needed first.
  VolumePass(const Gl& gl, const ShaderLibrary& shaders);

  /// Blends what lies between the depths under what `picture` holds, which has a depth buffer for the pass's own use.
  /// Precondition: `volume` is prepared for `look`, whose cast is shaded.
  void draw_between(const CastView& view, const GpuVolume& volume, const VolumeLook& look, const CastDepths& depths,
                    const Framebuffer& picture);

  /// Covers what the box covers with greys, black for nothing; of a radiograph all that may be touched, what lies
  /// beside look.film_mm in one grey. Precondition: look.projects(), `volume` is prepared for it.
  void draw_projection(const CastView& view, const GpuVolume& volume, const VolumeLook& look,
                       const Framebuffer& picture);

  /// The surface of look.iso, into the layer that is bound, with light, ambient light and depth. Precondition as above.
  void draw_surface(const CastView& view, const GpuVolume& volume, const VolumeLook& look);

 private:
  Program& program(const VolumeLook& look);
  Program& program(const char* fragment);
  void set_view(const Program& program, const CastView& view, const GpuVolume& volume) const;
  /// What rays may end at: nothing, since a projection's never do; surfaces; or nothing of a shaded volume.
  enum class Among { greys, surfaces, nothing };
  void cover() const;
  /// What the picture holds already stays in front. `cast` is in use.
  void cover_behind(const Program& cast, const CastView& view, const GpuVolume& volume, Among among,
                    const Framebuffer& picture);
  /// What rays so many samples apart saw, and between which of them others are told by them.
  struct Coarse {
    Framebuffer seen, alike;
  };
  const Coarse& coarse_for(int apart, PixelSize size);
  void judge(const CastView& view, const GpuVolume& volume, Among among, int apart, bool last);
  /// Fills in what others tell; leaves depths by which only the rest passes.
  void tell(int apart, int coarser);

  const Gl* gl_;
  ShaderLibrary shaders_;
  std::map<std::pair<VolumeLook::Cast, bool>, Program> programs_;  // by whether slopes count
  GlObject no_vertices_;
  std::map<std::string_view, Program> between_;
  std::map<int, Coarse> coarse_;
};

}  // namespace odontoscope
