// Sections: the cap's area is the section's area, voids stay open, and the far side has none.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

constexpr double height_mm = 12;
constexpr PixelSize size{360, 360};
constexpr double mm2_per_pixel = (height_mm / size.height) * (height_mm / size.height);

class Caps : public DrawingTest {
 protected:
  /// A plain cap is flat and lit by lamps at infinity, so it has one colour in a parallel view. mm^2 of the most
  /// frequent opaque colour.
  double cap_area(const Model& model, const Section& section) {
    Scene scene = plain_scene(model, height_mm);
    scene.section = section;
    scene.cap.shows = CapLook::Shows::plain;
    for (Look& look : scene.looks) look.opacity = 1;
    const Image image = draw(model, scene, size);
    std::map<std::array<std::uint8_t, 4>, std::size_t> colours;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (image.pixel(x, y)[3] == 255) ++colours[image.pixel(x, y)];
    std::size_t most = 0;
    for (const auto& [colour, count] : colours) most = std::max(most, count);
    return static_cast<double>(most) * mm2_per_pixel;
  }
};

/// Of the polygon that a ball of 48 segments shows in its equator.
double disc(double radius) { return 24 * radius * radius * std::sin(2 * std::numbers::pi / 48); }

TEST_F(Caps, OfABallIsADisc) {
  EXPECT_NEAR(cap_area(make_model({{"ball", ball({{}, 5})}}), {{0, 0, 0}, {0, 1, 0}}), disc(5), 0.01 * disc(5));
}

TEST_F(Caps, OfAHollowBallIsAnAnnulus) {
  EXPECT_NEAR(cap_area(hollow_ball_model(), {{0, 0, 0}, {0, 3, 0}}), disc(5) - disc(2), 0.01 * disc(5));
}

TEST_F(Caps, LeaveNoHoleThroughASolidWhoseCavityIsEmpty) {
  const Model model = hollow_ball_model();
  Scene scene = plain_scene(model, height_mm);
  scene.camera.field_of_view_deg =
      2 * std::atan(height_mm / 2 / 60) * 180 / std::numbers::pi;  // as high, in the section's plane
  for (const auto projection : {Camera::Projection::parallel, Camera::Projection::perspective}) {
    scene.camera.projection = projection;
    scene.section = Section{{0, 0, 0}, {0, 1, 0}};
    for (const bool as_body : {true, false}) {
      scene.look_of("shell cavity")->as_body = as_body;
      const Image cut = draw(model, scene, size);
      std::size_t within = 0, holes = 0;
      for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
          if (std::hypot(x - 180, y - 180) * height_mm / size.height > 4.5) continue;
          ++within;
          holes += cut.pixel(x, y)[3] < 255;
        }
      EXPECT_GT(within, 50000u);
      EXPECT_EQ(holes, 0u) << (as_body ? "as a body" : "as wound");
    }
  }
}

TEST_F(Caps, OfARingAreTwoDiscs) {
  const double tube = 12 * 1.5 * 1.5 * std::sin(2 * std::numbers::pi / 24);
  EXPECT_NEAR(cap_area(make_model({{"ring", ring({})}}), {{0, 0, 0}, {0, 1, 0}}), 2 * tube, 0.02 * tube);
}

TEST_F(Caps, OfABoxFollowsThePlane) {
  const Model model = make_model({{"box", box({-3, -2, -4}, {3, 2, 4})}});
  EXPECT_NEAR(cap_area(model, {{0, 1, 0}, {0, 1, 0}}), 48, 0.5);
  EXPECT_NEAR(cap_area(model, {{0, 0, 0}, {0, 1, 1}}), 24, 0.5);  // cut at 45 degrees, seen foreshortened: 6 x 4
}

TEST_F(Caps, OfAPlaneBesideTheModelIsNothing) {
  const Model model = make_model({{"ball", ball({{}, 2})}});
  Scene scene = plain_scene(model, height_mm);
  const Image whole = draw(model, scene, size, 2);
  scene.section = Section{{0, 3, 0}, {0, 1, 0}};
  EXPECT_EQ(draw(model, scene, size, 2), whole);
  scene.section = Section{{0, -3, 0}, {0, 1, 0}};
  EXPECT_FALSE(content_of(draw(model, scene, size, 2)).shows_something()) << "all of it is cut away";
}

TEST_F(Caps, AreNotSeenFromBehind) {
  const Model model = make_model({{"ball", ball({{}, 5})}});
  Scene scene = plain_scene(model, height_mm);
  const Image whole = draw(model, scene, size, 2);
  scene.section = Section{{0, 0, 0}, {0, -1, 0}};  // the half behind is gone
  EXPECT_EQ(draw(model, scene, size, 2), whole);
}

TEST_F(Caps, OfAnInnerStructureLiesOnThatOfTheOuter) {
  const Model model = make_model({{"core", ball({{}, 2})}, {"mantle", ball({{}, 5})}});
  Scene scene = plain_scene(model, height_mm);
  scene.section = Section{{0, 0, 0}, {0, 1, 0}};
  scene.look_of("core")->colour = {1, 0, 0};
  scene.look_of("mantle")->colour = {0, 0, 1};
  scene.look_of("mantle")->opacity = 0.4f;  // its cap is solid all the same
  const Image image = draw(model, scene, size);
  const auto middle = image.pixel(180, 180), wall = image.pixel(180 + 105, 180);
  EXPECT_GT(middle[0], middle[2] + 60);
  EXPECT_GT(wall[2], wall[0] + 60);
  EXPECT_EQ(wall[3], 255);
}

/// The pixels of a cap, told by drawing it plain: they have its one colour.
struct CapPixels {
  double mean = 0, spread = 0;            // of green, over the cap
  double step = 0;                        // mean difference of green between neighbours
  std::size_t pixels = 0, elsewhere = 0;  // elsewhere: that differ from the plain picture but are no cap
};

CapPixels grain_of(const Image& textured, const Image& plain, const std::array<std::uint8_t, 4>& cap) {
  CapPixels found;
  double sum = 0, squares = 0, steps = 0;
  std::size_t pairs = 0;
  for (int y = 0; y < plain.height; ++y)
    for (int x = 0; x < plain.width; ++x) {
      if (plain.pixel(x, y) != cap) {
        found.elsewhere += textured.pixel(x, y) != plain.pixel(x, y);
        continue;
      }
      const double green = textured.pixel(x, y)[1];
      ++found.pixels;
      sum += green;
      squares += green * green;
      if (x + 1 == plain.width || plain.pixel(x + 1, y) != cap) continue;
      steps += std::abs(green - textured.pixel(x + 1, y)[1]);
      ++pairs;
    }
  const auto count = static_cast<double>(found.pixels);
  found.mean = sum / count;
  found.spread = std::sqrt(squares / count - found.mean * found.mean);
  found.step = steps / static_cast<double>(pairs);
  return found;
}

TEST_F(Caps, HaveAGrainThatKeepsTheColourAndTheEdges) {
  const Model model = make_model({{"ball", ball({{}, 5})}});
  Scene scene = plain_scene(model, height_mm);
  scene.section = Section{{0, 0, 0}, {0, 1, 0}};
  const Image textured = draw(model, scene, size);
  scene.cap.shows = CapLook::Shows::plain;
  const Image plain = draw(model, scene, size);
  const auto colour = plain.pixel(180, 180);
  const CapPixels found = grain_of(textured, plain, colour);
  EXPECT_NEAR(static_cast<double>(found.pixels) * mm2_per_pixel, disc(5), 0.01 * disc(5));
  EXPECT_EQ(found.elsewhere, 0u);
  EXPECT_NEAR(found.mean, colour[1], 2);
  EXPECT_GT(found.spread, 3) << "no texture to be seen";
  EXPECT_LT(found.spread, 20) << "the colour is lost in noise";
  EXPECT_LT(found.step, 0.5 * found.spread) << "grains are wider than pixels, not snow";
}

TEST_F(Caps, KeepTheirGrainWhenTheEyeMoves) {
  const Model model = make_model({{"box", box({-3, -2, -4}, {3, 2, 4})}});
  Scene scene = plain_scene(model, height_mm);
  scene.section = Section{{0, 0, 0}, {0, 1, 0}};
  const Image before = draw(model, scene, size);
  constexpr int pixels = 20;
  const glm::dvec3 right(-pixels * height_mm / size.height, 0, 0);  // seen from +y, x runs to the left
  scene.camera.position += right;
  scene.camera.target += right;
  const Image after = draw(model, scene, size);
  int worst = 0;
  for (int y = 100; y < 260; ++y)
    for (int x = 120; x < 240; ++x)
      worst = std::max(worst, std::abs(before.pixel(x, y)[1] - after.pixel(x - pixels, y)[1]));
  EXPECT_LE(worst, 2);
}

}  // namespace
}  // namespace odontoscope::testing_support
