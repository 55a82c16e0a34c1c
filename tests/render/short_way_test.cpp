// What needs no layers is drawn the short way, and must look as if it had gone the long one.

#include "engine/picture/image_difference.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

class ShortWay : public DrawingTest, public ::testing::WithParamInterface<Background::Kind> {
 protected:
  /// A plane that cuts nothing off, but could.
  static Section beside(const Model& model) {
    return {model.bounds_mm.centre() + glm::dvec3(0, 0, 3 * model.radius_mm), {0, 0, 1}};
  }

  void expect_alike(const Model& model, Scene scene) {
    const Image finished = draw(model, scene, {200, 150}, 1);
    scene.section = beside(model);
    const Image composed = draw(model, scene, {200, 150}, 1);
    EXPECT_TRUE(content_of(finished).shows_something());
    const ImageDifference difference = compare(finished, composed, {1, 0});
    EXPECT_TRUE(difference.within_tolerance) << difference.pixels << " pixels differ, by up to " << difference.largest;
  }
};

TEST_P(ShortWay, LooksLikeTheLongWay) {
  const Model model = make_model({{"ring", reversed(ring({}))}, {"ball", coarse_ball(2)}});
  for (const BackFaces back_faces : {BackFaces::cull, BackFaces::show, BackFaces::tint}) {
    Scene scene = usual_scene(model, 200.0 / 150);
    for (Look& look : scene.looks) look.opacity = 1;
    scene.occlusion.on = false;
    scene.background.kind = GetParam();
    scene.background.bottom = colour_of(0x102030);
    scene.back_faces = back_faces;
    scene.looks[1].as_body = back_faces == BackFaces::show;
    expect_alike(model, scene);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ShortWay,
                         ::testing::Values(Background::Kind::plain, Background::Kind::gradient,
                                           Background::Kind::transparent),
                         [](const auto& each) { return "Background" + std::to_string(static_cast<int>(each.param)); });

class ShortWayPane : public DrawingTest {};

TEST_F(ShortWayPane, KeepsToItself) {
  const Model model = make_model({{"ball", coarse_ball(2)}});
  Scene scene = usual_scene(model, 1);
  scene.occlusion.on = false;
  context().make_current();
  Renderer renderer(gl(), ShaderLibrary{});
  const GpuModel gpu_model = upload(gl(), model);
  for (const bool with_depth : {false, true}) {
    const Framebuffer pixels(gl(), {{120, 60}, {GL_RGBA8}, GL_DEPTH_COMPONENT32F});
    pixels.bind();
    gl().ClearColor(1, 0, 0, 1);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    const Pane pane{view_of(scene.camera, model, 1), {pixels.id(), 60, 10, {50, 50}, with_depth}};
    renderer.draw(gpu_model, scene, {&pane, 1}, {1});
    const Image drawn = read_pixels(gl(), pixels.id(), {120, 60});
    Image alone = draw(model, scene, {50, 50}, 1);
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 120; ++x) {
        const bool in_pane = x >= 60 && x < 110 && y < 50;
        const auto expected = in_pane ? alone.pixel(x - 60, y) : std::array<std::uint8_t, 4>{255, 0, 0, 255};
        for (std::size_t c = 0; c < 4; ++c)
          ASSERT_EQ(drawn.pixel(x, y)[c], expected[c]) << x << " " << y << " " << with_depth;
      }
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
