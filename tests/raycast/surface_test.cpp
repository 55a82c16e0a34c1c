// The raw surface of one value: its depth is where the values along the ray cross it.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/output/temporary_folder.h"
#include "tests/raycast/cast_bench.h"

namespace odontoscope::test {
namespace {

class RawSurface : public CastTest, public ::testing::WithParamInterface<NamedCamera> {
 protected:
  static constexpr PixelSize picture{60, 60};

  /// Window depths, rows from the top.
  std::vector<float> depths(const Model& model, const ValueGrid& grid, const Scene& scene,
                            const ShaderLibrary& shaders) {
    Renderer renderer(gl(), shaders);
    const GpuModel gpu_model = upload(gl(), model);
    const GpuValueGrid values = upload(gl(), grid, gpu_model);
    GpuVolume volume(gl(), grid, values.field());
    const Framebuffer pixels(gl(), {picture, {GL_RGBA8}, GL_DEPTH_COMPONENT32F});
    const Pane pane{view_of(scene.camera, model, 1), {pixels.id(), 0, 0, picture, true, true}};
    renderer.draw(gpu_model, scene, {&pane, 1}, {.side = 1}, nullptr, &values, &volume);
    std::vector<float> read(static_cast<std::size_t>(picture.width * picture.height)), turned;
    gl().BindFramebuffer(GL_FRAMEBUFFER, pixels.id());
    gl().ReadPixels(0, 0, picture.width, picture.height, GL_DEPTH_COMPONENT, GL_FLOAT, read.data());
    for (int y = picture.height; y-- > 0;)
      turned.insert(turned.end(), read.begin() + y * picture.width, read.begin() + (y + 1) * picture.width);
    return turned;
  }

  struct Judged {
    double worst = 0;  // mm along the ray
    int hit = 0, disagreeing = 0;
  };
  Judged judged(const std::optional<Section>& section, const ShaderLibrary& shaders = {}) {
    const ValueGrid grid = whole(lumps());
    const Model model = box_model(grid);
    VolumeLook look;
    look.shows = VolumeLook::Shows::volume;
    look.cast = VolumeLook::Cast::surface;
    look.iso = 90;
    Scene scene = scene_of(model, GetParam().camera, look);
    scene.section = section;
    const std::vector<float> found = depths(model, grid, scene, shaders);
    const View view = view_of(scene.camera, model, 1);
    const glm::dmat4 back = glm::inverse(glm::dmat4(view.eye_to_clip) * glm::dmat4(view.world_to_eye));
    Judged judged;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const float depth = found[static_cast<std::size_t>(y * picture.width + x)];
        const Ray ray = ray_through(scene.camera, picture, x, y);
        const auto right = crossing(grid, look, ray, span_of(ray, grid, section));
        if (right.has_value() != (depth < 1)) {
          ++judged.disagreeing;
          continue;
        }
        if (!right) continue;
        ++judged.hit;
        glm::dvec4 place = back * glm::dvec4(2 * (x + 0.5) / picture.width - 1, 1 - 2 * (y + 0.5) / picture.height,
                                             2 * static_cast<double>(depth) - 1, 1);
        const glm::dvec3 mm = model.origin_mm + glm::dvec3(place) / place.w / metres_per_mm;
        judged.worst = std::max(judged.worst, std::abs(glm::dot(mm - ray.origin, ray.direction) - *right));
      }
    return judged;
  }
};

/// A hundredth of the smallest distance of two values: what is drawn halves a step of half that distance twelve times,
/// the rest is single precision.
constexpr double nearly_mm = 0.003;
/// Rays that graze the surface between two steps.
constexpr int grazing = 2;

const Section cut{{0.3, 0.2, 0.2}, glm::normalize(glm::dvec3(-0.3, 1, 0.4))};

TEST_P(RawSurface, LiesWhereTheValuesCross) {
  for (const std::optional<Section>& section : {std::optional<Section>(), std::optional(cut)}) {
    const Judged found = judged(section);
    EXPECT_GT(found.hit, 150);
    EXPECT_LE(found.disagreeing, grazing);
    EXPECT_LT(found.worst, nearly_mm);
  }
}

TEST_P(RawSurface, HasMutantsThatAreNoticed) {
  const ShaderEdit edits[] = {
      {"volume_surface.frag", "halving < 12", "halving < 3"},
      {"volume_surface.frag", "0.5 * clip.z / clip.w + 0.5", "0.5 * clip.z / clip.w + 0.501"},
      {"volume_ray.glsl", " - ray.begin) / stride, 1e8)))", " - ray.begin) / stride, 1e8)) + 12.0)"},
      {"volume_ray.glsl", "clip(dot(section.xyz, origin), dot(section.xyz, direction), -endless, section.w, ray);",
       ""}};
  for (const ShaderEdit& edit : edits) {
    if (GetParam().camera.near_mm > 0 && edit.to.find("12.0") != std::string::npos)
      continue;  // from within the lump no empty brick is met first
    const testing_support::TemporaryFolder folder;
    write_edited_shaders({edit}, folder.path().string());
    const auto noticed = [&](const std::optional<Section>& section) {
      const Judged found = judged(section, {folder.path()});
      return found.worst > 2 * nearly_mm || found.disagreeing > 10 * grazing;
    };
    EXPECT_TRUE(noticed(std::nullopt) || noticed(cut)) << edit.to;
  }
}

INSTANTIATE_TEST_SUITE_P(From, RawSurface, ::testing::ValuesIn(cameras()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace odontoscope::test
