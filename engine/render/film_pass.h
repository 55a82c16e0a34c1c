#pragma once
// The X-ray film of a model: each ray's length inside each solid, times what a millimetre of its tissue swallows
// (GpuPart::attenuation). The camera is the tube's focus. Of solids alone: a volume's film is engine/raycast's.

#include <optional>

#include "engine/gpu/program.h"
#include "engine/render/frame_plan.h"

namespace odontoscope {

class FilmPass {
 public:
  /// Programs are compiled when they are needed first.
  FilmPass(const Gl& gl, const ShaderLibrary& shaders);

  /// Covers `picture` with greys, beside the film, which hangs at the model's middle, with one. Solids that the scene
  /// does not show let rays through; what the plan's section cuts away does, too. Precondition: surfaces are closed and
  /// wound outwards, and the eye is outside of them.
  void draw(const FramePlan& plan, const GpuModel& model, const Scene& scene, const Framebuffer& picture);

 private:
  struct Programs {
    Program faces, film;
  };
  const Gl* gl_;
  ShaderLibrary shaders_;
  std::optional<Programs> programs_;
  GlObject no_vertices_;
  Framebuffer sums_;
};

/// Is the film of the model wanted, since there is no volume to cast rays through, and is anything known of what it is
/// made of?
bool shows_film_of_model(const Scene& scene, const GpuModel& model);

}  // namespace odontoscope
