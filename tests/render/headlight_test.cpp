// The lamp that an eye carries between walls, and its near plane.

#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

using Headlights = DrawingTest;

/// An eye in a corridor 30 mm long and 2 mm wide, looking along it.
Model corridor() { return make_model({{"corridor", reversed(box({-1, -10, -1}, {1, 20, 1}))}}); }

Scene in_corridor(const Model& model) {
  Scene scene = usual_scene(model, 4.0 / 3);
  scene.looks[0].opacity = 1;
  scene.looks[0].colour = {0.8f, 0.8f, 0.8f};
  scene.occlusion.on = false;
  scene.background = {Background::Kind::plain, {1, 0, 1}, {1, 0, 1}};
  scene.camera.position = {0, 0, 0};
  scene.camera.target = {0, 1, 0};
  scene.camera.field_of_view_deg = 80;
  scene.camera.near_mm = 0.01;
  scene.headlight = Headlight{2};
  return scene;
}

int light(const Image& image, int x, int y) {
  const auto pixel = image.pixel(x, y);
  return pixel[0] + pixel[1] + pixel[2];
}

TEST_F(Headlights, FadeWithDistance) {
  const Model model = corridor();
  const Image image = draw(model, in_corridor(model), {161, 121});
  int before = light(image, 80, 61);
  for (const int y : {68, 76, 88, 110}) {  // the floor, nearer and nearer
    EXPECT_GT(light(image, 80, y), before) << y;
    before = light(image, 80, y);
  }
  Scene studio = in_corridor(model);
  studio.headlight.reset();
  const Image other = draw(model, studio, {161, 121});
  EXPECT_LT(light(image, 80, 61), light(other, 80, 61)) << "the far end lies in the dark";
}

TEST_F(Headlights, ReachFartherIfTheyMay) {
  const Model model = corridor();
  Scene scene = in_corridor(model);
  const int near = light(draw(model, scene, {161, 121}), 80, 61);
  scene.headlight->reach_mm = 20;
  EXPECT_GT(light(draw(model, scene, {161, 121}), 80, 61), 2 * near);
}

TEST_F(Headlights, TheNearPlaneIsAsNearAsTheCameraSays) {
  const Model model = corridor();
  Scene scene = in_corridor(model);
  scene.camera.position = {0.985, 0, 0};  // 0.015 from a wall, along it
  scene.camera.target = {0.985, 1, 0};
  scene.camera.near_mm = 0.004;
  const auto seen_through = [](const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) count += image.pixel(x, y)[1] == 0 && image.pixel(x, y)[0] == 255;
    return count;
  };
  EXPECT_EQ(seen_through(draw(model, scene, {161, 121})), 0);
  scene.camera.near_mm = 0;
  EXPECT_GT(seen_through(draw(model, scene, {161, 121})), 0) << "with the usual one the wall is cut";
}

}  // namespace
}  // namespace odontoscope::testing_support
