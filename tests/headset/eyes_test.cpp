// What both eyes see, without a runtime: their disparity, the inside, the fade.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "engine/headset/eye_painter.h"
#include "engine/picture/png.h"
#include "engine/view/offscreen.h"
#include "tests/headset/drawing.h"
#include "tests/headset/worlds.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

class Eyes : public Drawing {
 protected:
  static constexpr PixelSize size{320, 300};
  Framebuffer pixels[2];

  void begin() override {
    for (Framebuffer& eye : pixels) eye = Framebuffer(context->gl(), {size, {GL_SRGB8_ALPHA8}, GL_DEPTH_COMPONENT32F});
  }
  std::vector<Image> seen(EyePainter& painter, const Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
    const Target targets[2] = {{pixels[0].id(), 0, 0, size, true}, {pixels[1].id(), 0, 0, size, true}};
    painter.draw(visit, input, world, eyes_of(input.head), targets);
    return {read_pixels(context->gl(), pixels[0].id(), size), read_pixels(context->gl(), pixels[1].id(), size)};
  }
};

HeadsetInput handless() {
  HeadsetInput input = person();
  input.hands = {};
  return input;
}

TEST_F(Eyes, SeeTheInsideOfThePulpAndNothingElse) {
  const BallWorld& balls = BallWorld::once();
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
  Visit visit;
  visit.placed = true;
  visit.scene = balls.scene;
  visit.cavity = 0;
  const HeadsetInput input = handless();
  visit.stage = inside(balls.cavities[0], input.head, balls.model, {});
  visit.eye_mm = balls.cavities[0].middle;
  for (const Image& image : seen(painter, visit, input, balls.world())) {
    const auto background = EyeQuality{}.background.top;
    std::size_t empty = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const auto pixel = image.pixel(x, y);
        empty += std::abs(pixel[0] - 255 * background.red) < 2 && std::abs(pixel[1] - 255 * background.green) < 2 &&
                         std::abs(pixel[2] - 255 * background.blue) < 2
                     ? 1
                     : 0;
      }
    EXPECT_EQ(empty, 0u);                      // a closed wall all around
    EXPECT_GT(content_of(image).colours, 4u);  // lit, though a lamp in the middle of a ball lights it evenly
  }
}

TEST_F(Eyes, AreDarkInTheMiddleOfAFadeAndAtTheEdgesWhileGliding) {
  const BallWorld& balls = BallWorld::once();
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
  const HeadsetInput input = handless();
  Visit visit = advance_visit({}, input, balls.world(), {}, 0.01);
  const auto clear = seen(painter, visit, input, balls.world());
  visit.seen.vignette = 1;
  const auto edged = seen(painter, visit, input, balls.world());
  visit.seen.dark = 1;
  const auto dark = seen(painter, visit, input, balls.world());
  for (std::size_t eye = 0; eye < 2; ++eye) {
    EXPECT_TRUE(content_of(clear[eye]).shows_something());
    EXPECT_EQ(content_of(dark[eye]).coverage, 0);
    EXPECT_EQ(dark[eye].pixel(160, 150)[0], 0);
    EXPECT_EQ(edged[eye].pixel(2, 2)[1], 0);
    // The line of sight is not the middle of a lopsided picture.
    const FieldOfView field = lopsided(eye == 0);
    const int x = static_cast<int>(size.width * std::tan(-field.left) / (std::tan(field.right) - std::tan(field.left)));
    const int y = static_cast<int>(size.height * std::tan(field.up) / (std::tan(field.up) - std::tan(field.down)));
    EXPECT_EQ(edged[eye].pixel(x, y), clear[eye].pixel(x, y));
    // As dark on one side of it as on the other.
    const int off = static_cast<int>(0.6 * size.width / (std::tan(field.right) - std::tan(field.left)));
    const auto left_over = [&](int at) {
      return static_cast<double>(edged[eye].pixel(at, y)[1]) / clear[eye].pixel(at, y)[1];
    };
    EXPECT_NEAR(left_over(x - off), left_over(x + off), 0.04);
    EXPECT_NEAR(left_over(x - off), 0.5, 0.25);
  }
}

TEST_F(Eyes, SeeTheHandsRayUpToWhatItHits) {
  const BallWorld& balls = BallWorld::once();
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
  HeadsetInput input = handless();
  const Visit before = advance_visit({}, input, balls.world(), {}, 0.01);
  const Image without = seen(painter, before, input, balls.world())[0];
  input.hands[1] = pointing_at(to_room(before.stage, balls.model.bounds_mm.centre()),
                               input.head.position + glm::dvec3(0.15, -0.25, -0.3));
  const Visit pointing = advance_visit(before, input, balls.world(), {}, 0.01);
  ASSERT_TRUE(pointing.hands.pointed[1]);
  EXPECT_EQ(pointing.hands.pointed[1]->structure, "pulp");
  const Image with = seen(painter, pointing, input, balls.world())[0];
  // Changed pixels lie on the way from the hand, which is right of and below the tooth.
  std::size_t changed = 0, outside_the_model = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (with.pixel(x, y) == without.pixel(x, y)) continue;
      ++changed;
      outside_the_model += y > 230 ? 1 : 0;
    }
  EXPECT_GT(changed, 40u);
  EXPECT_GT(outside_the_model, 10u);
  EXPECT_LT(changed, static_cast<std::size_t>(size.width) * 20);
}

TEST_F(Eyes, SeeHowLargeTheToothIsForAWhile) {
  const BallWorld& balls = BallWorld::once();
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
  const HeadsetInput input = handless();
  Visit visit = advance_visit({}, input, balls.world(), {}, 0.01);
  EXPECT_GT(visit.seen.told, 0);
  const Image with = seen(painter, visit, input, balls.world())[1];
  for (int i = 0; i < 400; ++i) visit = advance_visit(visit, input, balls.world(), {}, 0.01);
  EXPECT_EQ(visit.seen.told, 0);
  EXPECT_NE(with, seen(painter, visit, input, balls.world())[1]);
}

TEST_F(Eyes, TheMirrorShowsTheMiddleOfAnEye) {
  const BallWorld& balls = BallWorld::once();
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
  const HeadsetInput input = handless();
  const Visit visit = advance_visit({}, input, balls.world(), {}, 0.01);
  const Image eye = seen(painter, visit, input, balls.world())[0];
  const PixelSize wide{320, 150};
  const Framebuffer window(context->gl(), {wide, {GL_RGBA8}});
  EyePainter::mirror(context->gl(), {pixels[0].id(), 0, 0, size, true}, {window.id(), 0, 0, wide});
  const Image mirrored = read_pixels(context->gl(), window.id(), wide);
  for (int y = 0; y < wide.height; ++y)
    for (int x = 0; x < wide.width; ++x) ASSERT_EQ(mirrored.pixel(x, y), eye.pixel(x, y + 75)) << x << ' ' << y;
}

}  // namespace
}  // namespace odontoscope::testing_support
