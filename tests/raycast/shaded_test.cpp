// Shaded volumes: what slopes leave of them, against the processor; light, against finer steps.

#include <algorithm>
#include <cmath>

#include "tests/output/temporary_folder.h"
#include "tests/raycast/cast_bench.h"

namespace odontoscope::test {
namespace {

class Shaded : public CastTest, public ::testing::WithParamInterface<NamedCamera> {
 protected:
  static constexpr PixelSize picture{40, 40};
  ValueGrid grid = whole(lumps());
  Model model = box_model(grid);

  Scene scene(const VolumeLook& look) const { return scene_of(model, GetParam().camera, look); }

  Image drawn(const VolumeLook& look, const std::vector<ShaderEdit>& edits = {}, float coarseness = 1) {
    const testing_support::TemporaryFolder folder;
    write_edited_shaders(edits, folder.path().string());
    return cast_with(gl(), model, grid, scene(look), {folder.path()}, picture, one_ray_a_pixel, coarseness);
  }

  /// As a screen shows it, 0 to 255, pixel by pixel.
  std::vector<glm::dvec3> integral(const VolumeLook& look) {
    constexpr double nearly_none = 4;  // steps in place of one
    std::vector<glm::dvec3> shown;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const Ray ray = ray_through(scene(look).camera, picture, x, y);
        const glm::dvec3 light =
            shaded(grid, look, ray, span_of(ray, grid, std::nullopt), ray.begin, 1e9, nearly_none).light;
        shown.emplace_back(encoded(light.x), encoded(light.y), encoded(light.z));
      }
    return shown;
  }

  static double off(const std::vector<glm::dvec3>& integral, const Image& image) {
    double worst = 0;
    for (std::size_t i = 0; i < integral.size(); ++i)
      for (int channel = 0; channel < 3; ++channel)
        worst = std::max(worst, std::abs(integral[i][channel] - image.rgba[4 * i + static_cast<std::size_t>(channel)]));
    return worst;
  }

  static double unlike(const Image& one, const Image& other) {
    double worst = 0;
    for (int y = 0; y < one.height; ++y)
      for (int x = 0; x < one.width; ++x)
        for (std::size_t channel = 0; channel < 3; ++channel)
          worst = std::max<double>(worst, std::abs(one.pixel(x, y)[channel] - other.pixel(x, y)[channel]));
    return worst;
  }
};

/// Pixels of two pictures that differ by more than two levels.
int pixels_off(const Image& one, const Image& other) {
  int pixels = 0;
  for (std::size_t i = 0; i < one.rgba.size(); i += 4)
    pixels += std::abs(one.rgba[i] - other.rgba[i]) > 2 || std::abs(one.rgba[i + 1] - other.rgba[i + 1]) > 2 ||
              std::abs(one.rgba[i + 2] - other.rgba[i + 2]) > 2;
  return pixels;
}
constexpr int seen_at_most = 20;  // of 1600, where light turns its back within a step

VolumeLook by_slope() {
  VolumeLook look = shaded_look();
  for (TransferPoint& point : look.transfer) point.extinction *= 2;
  look.slopes = {25, 70};
  return look;
}

TEST_P(Shaded, BySlopeIsThatOfTheIntegral) {
  const std::vector<glm::dvec3> right = integral(by_slope());
  EXPECT_LT(off(right, drawn(by_slope())), 2);
  VolumeLook however_flat = by_slope();
  however_flat.slopes = {};
  EXPECT_GT(unlike(drawn(by_slope()), drawn(however_flat)), 5);
  for (const ShaderEdit& edit :
       {ShaderEdit{"volume.frag", "(length(falling(place)) - slopes.x)", "length(falling(place))"},
        {"volume.frag", "- slopes.x) / (slopes.y - slopes.x)", "- slopes.x) / slopes.y"},
        {"volume_ray.glsl", "const float aside = 0.6;", "const float aside = 2.0;"},
        {"volume.frag", "mean.a * share_by_slope(place_at(ray, 0.5 * (near + far)))", "mean.a"}})
    EXPECT_GT(off(right, drawn(by_slope(), {edit})), 3) << edit.to;
}

// Also what is so thin that only much of it is seen, and what lies behind much. From within, where a step covers much
// of the picture, they may differ.
TEST_P(Shaded, LightIsThatOfFinerSteps) {
  if (GetParam().camera.near_mm > 0) return;
  VolumeLook look = shaded_look();
  look.lit = true;
  const Image fine = drawn(look, {}, 0.1f);
  EXPECT_LE(pixels_off(drawn(look), fine), seen_at_most);
  EXPECT_LE(pixels_off(drawn(look, {}, 0.4f), fine), seen_at_most / 4);
  const ShaderEdit thin_is_unlit{"volume.frag", "if (parts > 0.0) light += parts * lit_colour",
                                 "if (parts <= 0.02) light += colours; else light += parts * lit_colour"};
  EXPECT_GT(pixels_off(drawn(look, {thin_is_unlit}), drawn(look, {thin_is_unlit}, 0.1f)), 4 * seen_at_most);
}

INSTANTIATE_TEST_SUITE_P(From, Shaded, ::testing::ValuesIn(cameras()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace odontoscope::test
