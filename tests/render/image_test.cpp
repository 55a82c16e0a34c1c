// Pictures without drawing: PNG, comparison, content.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/picture/image_difference.h"
#include "engine/picture/png.h"
#include "recon/core/base64.h"
#include "recon/core/error.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope::testing_support {
namespace {

Image pattern(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.set_pixel(
          x, y,
          {static_cast<std::uint8_t>(5 * x), static_cast<std::uint8_t>(7 * y), static_cast<std::uint8_t>(x * y), 255});
  return image;
}

TEST(Comparison, OfEqualPictures) {
  const Image image = pattern(40, 30);
  const ImageDifference difference = compare(image, image, {0, 0});
  EXPECT_TRUE(difference.within_tolerance);
  EXPECT_EQ(difference.pixels, 0u);
  EXPECT_DOUBLE_EQ(difference.similarity, 1);
}

TEST(Comparison, CountsPixelsBeyondTheChannelTolerance) {
  const Image a = pattern(40, 30);
  Image b = a;
  b.set_pixel(3, 4, {static_cast<std::uint8_t>(a.pixel(3, 4)[0] + 2), a.pixel(3, 4)[1], a.pixel(3, 4)[2], 255});
  b.set_pixel(5, 6, {a.pixel(5, 6)[0], static_cast<std::uint8_t>(a.pixel(5, 6)[1] + 3), a.pixel(5, 6)[2], 255});
  EXPECT_EQ(compare(a, b, {2, 0}).pixels, 1u);
  EXPECT_EQ(compare(a, b, {2, 0}).largest, 3);
  EXPECT_FALSE(compare(a, b, {2, 0}).within_tolerance);
  EXPECT_TRUE(compare(a, b, {3, 0}).within_tolerance);
  EXPECT_TRUE(compare(a, b, {2, 1.0 / 1200}).within_tolerance);
}

TEST(Comparison, OfOtherSizesFails) {
  EXPECT_FALSE(compare(pattern(4, 5), pattern(5, 4)).same_size);
  EXPECT_FALSE(compare(pattern(4, 5), pattern(5, 4), {255, 1}).within_tolerance);
}

TEST(Comparison, LooksThroughInvisibleColour) {
  Image a(2, 2), b(2, 2);
  a.set_pixel(0, 0, {255, 0, 0, 0});
  EXPECT_TRUE(compare(a, b, {0, 0}).within_tolerance);
  a.set_pixel(0, 0, {0, 0, 0, 255});
  EXPECT_FALSE(compare(a, b, {0, 0}).within_tolerance);
}

TEST(Comparison, SimilarityFallsWithStructureMoreThanWithBrightness) {
  const Image a = pattern(64, 64);
  Image brighter = a, shifted(64, 64);
  for (std::size_t i = 0; i < brighter.rgba.size(); ++i)
    if (i % 4 != 3 && brighter.rgba[i] < 250) brighter.rgba[i] = static_cast<std::uint8_t>(brighter.rgba[i] + 5);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) shifted.set_pixel(x, y, a.pixel((x + 9) % 64, y));
  EXPECT_GT(compare(a, brighter).similarity, 0.95);
  EXPECT_LT(compare(a, shifted).similarity, compare(a, brighter).similarity);
}

TEST(DifferencePicture, IsBlackWhereEqualAndShowsTheLeast) {
  const Image a = pattern(20, 20);
  Image b = a;
  b.set_pixel(3, 4, {a.pixel(3, 4)[0], a.pixel(3, 4)[1], static_cast<std::uint8_t>(a.pixel(3, 4)[2] + 1), 255});
  const Image difference = difference_picture(a, b);
  EXPECT_EQ(difference.pixel(0, 0), (std::array<std::uint8_t, 4>{0, 0, 0, 255}));
  EXPECT_GT(difference.pixel(3, 4)[2], 30);
}

TEST(Content, TellsABlankPicture) {
  EXPECT_FALSE(content_of(Image()).shows_something());
  EXPECT_FALSE(content_of(Image(30, 30)).shows_something());
  Image silhouette(30, 30);
  for (int y = 5; y < 25; ++y)
    for (int x = 5; x < 25; ++x) silhouette.set_pixel(x, y, {200, 200, 200, 255});
  EXPECT_FALSE(content_of(silhouette).shows_something()) << "covered, but flat";
  EXPECT_TRUE(content_of(pattern(30, 30)).shows_something());
}

class Png : public ::testing::Test {
 protected:
  std::string written(const std::string& name, const std::string& bytes) {
    const std::string file = (folder_.path() / name).string();
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }
  std::string cause_of(const std::string& file) {
    try {
      read_png(file);
    } catch (const InputError& error) {
      return error.cause();
    }
    return "none";
  }
  TemporaryFolder folder_;
};

TEST_F(Png, ComesBackAsItWas) {
  Image image = pattern(37, 23);
  image.set_pixel(1, 1, {10, 20, 30, 40});
  const std::string file = (folder_.path() / "a.png").string();
  write_png(image, file);
  EXPECT_EQ(read_png(file), image);
  EXPECT_EQ(png_bytes(image), png_bytes(image));
}

TEST_F(Png, ThatIsNoneIsRefused) {
  EXPECT_EQ(cause_of(written("text.png", "hello")), "not-a-png");
  EXPECT_EQ(cause_of(written("empty.png", "")), "not-a-png");
  std::string bytes = png_bytes(pattern(20, 20));
  EXPECT_EQ(cause_of(written("cut.png", bytes.substr(0, bytes.size() / 2))), "not-a-png");
  EXPECT_EQ(cause_of(written("head.png", bytes.substr(0, 20))), "not-a-png");
  EXPECT_THROW(read_png((folder_.path() / "missing.png").string()), FileError);
}

TEST_F(Png, ThatClaimsAHugeSizeIsRefusedBeforeMemoryIsTaken) {
  std::string bytes = png_bytes(pattern(20, 20));
  bytes[18] = '\x7f';  // width, big-endian: 0x00007f14
  EXPECT_EQ(cause_of(written("huge.png", bytes)), "picture-too-large");
}

/// Kinds of other programs: grey of one bit, a palette with transparency, 16 bits, interlaced.
TEST_F(Png, OfEveryKindIsReadAsEightBits) {
  const auto read = [&](std::string_view base64_text) {
    return read_png(written("kind.png", from_base64(base64_text).value()));
  };
  using Pixel = std::array<std::uint8_t, 4>;
  const Image grey =
      read("iVBORw0KGgoAAAANSUhEUgAAAAIAAAABAQAAAADcWUInAAAACklEQVR4nGNwAAAAQgBBKTf07wAAAABJRU5ErkJggg==");
  EXPECT_EQ(grey.pixel(0, 0), (Pixel{0, 0, 0, 255}));
  EXPECT_EQ(grey.pixel(1, 0), (Pixel{255, 255, 255, 255}));
  const Image palette = read(
      "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAMAAADD/I+4AAAABlBMVEUKFB7IZDJ3oLOcAAAAAnRSTlP/"
      "gAgPs2oAAAALSURBVHicY2BgBAAABAACv3o"
      "/SgAAAABJRU5ErkJggg==");
  EXPECT_EQ(palette.pixel(0, 0), (Pixel{10, 20, 30, 255}));
  EXPECT_EQ(palette.pixel(1, 0), (Pixel{200, 100, 50, 128}));
  const Image deep =
      read("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABEAIAAADA54+dAAAAD0lEQVR4nGMQ+m/CENYAAAdqAhwQlz5BAAAAAElFTkSuQmCC");
  EXPECT_EQ(deep.pixel(0, 0), (Pixel{0x12, 0x34, 0x56, 255}));
  const Image interlaced =
      read("iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAAAAAEg2mJuAAAAD0lEQVR4nGNgZGBiYGYBAAAfAAuTYsRUAAAAAElFTkSuQmCC");
  EXPECT_EQ(interlaced.pixel(1, 0)[0], 2);
  EXPECT_EQ(interlaced.pixel(0, 1)[0], 3);
  EXPECT_EQ(interlaced.pixel(1, 1)[0], 4);
}

TEST_F(Png, WithMorePixelsThanItSaysIsRefused) {
  const std::string_view more =
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAASElEQVR4nO3BMQ0AAAACID/"
      "7N7aHA9IAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
      "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAABwZRrjAAiXiebcAAAAAElFTkSuQmCC";
  EXPECT_EQ(cause_of(written("more.png", from_base64(more).value())), "not-a-png");
}

}  // namespace
}  // namespace odontoscope::testing_support
