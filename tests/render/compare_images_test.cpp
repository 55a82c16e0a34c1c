// `compare-images` on folders: what a repository of pictures is tested with. The pictures are made in code; nothing is
// drawn.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/picture/compare_folders.h"
#include "engine/picture/png.h"
#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

Image ramp(int width = 64, int height = 48) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.set_pixel(x, y, {static_cast<std::uint8_t>(3 * x), static_cast<std::uint8_t>(5 * y), 90, 255});
  return image;
}

Image with_pixel(Image image, int x, int y) {
  image.set_pixel(x, y, {255, 255, 255, 255});
  return image;
}

/// Light but for a square.
Image mask_without(const PixelBox& square) {
  Image mask(64, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const bool out = x >= square.left && x <= square.right && y >= square.top && y <= square.bottom;
      const std::uint8_t light = out ? 0 : 255;
      mask.set_pixel(x, y, {light, light, light, 255});
    }
  return mask;
}

class CompareImages : public ProgramTest {
 protected:
  void SetUp() override {
    for (const char* name : {"expected/views", "actual/views", "masks/views"})
      std::filesystem::create_directories(folder / name);
    for (const char* name : {"a.png", "b.PNG", "views/c.png"}) {
      write("expected/", name, ramp());
      write("actual/", name, ramp());
    }
    given("actual/notes.txt", "no picture\n");
  }
  void write(const std::string& where, const std::string& name, const Image& image) {
    write_png(image, (folder / (where + name)).string());
  }
  Ending compared(std::vector<std::string> more = {}) {
    std::vector<std::string> words{"compare-images", "expected", "actual", "--report", "v.json", "--html", "v.html"};
    words.insert(words.end(), more.begin(), more.end());
    return odontoscope(words);
  }
  nlohmann::json verdict() { return nlohmann::json::parse(bytes_of("v.json")); }
};

TEST_F(CompareImages, OfEqualFoldersPasses) {
  const Ending ending = compared({"--channel", "0", "--share", "0", "--similarity", "1"});
  EXPECT_EQ(ending.exit_code, 0) << ending.out << ending.err;
  EXPECT_TRUE(ending.says("3 of 3 pictures alike")) << ending.out;
  EXPECT_TRUE(verdict()["passed"]);
  EXPECT_EQ(bytes_of("v.html").find("<section>"), std::string::npos);
}

TEST_F(CompareImages, FindsAndShowsOnePlantedPixel) {
  write("actual/", "views/c.png", with_pixel(ramp(), 40, 7));
  EXPECT_EQ(compared().exit_code, 0) << "one of 3,072 pixels is within the default tolerance of 1 %";
  const Ending ending = compared({"--share", "0"});
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_TRUE(ending.says("views/c.png: different: 1 of 3072 pixels (0.033 %)")) << ending.out;
  EXPECT_TRUE(ending.says("2 of 3 pictures alike")) << ending.out;
  const auto told = verdict();
  EXPECT_FALSE(told["passed"]);
  EXPECT_EQ(told["counts"]["different"], 1);
  EXPECT_EQ(told["pictures"][2]["name"], "views/c.png");
  EXPECT_EQ(told["pictures"][2]["pixels"], 1);
  EXPECT_EQ(told["pictures"][2]["box"], (nlohmann::json{40, 7, 40, 7}));
  const std::string page = bytes_of("v.html");
  EXPECT_NE(page.find("<h2>views/c.png</h2>"), std::string::npos);
  std::size_t shown = 0;
  for (std::size_t at = page.find("<figure"); at != std::string::npos; at = page.find("<figure", at + 1)) ++shown;
  EXPECT_EQ(shown, 6u) << "expected, actual, difference, and the same near to";
  EXPECT_NE(page.find("from (28, 0) to (52, 19)"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("http"), page.find("http-equiv")) << "asks the network for nothing";
  EXPECT_EQ(compared({"--share", "1", "--similarity", "0.9999"}).exit_code, 1) << "by likeness alone";
}

TEST_F(CompareImages, LeavesOutWhatAMaskMakesDark) {
  write("actual/", "views/c.png", with_pixel(ramp(), 40, 7));
  write("masks/", "views/c.png", mask_without({38, 5, 42, 9}));
  EXPECT_EQ(compared({"--share", "0", "--similarity", "1", "--mask", "masks"}).exit_code, 0);
  EXPECT_EQ(verdict()["pictures"][2]["compared"], 64 * 48 - 25);
  EXPECT_FALSE(verdict()["pictures"][0]["masked"]);
  write("masks/", "views/c.png", mask_without({41, 5, 45, 9}));  // beside it
  EXPECT_EQ(compared({"--share", "0", "--mask", "masks"}).exit_code, 1);
  write("masks/", "views/c.png", mask_without({0, 0, 63, 47}));  // nothing is left
  EXPECT_EQ(compared({"--share", "1", "--mask", "masks"}).exit_code, 1);
  write("masks/", "views/c.png", ramp(9, 9));
  EXPECT_EQ(compared({"--mask", "masks"}).exit_code, 1);
  EXPECT_EQ(verdict()["pictures"][2]["cause"], "mask-size");
  write("", "one.png", mask_without({38, 5, 42, 9}));
  EXPECT_EQ(compared({"--share", "0", "--mask", "one.png"}).exit_code, 0) << "one for all";
  EXPECT_EQ(odontoscope({"compare-images", "expected/views/c.png", "actual/views/c.png", "--share", "0", "--mask",
                         "one.png", "--difference", "d.png"})
                .exit_code,
            0);
  EXPECT_EQ(read_png((folder / "d.png").string()).pixel(40, 7), (std::array<std::uint8_t, 4>{0, 0, 64, 255}));
}

TEST_F(CompareImages, TellsWhatIsMissingUnexpectedOrHostile) {
  std::filesystem::remove(folder / "actual/a.png");
  write("actual/", "new.png", ramp());
  given("actual/b.PNG", "<script>alert(1)</script>");
  const std::string whole = bytes_of("expected/views/c.png");
  given("actual/views/c.png", whole.substr(0, whole.size() / 2));
  given("actual/<b>.png", whole);
  const Ending ending = compared();
  EXPECT_EQ(ending.exit_code, 1) << ending.err;
  const auto told = verdict();
  EXPECT_EQ(
      told["counts"],
      (nlohmann::json{
          {"pictures", 5}, {"alike", 0}, {"different", 0}, {"missing", 1}, {"unexpected", 2}, {"unreadable", 2}}));
  EXPECT_TRUE(ending.says("b.PNG: unreadable: ")) << ending.out;
  const std::string page = bytes_of("v.html");
  EXPECT_NE(page.find("&lt;b&gt;.png"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST_F(CompareImages, OfOtherSizesOrNothingDoesNotPass) {
  write("actual/", "a.png", ramp(64, 47));
  EXPECT_EQ(compared().exit_code, 1);
  EXPECT_TRUE(compared().says("a.png: different: 64 x 48 and 64 x 47 pixels"));
  std::filesystem::create_directories(folder / "empty");
  EXPECT_EQ(odontoscope({"compare-images", "empty", "empty"}).exit_code, 4) << "a comparison of nothing proves nothing";
  EXPECT_EQ(odontoscope({"compare-images", "expected", "missing"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"compare-images", "expected", "actual/a.png"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"compare-images", "expected", "actual", "--difference", "d.png"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"compare-images", "expected", "actual", "--mask", "actual/notes.txt"}).exit_code, 3);
}

TEST(ComparedPictures, HaveABoxAroundWhatDiffers) {
  const ImageDifference found = compare(ramp(), with_pixel(with_pixel(ramp(), 3, 20), 50, 4));
  EXPECT_EQ(found.box, (PixelBox{3, 4, 50, 20}));
  EXPECT_EQ(found.compared, 64u * 48u);
  EXPECT_FALSE(compare(ramp(), ramp()).box);
  EXPECT_EQ(cropped(ramp(), {3, 4, 5, 4}).pixel(2, 0), ramp().pixel(5, 4));
}

}  // namespace
}  // namespace odontoscope::testing_support
