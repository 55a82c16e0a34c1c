#pragma once
// Which way the surfaces face that cover a pixel: proof of culling by pixels.
//
// Along a line of sight from a point outside a closed, oriented surface to infinity, fronts and backs alternate in
// pairs: as many fronts as backs, and the nearest is a front. The rasteriser keeps this exactly, since it draws a
// shared edge once, even after it has rounded the vertices: the rounded surface is still closed. So one flipped or
// missing triangle shows at every pixel that it covers.

#include <cstdint>
#include <vector>

#include "engine/gpu/shader_library.h"
#include "engine/render/frame_plan.h"

namespace odontoscope {

/// For each pixel, rows from the bottom.
struct FaceCounts {
  PixelSize size;
  std::vector<std::uint32_t> front, back;      // faces that cover it, by winding
  std::vector<float> front_depth, back_depth;  // window depth of the nearest; 1 where there is none
};

class FaceCounter {
 public:
  FaceCounter(const Gl& gl, const ShaderLibrary& shaders);
  /// Counts the faces of all visible structures, translucent or not, section included but not capped. One sample a
  /// pixel.
  FaceCounts count(const GpuModel& model, const Scene& scene, const View& view, PixelSize size) const;

 private:
  const Gl* gl_;
  Program votes_, depths_;
};

/// Is the nearest face at this pixel a back? No ties (see judge).
bool back_is_nearest(const FaceCounts& counts, int x, int y);

struct FaceVerdict {
  std::size_t covered = 0;     // pixels
  std::size_t outline = 0;     // covered pixels with an uncovered one beside, above or below: where most ties are
  std::size_t unbalanced = 0;  // with more fronts than backs or the reverse
  /// Pixels whose nearest face is a back, split: `ties` lie on a silhouette or crease, where front and back meet (see
  /// judge).
  std::size_t back_nearest = 0;
  std::size_t ties = 0;
};

/// A pixel whose nearest face is a back is a tie if its faces balance and a front follows no farther behind
/// than the depths of its eight neighbours differ: then the two meet within the pixel and rounding chose. Precondition:
/// the eye is outside.
FaceVerdict judge(const FaceCounts& counts);

}  // namespace odontoscope
