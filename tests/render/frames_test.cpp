// A renderer keeps no picture: what it drew before must not show in what it draws next.

#include "engine/picture/image_difference.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

class Frames : public DrawingTest {};

TEST_F(Frames, HoldNothingOfTheOneBefore) {
  const Model model = make_model({{"core", ball({{}, 2})}, {"mantle", ball({{}, 5})}});
  Scene first = usual_scene(model, 4.0 / 3), second = first;
  first.camera.field_of_view_deg = 12;          // fills the picture
  second.camera.field_of_view_deg = 60;         // small, and
  second.camera.target += glm::dvec3(6, 0, 5);  // in a corner
  for (const bool occluded : {true, false}) {
    first.occlusion.on = second.occlusion.on = occluded;
    context().make_current();
    const GpuModel gpu_model = upload(gl(), model);
    Renderer used(gl(), ShaderLibrary{}), fresh(gl(), ShaderLibrary{});
    const PictureOptions options{{160, 120}, {2}};
    picture_of(gl(), used, gpu_model, model, first, options);
    const Image after = picture_of(gl(), used, gpu_model, model, second, options);
    EXPECT_TRUE(content_of(after).shows_something());
    EXPECT_EQ(after, picture_of(gl(), fresh, gpu_model, model, second, options));
  }
}

// Panes are drawn in step, layer by layer; each must be what it is alone, whichever has the most layers.
TEST_F(Frames, PanesTogetherAreWhatEachIsAlone) {
  const Model model =
      make_model({{"core", ball({{}, 2})}, {"mantle", ball({{}, 5})}, {"far off", ball({{0, 14, 0}, 3})}});
  Scene scene = usual_scene(model, 1);
  for (Look& look : scene.looks) look.opacity = 0.4f;
  context().make_current();
  const GpuModel gpu_model = upload(gl(), model);
  Renderer renderer(gl(), ShaderLibrary{});
  const PixelSize sizes[] = {{160, 120}, {160, 120}, {90, 130}, {160, 120}};
  std::vector<Framebuffer> pixels;
  std::vector<Pane> panes;
  Scene along = scene, aside = scene, past = scene;
  along.camera.position = {0, 80, 0};  // through everything
  aside.camera.position = {80, 6, 0};
  past.camera.target += glm::dvec3(0, 0, 500);  // at nothing
  const Scene* seen[] = {&past, &aside, &along, &along};
  for (std::size_t i = 0; i < 4; ++i) {
    pixels.emplace_back(gl(), Framebuffer::Layout{sizes[i], {GL_RGBA8}, GL_DEPTH_COMPONENT32F});
    panes.push_back({view_of(seen[i]->camera, model, static_cast<double>(sizes[i].width) / sizes[i].height),
                     {pixels[i].id(), 0, 0, sizes[i], true}});
  }
  for (const bool occluded : {false, true}) {
    scene.occlusion.on = occluded;
    std::vector<Image> alone;
    for (std::size_t i = 0; i < 4; ++i) {
      renderer.draw(gpu_model, scene, {&panes[i], 1}, {2});
      alone.push_back(read_pixels(gl(), pixels[i].id(), sizes[i]));
    }
    EXPECT_TRUE(content_of(alone[1]).shows_something());
    EXPECT_NE(alone[1], alone[3]);
    renderer.draw(gpu_model, scene, panes, {2});
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(read_pixels(gl(), pixels[i].id(), sizes[i]), alone[i]) << i;
  }
}

// A wall without a fold is as light where the picture ends, and its pixels have a neighbour less, as in the middle.
TEST_F(Frames, EndWithoutARim) {
  const Model model = make_model({{"wall", box({-50, -1, -50}, {50, 1, 50})}});
  Scene scene = plain_scene(model, 4);
  scene.camera.position = {40, 60, 0};  // aslant, so that a wrong normal sees one half of the wall above the other
  for (Look& look : scene.looks) look.opacity = 1;
  const Image unoccluded = draw(model, scene);
  scene.occlusion = {.on = true, .strength = 4, .reach = 0.5f};
  const Image drawn = draw(model, scene);
  for (std::size_t i = 3; i < drawn.rgba.size(); i += 4)
    ASSERT_EQ(drawn.rgba[i], 255) << "the wall must fill the picture";
  const ImageDifference difference = compare(drawn, unoccluded, {1, 0});
  EXPECT_TRUE(difference.within_tolerance) << difference.pixels << " pixels differ, by up to " << difference.largest;
}

}  // namespace
}  // namespace odontoscope::testing_support
