// Order-independent transparency: exact, whatever the order of drawing and the side.

#include <algorithm>
#include <cmath>

#include "engine/picture/image_difference.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

using Transparency = DrawingTest;

/// Onion of balls of one opacity. The middle of the picture looks straight through all of them.
Model onion(int skins) {
  std::vector<NamedSurface> surfaces;
  for (int i = 0; i < skins; ++i) surfaces.push_back({"skin " + std::to_string(i), ball({{}, 5.0 - 0.3 * i, 64})});
  return make_model(surfaces);
}

int alpha_through(const Image& image) { return image.pixel(image.width / 2, image.height / 2)[3]; }

TEST_F(Transparency, EveryLayerCountsOnce) {
  for (const int skins : {1, 2, 5, 12}) {
    const Model model = onion(skins);
    Scene scene = plain_scene(model, 12);
    for (Look& look : scene.looks) look.opacity = 0.1f;
    EXPECT_NEAR(alpha_through(draw(model, scene, {121, 121})), 255 * (1 - std::pow(0.9, skins)), 1.0) << skins;
    scene.back_faces = BackFaces::show;  // the far side of each as well
    if (2 * skins <= most_layers) {
      EXPECT_NEAR(alpha_through(draw(model, scene, {121, 121})), 255 * (1 - std::pow(0.9, 2 * skins)), 1.0) << skins;
    }
  }
}

TEST_F(Transparency, DoesNotDependOnTheOrderOfStructures) {
  std::vector<NamedSurface> surfaces = {{"a", ball({{-1, 0, 0}, 3})}, {"b", ball({{1, 1, 0}, 3})}, {"c", ring({})}};
  const Model model = make_model(surfaces);
  Scene scene = usual_scene(model, 4.0 / 3);
  for (Look& look : scene.looks) look.opacity = 0.4f;
  const Image first = draw(model, scene);
  EXPECT_TRUE(content_of(first).shows_something());
  std::reverse(surfaces.begin(), surfaces.end());
  const ImageDifference difference = compare(first, draw(make_model(surfaces), scene), {0, 0});
  EXPECT_EQ(difference.pixels, 0u) << difference.largest;
}

TEST_F(Transparency, WhatIsOpaqueHidesWhatLiesBehind) {
  const Model model = make_model({{"front", ball({{0, 4, 0}, 2})}, {"behind", ball({{0, -4, 0}, 1})}});
  Scene scene = plain_scene(model, 12);
  scene.look_of("front")->opacity = 1;
  scene.look_of("behind")->opacity = 0.5f;
  const Image both = draw(model, scene, {160, 120}, 2);
  scene.look_of("behind")->visible = false;
  EXPECT_EQ(draw(model, scene, {160, 120}, 2), both);
  scene.look_of("front")->opacity = 0.99f;
  scene.look_of("behind")->visible = true;
  EXPECT_NE(draw(model, scene, {160, 120}, 2), both);
}

TEST_F(Transparency, OpacityOneAndVeryNearlyOneLookAlike) {
  const Model model = make_model({{"ball", ball({{}, 5})}});
  Scene scene = plain_scene(model, 12);
  scene.looks[0].opacity = 1;
  const Image solid = draw(model, scene);
  scene.looks[0].opacity = 0.9999f;
  EXPECT_TRUE(compare(solid, draw(model, scene), {2, 0.001}).within_tolerance);
}

TEST_F(Transparency, ABodyOfACavityIsTheFilledVoid) {
  const Model hollow = hollow_ball_model();
  Scene scene = plain_scene(hollow, 12);
  scene.look_of("shell")->visible = false;
  Look* cavity = scene.look_of("shell cavity");
  cavity->opacity = 1;
  EXPECT_TRUE(cavity->as_body) << "nothing fills it";
  const Image body = draw(hollow, scene);
  Model solid =
      make_model({{"shell cavity", ball({{}, 2})}, {"shell", ball({{}, 5})}});  // the same box, so the same view
  EXPECT_TRUE(content_of(body).shows_something());
  scene.look_of("shell cavity")->as_body = false;
  EXPECT_TRUE(compare(body, draw(solid, scene), {2, 0.001}).within_tolerance);
  EXPECT_FALSE(compare(body, draw(hollow, scene), {2, 0.001}).within_tolerance) << "as wound, its far wall is seen";
}

}  // namespace
}  // namespace odontoscope::testing_support
