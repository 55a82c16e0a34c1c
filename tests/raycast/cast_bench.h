#pragma once
// Fields, cameras and shaders for tests that cast rays.

#include <ostream>
#include <string>
#include <vector>

#include "tests/raycast/reference.h"
#include "tests/render/drawing.h"

namespace odontoscope::test {

/// Differs along each axis in size, spacing and shape; two lumps in nothing, so that most of it is empty; no plane of
/// symmetry.
Volume lumps();
ValueGrid whole(const Volume& volume);

/// Light, colours and extinctions of which none is another's.
VolumeLook shaded_look();

struct NamedCamera {
  const char* name;
  Camera camera;
  friend void PrintTo(const NamedCamera& named, std::ostream* to) { *to << named.name; }
};
/// Parallel and aslant; from outside; from within the larger lump.
std::vector<NamedCamera> cameras();

/// The embedded shaders with some text changed; each must be found.
struct ShaderEdit {
  std::string shader, from, to;
};
void write_edited_shaders(const std::vector<ShaderEdit>& edits, const std::string& folder);

inline constexpr RenderOptions one_ray_a_pixel{.side = 1};

/// In the context that is current. `shaders` may be a folder of edited ones.
Image cast_with(const Gl& gl, const Model& model, const ValueGrid& grid, const Scene& scene,
                const ShaderLibrary& shaders, PixelSize size, const RenderOptions& options = one_ray_a_pixel,
                float coarseness = 1);

class CastTest : public testing_support::DrawingTest {
 protected:
  Image cast(const Model& model, const ValueGrid& grid, const Scene& scene, const ShaderLibrary& shaders = {},
             PixelSize size = picture, const RenderOptions& options = one_ray_a_pixel) {
    return cast_with(gl(), model, grid, scene, shaders, size, options);
  }
  /// Black behind, no occlusion.
  static Scene scene_of(const Model& model, const Camera& camera, const VolumeLook& look);
  /// The box of the grid, for a model that is not shown.
  static Model box_model(const ValueGrid& grid);

  static constexpr PixelSize picture{100, 100};
};

}  // namespace odontoscope::test
