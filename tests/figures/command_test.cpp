// `figures` as a user meets it.

#include <filesystem>

#include "engine/picture/png.h"
#include "tests/app/program.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

class FiguresCommand : public ProgramTest {
 protected:
  void SetUp() override {
    const PerhapsContext made = try_context(Backend::automatic);
    if (!made.context) GTEST_SKIP() << "no picture can be drawn here: " << made.reason;
  }
  std::size_t files_in(const std::string& name) const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / name)) ++count;
    return count;
  }
};

TEST_F(FiguresCommand, WritesPicturesAndAPageIntoANewFolder) {
  const Ending ending = odontoscope({"figures", "-o", "made", "--only", "9", "--only", "7", "--size", "80"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("7 pictures in 2 figures")) << ending.out;
  EXPECT_EQ(files_in("made"), 8u);
  const Image picture = read_png((folder / "made" / "figure-09b.png").string());
  EXPECT_EQ(picture.width, 80);
  EXPECT_TRUE(content_of(picture).shows_something());
  const std::string page = bytes_of("made/index.html");
  EXPECT_LT(page.find("figure-07a.png"), page.find("figure-09a.png"));
  EXPECT_EQ(page.find("figure-08a.png"), std::string::npos);
}

TEST_F(FiguresCommand, ShowsTheContoursThatItIsGiven) {
  given("cube.json", cube_stack());
  const Ending ending =
      odontoscope({"figures", "cube.json", "-o", "made", "--only", "1", "--size", "80", "--grid", "16"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_NE(bytes_of("made/index.html").find("cube.json"), std::string::npos);
}

TEST_F(FiguresCommand, WritesNothingIfAFigureCannotBeMade) {
  given("cube.json", cube_stack());
  const Ending ending = odontoscope(
      {"figures", "cube.json", "-o", "made", "--only", "1", "--only", "17", "--size", "80", "--grid", "16"});
  EXPECT_EQ(ending.exit_code, 3);
  EXPECT_TRUE(ending.complains("no cavity")) << ending.err;
  EXPECT_FALSE(exists("made"));
}

TEST_F(FiguresCommand, RefusesBeforeTheWork) {
  given("a-file", "kept");
  EXPECT_EQ(odontoscope({"figures", "-o", "a-file"}).exit_code, 4);
  EXPECT_EQ(bytes_of("a-file"), "kept");
  EXPECT_EQ(odontoscope({"figures", "-o", "missing/made"}).exit_code, 4);
  EXPECT_EQ(odontoscope({"figures", "-o", "made", "--only", "19"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"figures", "-o", "made", "--size", "8"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"figures", "-o", "made", "--iso", "120"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"figures", "nothing.json", "-o", "made"}).exit_code, 4);
  EXPECT_FALSE(exists("made"));
}

}  // namespace
}  // namespace odontoscope::testing_support
