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
  /// A cap is flat and lit by lamps at infinity, so it has one colour in a parallel view. mm^2 of the most frequent opaque colour.
  double cap_area(const Model& model, const Section& section) {
    Scene scene = plain_scene(model, height_mm);
    scene.section = section;
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

TEST_F(Caps, OfABallIsADisc) { EXPECT_NEAR(cap_area(make_model({{"ball", ball({{}, 5})}}), {{0, 0, 0}, {0, 1, 0}}), disc(5), 0.01 * disc(5)); }

TEST_F(Caps, OfAHollowBallIsAnAnnulus) {
  EXPECT_NEAR(cap_area(hollow_ball_model(), {{0, 0, 0}, {0, 3, 0}}), disc(5) - disc(2), 0.01 * disc(5));
}

TEST_F(Caps, OfARingAreTwoDiscs) {
  const double tube = 12 * 1.5 * 1.5 * std::sin(2 * std::numbers::pi / 24);
  EXPECT_NEAR(cap_area(make_model({{"ring", ring({})}}), {{0, 0, 0}, {0, 1, 0}}), 2 * tube, 0.02 * tube);
}

TEST_F(Caps, OfABoxFollowsThePlane) {
  const Model model = make_model({{"box", box({-3, -2, -4}, {3, 2, 4})}});
  EXPECT_NEAR(cap_area(model, {{0, 1, 0}, {0, 1, 0}}), 48, 0.5);
  EXPECT_NEAR(cap_area(model, {{0, 0, 0}, {0, 1, 1}}), 24, 0.5);   // cut at 45 degrees, seen foreshortened: 6 x 4
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
  scene.section = Section{{0, 0, 0}, {0, -1, 0}};   // the half behind is gone
  EXPECT_EQ(draw(model, scene, size, 2), whole);
}

TEST_F(Caps, OfAnInnerStructureLiesOnThatOfTheOuter) {
  const Model model = make_model({{"core", ball({{}, 2})}, {"mantle", ball({{}, 5})}});
  Scene scene = plain_scene(model, height_mm);
  scene.section = Section{{0, 0, 0}, {0, 1, 0}};
  scene.look_of("core")->colour = {1, 0, 0};
  scene.look_of("mantle")->colour = {0, 0, 1};
  scene.look_of("mantle")->opacity = 0.4f;   // its cap is solid all the same
  const Image image = draw(model, scene, size);
  const auto middle = image.pixel(180, 180), wall = image.pixel(180 + 105, 180);
  EXPECT_GT(middle[0], middle[2] + 60);
  EXPECT_GT(wall[2], wall[0] + 60);
  EXPECT_EQ(wall[3], 255);
}

}  // namespace
}  // namespace odontoscope::testing_support
