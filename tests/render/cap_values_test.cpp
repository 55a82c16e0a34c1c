// A cap that shows a volume: every pixel is the windowed value of its place, however the plane lies.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

/// Differs along each axis in size, spacing, origin and slope, so that nothing can be mistaken for another.
struct Ramp {
  glm::dvec3 slope{40, -25, 15};
  double at_origin = 1000;
  double at(const glm::dvec3& place) const { return at_origin + glm::dot(slope, place); }
};

Volume ramp_volume(const Ramp& ramp = {}) {
  Volume volume;
  volume.size = {31, 23, 43};
  volume.spacing = {0.4, 0.6, 0.3};
  volume.origin = {-6.1, -6.7, -6.2};
  for (std::size_t k = 0; k < volume.size[2]; ++k)
    for (std::size_t j = 0; j < volume.size[1]; ++j)
      for (std::size_t i = 0; i < volume.size[0]; ++i)
        volume.values.push_back(
            static_cast<float>(ramp.at({-6.1 + 0.4 * static_cast<double>(i), -6.7 + 0.6 * static_cast<double>(j),
                                        -6.2 + 0.3 * static_cast<double>(k)})));
  return volume;
}

/// Not around zero, so that the model's origin counts.
const Point3 low{-4, -3, -4.5}, high{5, 5, 5.5};
Box box_mm() { return {{low.x, low.y, low.z}, {high.x, high.y, high.z}}; }

constexpr PixelSize size{150, 150};
constexpr double height_mm = 15;
constexpr ValueWindow window{500, 1500};

class CapValues : public DrawingTest {
 protected:
  Image draw_values(const Model& model, const Scene& scene, const ValueGrid& grid, int side = 1) {
    Renderer renderer(gl(), ShaderLibrary{});
    const GpuModel gpu_model = upload(gl(), model);
    const GpuValueGrid values = upload(gl(), grid, gpu_model);
    return picture_of(gl(), renderer, gpu_model, model, scene, {.size = size, .render = {.side = side}}, nullptr,
                      &values);
  }

  /// Seen straight along the plane's normal.
  Scene facing(const Model& model, const Section& section) {
    Scene scene = plain_scene(model, height_mm);
    for (Look& look : scene.looks) look.opacity = 1;
    scene.section = section;
    scene.cap = {CapLook::Shows::ct, window};
    const glm::dvec3 normal = glm::normalize(section.normal);
    scene.camera.target = section.point_mm;
    scene.camera.position = section.point_mm + 60.0 * normal;
    scene.camera.up = std::abs(normal.z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    return scene;
  }
};

/// Where a pixel's middle lies on the plane that the parallel camera faces.
glm::dvec3 place_of(const Camera& camera, int x, int y) {
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.position),
                   right = glm::normalize(glm::cross(ahead, camera.up));
  const double pixel = height_mm / size.height;
  return camera.target + pixel * (x + 0.5 - 0.5 * size.width) * right -
         pixel * (y + 0.5 - 0.5 * size.height) * glm::cross(right, ahead);
}

bool well_inside(const glm::dvec3& place) {
  constexpr double margin = 0.2;
  return place.x > low.x + margin && place.x < high.x - margin && place.y > low.y + margin &&
         place.y < high.y - margin && place.z > low.z + margin && place.z < high.z - margin;
}

/// Half a step of the eight bits for rounding, and one for interpolation: half a voxel would be five or more.
constexpr double nearly = 1.6;

struct Judged {
  std::size_t pixels = 0;
  double worst = 0;  // of 255
};

Judged judge(const Image& image, const Camera& camera, const Ramp& ramp) {
  Judged judged;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const glm::dvec3 place = place_of(camera, x, y);
      if (!well_inside(place)) continue;
      const double wanted = 255 * std::clamp((ramp.at(place) - window.low) / (window.high - window.low), 0.0, 1.0);
      ++judged.pixels;
      for (std::size_t channel = 0; channel < 3; ++channel)
        judged.worst = std::max(judged.worst, std::abs(image.pixel(x, y)[channel] - wanted));
    }
  return judged;
}

TEST_F(CapValues, AreThoseOfTheirPlacesHoweverThePlaneLies) {
  const Model model = make_model({{"box", box(low, high)}});
  const ValueGrid grid = value_grid(ramp_volume(), box_mm());
  const Section sections[] = {{{0, 1, 0}, {0, 1, 0}},        {{0, 1, 0}, {0, -1, 0}},      {{0.7, 0, 0}, {1, 0, 0}},
                              {{0.7, 0, 0}, {-1, 0, 0}},     {{0, 0, -1.3}, {0, 0, 1}},    {{0, 0, 2}, {0, 0, -1}},
                              {{0.5, 1, 0.5}, {1, 2, -1.5}}, {{0.5, 1, 0.5}, {-2, 0.3, 1}}};
  for (const Section& section : sections)
    for (const int side : {1, 2}) {
      const Scene scene = facing(model, section);
      const Judged judged = judge(draw_values(model, scene, grid, side), scene.camera, {});
      EXPECT_GT(judged.pixels, 3000u) << section.normal.x << " " << section.normal.y << " " << section.normal.z;
      EXPECT_LT(judged.worst, nearly) << section.normal.x << " " << section.normal.y << " " << section.normal.z;
    }
}

TEST_F(CapValues, AreWhereTheyWereAfterVoxelsWereMerged) {
  const Model model = make_model({{"box", box(low, high)}});
  const ValueGrid grid = value_grid(ramp_volume(), box_mm(), {.most_values = 1500, .longest_side = 12});
  EXPECT_LE(grid.values.size(), 1500u);
  EXPECT_LE(*std::max_element(grid.size.begin(), grid.size.end()), 12u);
  EXPECT_GT(grid.merged[2], 1u);
  const Scene scene = facing(model, {{0.5, 1, 0.5}, {1, 2, -1.5}});
  EXPECT_LT(judge(draw_values(model, scene, grid), scene.camera, {}).worst, nearly);
}

TEST_F(CapValues, AreChangedByNeitherOcclusionNorColour) {
  const Model model = make_model({{"box", box(low, high)}});
  const ValueGrid grid = value_grid(ramp_volume(), box_mm());
  Scene scene = facing(model, {{0, 1, 0}, {0, 1, 0}});
  scene.occlusion = {true, 4, 0.5f};
  scene.looks[0].colour = {1, 0, 0};
  scene.looks[0].opacity = 0.3f;
  EXPECT_LT(judge(draw_values(model, scene, grid), scene.camera, {}).worst, nearly);
}

TEST_F(CapValues, FillACavityThatIsShownAsABody) {
  const Model model = hollow_ball_model();
  Scene scene = facing(model, {{0, 0.5, 0}, {0, 1, 0}});
  Look* cavity = nullptr;
  for (Look& look : scene.looks)
    if (look.structure != "shell") cavity = &look;
  ASSERT_TRUE(cavity);
  const ValueGrid grid = value_grid(ramp_volume(), model.bounds_mm);
  const double wanted = 255 * (Ramp().at({0, 0.5, 0}) - window.low) / (window.high - window.low);
  cavity->as_body = true;
  const Image filled = draw_values(model, scene, grid);
  EXPECT_NEAR(filled.pixel(75, 75)[0], wanted, 4);
  EXPECT_EQ(filled.pixel(75, 75)[0], filled.pixel(75, 75)[2]);
  cavity->as_body = false;
  const Image open = draw_values(model, scene, grid);
  EXPECT_NE(open.pixel(75, 75)[0], open.pixel(75, 75)[2]) << "the void's far wall, in its colour";
  EXPECT_EQ(open.pixel(75 + 35, 75), filled.pixel(75 + 35, 75)) << "in the material";
}

TEST_F(CapValues, AreShownOnlyIfTheSceneSaysSo) {
  const Model model = make_model({{"box", box(low, high)}});
  const ValueGrid grid = value_grid(ramp_volume(), box_mm());
  Scene scene = facing(model, {{0, 1, 0}, {0, 1, 0}});
  scene.cap = {};
  EXPECT_EQ(draw_values(model, scene, grid), draw(model, scene, size));
}

TEST_F(CapValues, FillTheUsualWindowWithoutAnother) {
  const Model model = make_model({{"box", box(low, high)}});
  const ValueGrid grid = value_grid(ramp_volume(), box_mm());
  Scene scene = facing(model, {{0, 1, 0}, {0, 1, 0}});
  scene.cap.window = grid.usual;
  const Image told = draw_values(model, scene, grid);
  scene.cap.window.reset();
  EXPECT_EQ(draw_values(model, scene, grid), told);
}

TEST(ValueGrids, HoldTheVoxelsAroundTheModel) {
  const Ramp ramp;
  const ValueGrid grid = value_grid(ramp_volume(), {{-1, -1, -1}, {1, 1, 1}});
  EXPECT_EQ(grid.merged, (std::array<std::size_t, 3>{1, 1, 1}));
  for (int axis = 0; axis < 3; ++axis) {
    const double last =
        grid.first_mm[axis] + grid.step_mm[axis] * static_cast<double>(grid.size[static_cast<std::size_t>(axis)] - 1);
    constexpr double rounding = 1e-9;
    EXPECT_LE(grid.first_mm[axis], -1 - grid.step_mm[axis] + rounding);
    EXPECT_GE(last, 1 + grid.step_mm[axis] - rounding);
    EXPECT_LT(last - grid.first_mm[axis], 2 + 5 * grid.step_mm[axis]);
  }
  EXPECT_NEAR(static_cast<double>(grid.values.front()), ramp.at(grid.first_mm), 1e-3);
}

TEST(ValueGrids, LeaveAFewOutliersOutOfTheUsualWindow) {
  Volume volume = ramp_volume();
  volume.values[volume.values.size() / 2] = 1e6f;
  const ValueGrid grid = value_grid(volume, {{-9, -9, -9}, {9, 9, 9}});
  EXPECT_EQ(grid.range.high, 1e6);
  EXPECT_LT(grid.usual.high, 2000);
  std::fill(volume.values.begin(), volume.values.end(), 7.0f);
  EXPECT_TRUE(value_grid(volume, box_mm()).usual.sensible()) << "a window has a width even if all values are equal";
}

}  // namespace
}  // namespace odontoscope::testing_support
