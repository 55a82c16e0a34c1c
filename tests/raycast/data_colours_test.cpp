// Surfaces in the colours of numbers: what a pixel shows is the legend's colour, but for light.

#include "engine/scene/deviation.h"
#include "tests/output/temporary_folder.h"
#include "tests/radiograph/solids.h"
#include "tests/raycast/cast_bench.h"

namespace odontoscope::test {
namespace {

class DataColour : public CastTest {
 protected:
  /// Of a square turned to the eye whose points all have this distance and slope.
  std::array<std::uint8_t, 4> seen(float distance, float slope, const DataColours& colours,
                                   const ShaderLibrary& shaders = {}) {
    Model model = make_model({{"square", {{{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {{0, 1, 2}, {0, 2, 3}}}}});
    model.parts[0].deviations.assign(model.parts[0].positions.size(), {distance, slope});
    Scene scene =
        scene_of(model, {Camera::Projection::parallel, {0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 24, 4}, VolumeLook{});
    scene.data_colours = colours;
    return cast(model, whole(lumps()), scene, shaders, {8, 8}).pixel(4, 4);
  }
  static bool is_red(const std::array<std::uint8_t, 4>& pixel) { return pixel[0] > pixel[2] + 60; }
  static bool is_blue(const std::array<std::uint8_t, 4>& pixel) { return pixel[2] > pixel[0] + 60; }
  static bool is_grey(const std::array<std::uint8_t, 4>& pixel) { return std::abs(pixel[0] - pixel[2]) < 30; }
};

constexpr DataColours distance{DataColours::Of::distance, 0.5}, slope{DataColours::Of::slope, 80};

TEST_F(DataColour, IsRedBeyondTheDataAndBlueShortOfThem) {
  EXPECT_TRUE(is_red(seen(0.5f, 0, distance)));
  EXPECT_TRUE(is_red(seen(7, 0, distance)));
  EXPECT_TRUE(is_blue(seen(-0.5f, 0, distance)));
  EXPECT_TRUE(is_grey(seen(0, 0, distance)));
  EXPECT_GT(seen(0, 0, distance)[0], seen(no_deviation, 0, distance)[0] + 60);  // nowhere near is dark
  EXPECT_TRUE(is_grey(seen(no_deviation, 0, distance)));
}

TEST_F(DataColour, GrowsBrighterWithTheSlope) {
  const auto none = seen(no_deviation, 0, slope), half = seen(0, 40, slope), all = seen(0, 80, slope);
  EXPECT_GT(half[0], none[0] + 40);
  EXPECT_GT(all[0], half[0] + 40);
  EXPECT_LT(all[2] + 60, all[0]);  // yellow
}

TEST_F(DataColour, HasAMutantThatIsNoticed) {
  const testing_support::TemporaryFolder folder;
  write_edited_shaders({{"data_colour.glsl", "part < 0.0", "part > 0.0"}}, folder.path().string());
  EXPECT_FALSE(is_red(seen(0.5f, 0, distance, {folder.path()})));
}

}  // namespace
}  // namespace odontoscope::test
