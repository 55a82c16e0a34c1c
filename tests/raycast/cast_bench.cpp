#include "tests/raycast/cast_bench.h"

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>

#include "tests/radiograph/solids.h"

namespace odontoscope::test {

Volume lumps() {
  Volume volume;
  volume.size = {34, 26, 45};
  volume.spacing = {0.4, 0.5, 0.3};
  volume.origin = {-6.6, -6.2, -6.5};
  const auto lump = [](const glm::dvec3& place, const glm::dvec3& centre, const glm::dvec3& radii) {
    const glm::dvec3 way = (place - centre) / radii;
    return std::exp(-glm::dot(way, way));
  };
  for (std::size_t k = 0; k < volume.size[2]; ++k)
    for (std::size_t j = 0; j < volume.size[1]; ++j)
      for (std::size_t i = 0; i < volume.size[0]; ++i) {
        const glm::dvec3 place =
            glm::dvec3(volume.origin.x, volume.origin.y, volume.origin.z) +
            glm::dvec3(0.4 * static_cast<double>(i), 0.5 * static_cast<double>(j), 0.3 * static_cast<double>(k));
        const double value = 260 * lump(place, {0.4, 0.2, -0.5}, {2.1, 1.6, 2.4}) +
                             180 * lump(place, {-2.8, -2.4, 3.1}, {1.0, 1.3, 0.9}) - 12;
        volume.values.push_back(static_cast<float>(std::max(value, 0.0)));
      }
  return volume;
}

ValueGrid whole(const Volume& volume) { return value_grid(volume, {{-1e3, -1e3, -1e3}, {1e3, 1e3, 1e3}}); }

VolumeLook shaded_look() {
  VolumeLook look;
  look.shows = VolumeLook::Shows::volume;
  look.transfer = {{20, colour_of(0x803010), 0},
                   {60, colour_of(0xa05020), 0.5},
                   {110, colour_of(0x208040), 0.15},
                   {150, colour_of(0x304090), 0.4},
                   {230, colour_of(0xb0b0a0), 1.5}};
  look.lit = false;
  return look;
}

std::vector<NamedCamera> cameras() {
  const Camera parallel{Camera::Projection::parallel, {21, 33, 17}, {0.3, -0.2, 0.1}, {0.1, 0, 1}, 24, 15};
  const Camera outside{Camera::Projection::perspective, {-14, 20, 9}, {0, 0, 0}, {0, 0.1, 1}, 36, 25};
  const Camera inside{Camera::Projection::perspective, {0.9, 0.7, -0.3}, {-2.8, -2.4, 3.1}, {0, 0.1, 1}, 70, 25, 0.01};
  return {{"Parallel", parallel}, {"Outside", outside}, {"Inside", inside}};
}

void write_edited_shaders(const std::vector<ShaderEdit>& edits, const std::string& folder) {
  for (const EmbeddedFile& shader : embedded_shaders()) {
    std::string text(shader.bytes);
    for (const ShaderEdit& edit : edits) {
      if (edit.shader != shader.name) continue;
      const std::size_t at = text.find(edit.from);
      ASSERT_NE(at, std::string::npos) << edit.from;
      text.replace(at, edit.from.size(), edit.to);
    }
    std::ofstream(folder + "/" + std::string(shader.name)) << text;
  }
}

Image cast_with(const Gl& gl, const Model& model, const ValueGrid& grid, const Scene& scene,
                const ShaderLibrary& shaders, PixelSize size, const RenderOptions& options, float coarseness) {
  Renderer renderer(gl, shaders);
  const GpuModel gpu_model = upload(gl, model);
  const GpuValueGrid values = upload(gl, grid, gpu_model);
  GpuVolume volume(gl, grid, values.field());
  volume.set_coarseness(coarseness);
  return picture_of(gl, renderer, gpu_model, model, scene, {.size = size, .render = options}, nullptr, &values,
                    &volume);
}

Scene CastTest::scene_of(const Model& model, const Camera& camera, const VolumeLook& look) {
  Scene scene = usual_scene(model, 1);
  scene.camera = camera;
  scene.occlusion.on = false;
  scene.background = {Background::Kind::plain, {0, 0, 0}, {0, 0, 0}};
  scene.volume = look;
  return scene;
}

Model CastTest::box_model(const ValueGrid& grid) {
  const glm::dvec3 low = grid.first_mm,
                   high = low + grid.step_mm * (glm::dvec3(grid.size[0], grid.size[1], grid.size[2]) - 1.0);
  return make_model({{"box", block({low.x, low.y, low.z}, {high.x, high.y, high.z})}});
}

}  // namespace odontoscope::test
