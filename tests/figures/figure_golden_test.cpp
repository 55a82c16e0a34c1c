// Does every figure still look as it did, and is it a picture of something? One golden a figure, its panels side by
// side.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/figures/draw.h"
#include "engine/figures/figures.h"
#include "engine/picture/image_difference.h"
#include "engine/picture/png.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

constexpr int longer_side = 96;
constexpr std::uintmax_t most_golden_bytes = 450'000;  // of all figures; all goldens of the project stay under 1 MiB
constexpr ImageTolerance tolerance{2, 0.02};

figures::ToothModels& tooth() {
  static figures::ToothModels models({});
  return models;
}

std::string golden_file(int number) { return fmt::format("{}/figure-{:02}.png", ODONTOSCOPE_GOLDENS, number); }

bool only_lines(const figures::Panel& panel) {
  return std::all_of(panel.scene.looks.begin(), panel.scene.looks.end(),
                     [](const Look& look) { return !look.visible; });
}

class FigureGoldens : public DrawingTest, public ::testing::WithParamInterface<int> {};

TEST_P(FigureGoldens, LookTheSame) {
  context().make_current();
  Renderer renderer(gl(), {});
  const figures::Figure figure = figures::make_figure(GetParam(), tooth());
  const std::vector<Image> panels = figures::draw(gl(), renderer, figure, longer_side);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const ImageContent content = content_of(panels[i]);
    EXPECT_TRUE(only_lines(figure.panels[i]) ? content.coverage >= 0.01 && content.colours > 2
                                             : content.shows_something())
        << figures::picture_name(figure, i) << ": coverage " << content.coverage << ", colours " << content.colours;
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(panels[i], panels[j]) << "two panels are one picture";
  }
  const Image drawn = figures::side_by_side(panels);
  const std::string file = golden_file(GetParam());
  if (std::getenv("ODONTOSCOPE_ACCEPT_GOLDENS")) write_png(drawn, file);
  const Image stored = read_png(file);
  const ImageDifference difference = compare(drawn, stored, tolerance);
  if (!difference.within_tolerance) {
    std::filesystem::create_directories(ODONTOSCOPE_FAILED_PICTURES);
    write_png(drawn, fmt::format("{}/figure-{:02}.png", ODONTOSCOPE_FAILED_PICTURES, GetParam()));
  }
  EXPECT_TRUE(difference.within_tolerance)
      << fmt::format("{:.3f} % of the pixels differ, the most by {}; see {}", 100 * difference.share,
                     difference.largest, ODONTOSCOPE_FAILED_PICTURES);
}

INSTANTIATE_TEST_SUITE_P(Each, FigureGoldens, ::testing::Range(1, 19));

using FigurePixels = DrawingTest;

/// Share of the pixels in which nothing was drawn.
double empty_share(const Image& image, const Scene& scene) {
  const auto byte = [](float channel) { return static_cast<int>(std::lround(255 * channel)); };
  const Colour& page = scene.background.top;
  std::size_t empty = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto pixel = image.pixel(x, y);
      empty += pixel[0] == byte(page.red) && pixel[1] == byte(page.green) && pixel[2] == byte(page.blue);
    }
  return static_cast<double>(empty) / (image.width * image.height);
}

TEST_F(FigurePixels, InsideTheToothDtHasNoHolesAndUnorientedDbHasMany) {
  context().make_current();
  Renderer renderer(gl(), {});
  const figures::Figure figure = figures::make_figure(17, tooth());
  const std::vector<Image> panels = figures::draw(gl(), renderer, figure, 200);
  EXPECT_EQ(empty_share(panels[1], figure.panels[1].scene), 0);
  EXPECT_GT(empty_share(panels[2], figure.panels[2].scene), 0.02);
  EXPECT_LT(empty_share(panels[3], figure.panels[3].scene), 0.002);
}

/// Pixels in which a crease runs across the columns: where lightness bends by more than a smooth surface's does. Only
/// those that lie within both pictures' outlines, where no pixel is blended with the page.
std::size_t creased_pixels(const Image& image, const Image& other, const Scene& scene) {
  constexpr int reach = 4, outline = 2, most_bend = 4;  // pixels, pixels, of 255; ridges come about 11 pixels apart
  const auto drawn = [&](const Image& picture, int x, int y) {
    const auto pixel = picture.pixel(x, y);
    return pixel[0] != std::lround(255 * scene.background.top.red) ||
           pixel[2] != std::lround(255 * scene.background.top.blue);
  };
  const auto within = [&](int x, int y) {
    for (int i = -outline; i <= outline; ++i)
      for (const Image* picture : {&image, &other})
        if (!drawn(*picture, x + i, y) || !drawn(*picture, x, y + i)) return false;
    return true;
  };
  const auto lightness = [&](int x, int y) { return static_cast<int>(image.pixel(x, y)[1]); };
  constexpr int margin = reach + outline;
  std::size_t creased = 0;
  for (int x = outline; x < image.width - outline; ++x)
    for (int y = margin; y < image.height - margin; ++y)
      if (within(x, y - reach) && within(x, y) && within(x, y + reach))
        creased += std::abs(lightness(x, y - reach) - 2 * lightness(x, y) + lightness(x, y + reach)) > most_bend;
  return creased;
}

TEST_F(FigurePixels, NearTheTipOfARootDbShowsRidgesThatDtHasNot) {
  context().make_current();
  Renderer renderer(gl(), {});
  const figures::Figure by_db = figures::make_figure(5, tooth()), by_dt = figures::make_figure(6, tooth());
  const Image db = figures::draw(gl(), renderer, by_db, 400)[1], dt = figures::draw(gl(), renderer, by_dt, 400)[1];
  EXPECT_GT(creased_pixels(db, dt, by_db.panels[1].scene), 3 * creased_pixels(dt, db, by_dt.panels[1].scene));
  EXPECT_GT(creased_pixels(db, dt, by_db.panels[1].scene), 500u);
}

TEST(FigureGoldenFiles, AreSmallAndAllInUse) {
  std::uintmax_t bytes = 0;
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ODONTOSCOPE_GOLDENS)) {
    bytes += entry.file_size();
    ++pictures;
  }
  EXPECT_LT(bytes, most_golden_bytes);
  EXPECT_EQ(pictures, figures::paper_figures().size());
}

}  // namespace
}  // namespace odontoscope::testing_support
