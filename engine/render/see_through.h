#pragma once
// How much of a model one sees through, from all around: what misoriented triangles and cracks cost, in pixels.

#include <cstddef>
#include <span>
#include <vector>

#include "engine/gpu/gl.h"
#include "engine/gpu/shader_library.h"
#include "engine/scene/model.h"

namespace odontoscope {

struct SeeThroughOptions {
  std::size_t cameras = 50;  // spread evenly over the sphere
  int side = 240;            // pixels of each square picture
  /// Pixels nearer than this to the rim of the closed silhouette do not count: so far may the two models' outlines lie
  /// apart.
  double rim_mm = 0;
};

struct SeeThrough {
  std::size_t cameras = 0;
  std::size_t inside = 0;     // pixels well within the silhouette of the closed model, in all pictures
  std::size_t culled = 0;     // of these: with back faces left out, the nearest wall is missing, so that one looks into
                              // the model or through it
  std::size_t two_sided = 0;  // of these: with both sides drawn, nothing at all is there

  double culled_share() const { return inside > 0 ? static_cast<double>(culled) / static_cast<double>(inside) : 0; }
  double two_sided_share() const {
    return inside > 0 ? static_cast<double>(two_sided) / static_cast<double>(inside) : 0;
  }
};

/// One for each of `judged`. `closed` says where there is surface; all are in the same coordinates. All structures
/// count, as if opaque. A context is current. One sample a pixel: a crack narrower than a pixel is seen as often as a
/// pixel's centre falls into it.
std::vector<SeeThrough> see_through(const Gl& gl, const ShaderLibrary& shaders, const Model& closed,
                                    std::span<const Model> judged, const SeeThroughOptions& options = {});

}  // namespace odontoscope
