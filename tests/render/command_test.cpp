// `render` and `compare-images` as a user meets them.

#include <cmath>
#include <cstdlib>

#include "engine/picture/png.h"
#include "tests/app/program.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

class RenderCommand : public ProgramTest {
 protected:
  void SetUp() override {
    const PerhapsContext made = try_context(Backend::automatic);
    if (!made.context) GTEST_SKIP() << "no picture can be drawn here: " << made.reason;
    given("cube.json", cube_stack());
  }
  Ending render(std::vector<std::string> options) {
    std::vector<std::string> words = {"render", "cube.json", "-o", "x.png", "--size", "120x90"};
    words.insert(words.end(), options.begin(), options.end());
    return odontoscope(words);
  }
  Image picture(const std::string& name = "x.png") { return read_png((folder / name).string()); }
};

TEST_F(RenderCommand, DrawsAContourStack) {
  const Ending ending = render({});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("Wrote x.png")) << ending.out;
  EXPECT_EQ(picture().width, 120);
  EXPECT_EQ(picture().height, 90);
  EXPECT_TRUE(content_of(picture()).shows_something());
}

TEST_F(RenderCommand, GivesTheSamePixelsFromASavedSceneAndEitherBackend) {
  ASSERT_EQ(render({"--view", "mesial", "--section", "1,1,0.2", "--colour", "tooth=#336699", "--save-scene", "s.json"})
                .exit_code,
            0);
  const Image first = picture();
  ASSERT_EQ(render({"--scene", "s.json", "--backend", "auto"}).exit_code, 0);
  EXPECT_EQ(picture(), first);
}

TEST_F(RenderCommand, TransparentBackgroundIsEmptyAtTheCorners) {
  ASSERT_EQ(render({"--background", "transparent"}).exit_code, 0);
  EXPECT_EQ(picture().pixel(0, 0)[3], 0);
  EXPECT_EQ(picture().pixel(60, 45)[3], 255);
}

TEST_F(RenderCommand, EverySampleCountWorks) {
  for (const char* samples : {"1", "4", "9", "16"}) {
    EXPECT_EQ(render({"--samples", samples}).exit_code, 0) << samples;
    EXPECT_TRUE(content_of(picture()).shows_something());
  }
}

TEST_F(RenderCommand, TurntableWritesAllAround) {
  ASSERT_EQ(render({"--turntable", "3"}).exit_code, 0);
  EXPECT_FALSE(exists("x.png"));
  for (const char* name : {"x-000.png", "x-001.png", "x-002.png"}) ASSERT_TRUE(exists(name)) << name;
  EXPECT_NE(picture("x-000.png"), picture("x-001.png"));
}

TEST_F(RenderCommand, OverlaysChangeThePictureAndComeBackFromASavedScene) {
  ASSERT_EQ(render({}).exit_code, 0);
  const Image plain = picture();
  for (const std::string overlay : {"contours", "tetrahedra", "tetrahedra=0"}) {
    ASSERT_EQ(render({"--overlay", overlay, "--save-scene", "s.json"}).exit_code, 0) << overlay;
    const Image drawn = picture();
    EXPECT_NE(drawn, plain) << overlay;
    ASSERT_EQ(render({"--scene", "s.json"}).exit_code, 0);
    EXPECT_EQ(picture(), drawn) << overlay;
  }
  ASSERT_EQ(render({"--overlay", "edges"}).exit_code, 0);
  EXPECT_EQ(picture(), plain) << "a certified model has no faulty edges";
}

TEST_F(RenderCommand, AMeshHasNoContoursAndNoTetrahedra) {
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "cube.stl"}).exit_code, 0);
  for (const char* overlay : {"contours", "tetrahedra"}) {
    const Ending ending = odontoscope({"render", "cube.stl", "-o", "x.png", "--overlay", overlay});
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_TRUE(ending.complains("contour stack")) << ending.err;
    EXPECT_FALSE(exists("x.png"));
  }
  EXPECT_EQ(odontoscope({"render", "cube.stl", "-o", "x.png", "--overlay", "edges"}).exit_code, 0);
}

/// A ball whose values fall from its middle outwards, as NRRD in text.
std::string ball_volume() {
  std::string text = "NRRD0004\ntype: float\ndimension: 3\nsizes: 12 12 12\nspacings: 1 1 1\nencoding: ascii\n\n";
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i) text += std::to_string(200 - 20 * std::hypot(i - 5.5, j - 5.5, k - 5.5)) + "\n";
  return text;
}

TEST_F(RenderCommand, ACapShowsAVolumesValuesAndComesBackFromASavedScene) {
  given("ball.nrrd", ball_volume());
  const auto render_ball = [&](std::vector<std::string> options) {
    std::vector<std::string> words = {"render", "ball.nrrd", "--iso", "120", "-o", "x.png", "--size", "120x90"};
    words.insert(words.end(), options.begin(), options.end());
    return odontoscope(words);
  };
  ASSERT_EQ(render_ball({"--section", "buccal", "--view", "buccal"}).exit_code, 0);
  const Image material = picture();
  const Ending usual = render_ball({"--section", "buccal", "--view", "buccal", "--cap", "ct"});
  ASSERT_EQ(usual.exit_code, 0) << usual.err;
  EXPECT_TRUE(usual.says("(black)")) << usual.out;
  EXPECT_NE(picture(), material);
  const Ending told =
      render_ball({"--section", "buccal", "--view", "buccal", "--cap", "ct=100,180", "--save-scene", "s.json"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(told.says("from 100 (black) to 180 (white)")) << told.out;
  const Image drawn = picture();
  EXPECT_EQ(drawn.pixel(60, 45), (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
  ASSERT_EQ(render_ball({"--scene", "s.json"}).exit_code, 0);
  EXPECT_EQ(picture(), drawn);
  ASSERT_EQ(render_ball({"--scene", "s.json", "--cap", "material"}).exit_code, 0);
  EXPECT_NE(picture(), drawn);
  const Ending whole = render_ball({"--cap", "ct"});
  EXPECT_EQ(whole.exit_code, 2);
  EXPECT_TRUE(whole.complains("--section")) << whole.err;
}

TEST_F(RenderCommand, OnlyAVolumeHasValuesForTheCap) {
  given(
      "s.json",
      R"({"format":"odontoscope.scene","version":1,"section":{"point":[0,0,0],"normal":[0,1,0]},"cap":{"shows":"ct"}})");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--section", "buccal", "--cap", "ct"}, {"--scene", "s.json"}}) {
    const Ending ending = render(words);
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_TRUE(ending.complains("with --iso")) << ending.err;
    EXPECT_FALSE(exists("x.png"));
  }
  EXPECT_EQ(render({"--scene", "s.json", "--cap", "material"}).exit_code, 0);
}

TEST_F(RenderCommand, AnswersSenselessWordsAndTouchesNoFile) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> wrong = {
      {{"--hide", "enamel"}, "There are: tooth"},
      {{"--view", "sideways"}, "three-quarter"},
      {{"--section", "diagonal"}, "buccal"},
      {{"--section", "+x@here"}, "is no number"},
      {{"--opacity", "tooth"}, "tooth"},
      {{"--opacity", "tooth=1.1"}, "between 0 and 1"},
      {{"--colour", "tooth=ivory"}, "six hexadecimal digits"},
      {{"--background", "sky"}, "six hexadecimal digits"},
      {{"--cull", "sometimes"}, "on, off or tint"},
      {{"--samples", "5"}, "16"},
      {{"--backend", "paper"}, "osmesa"},
      {{"--cap", "bone"}, "material, plain, ct"},
      {{"--cap", "ct=5"}, "material, plain, ct"},
      {{"--cap", "ct=5,x"}, "is no number"},
      {{"--cap", "ct=5,nan"}, "is no number"},
      {{"--cap", "ct=9,5"}, "no range of values"},
      {{"--overlay", "spirals"}, "contours, edges or tetrahedra"},
      {{"--overlay", "tetrahedra=x"}, "no number of a slab"},
      {{"--overlay", "tetrahedra="}, "no number of a slab"},
      {{"--overlay", "tetrahedra=1"}, "from 0 to 0"},
      {{"--turntable", "0"}, "whole number"},
  };
  for (const auto& [options, answer] : wrong) {
    const Ending ending = render(options);
    EXPECT_EQ(ending.exit_code, 2) << options[0] << " " << options[1];
    EXPECT_TRUE(ending.complains(answer)) << ending.err;
    EXPECT_FALSE(exists("x.png")) << options[0];
  }
}

TEST_F(RenderCommand, RefusesSizesThatAreNone) {
  for (const char* size : {"12", "0x9", "9x0", "-3x4", "9x9x9", "99999x9", "x"}) {
    const Ending ending = odontoscope({"render", "cube.json", "-o", "x.png", "--size", size});
    EXPECT_EQ(ending.exit_code, 2) << size;
    EXPECT_TRUE(ending.complains("1200x900")) << ending.err;
  }
}

TEST_F(RenderCommand, RefusesABadSceneFile) {
  given("s.json", R"({"format":"odontoscope.scene","version":1,"wire":"yes"})");
  const Ending ending = render({"--scene", "s.json"});
  EXPECT_EQ(ending.exit_code, 3);
  EXPECT_TRUE(ending.complains("s.json")) << ending.err;
  EXPECT_FALSE(exists("x.png"));
}

TEST_F(RenderCommand, SaysWhyNoPictureCanBeDrawnAndFallsThrough) {
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/no/such/vendor", 1);
  const Ending egl = render({"--backend", "egl"}), automatic = render({});
  ::unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  if (egl.exit_code == 0) GTEST_SKIP() << "this EGL cannot be hidden";
  EXPECT_EQ(egl.exit_code, 5);
  EXPECT_TRUE(egl.complains("[no-egl]")) << egl.err;
  if (try_context(Backend::osmesa).context) {
    EXPECT_EQ(automatic.exit_code, 0) << automatic.err;
    EXPECT_TRUE(automatic.says("Drawn with osmesa"));
  }
}

TEST_F(RenderCommand, SaysThatOpenGlIsTooOld) {
  ::setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
  const Ending ending = render({});
  ::unsetenv("MESA_GL_VERSION_OVERRIDE");
  if (ending.exit_code == 0) GTEST_SKIP() << "not Mesa";
  EXPECT_EQ(ending.exit_code, 5);
  EXPECT_TRUE(ending.complains("[gl-too-old]")) << ending.err;
}

class CompareImagesCommand : public ProgramTest {};

TEST_F(CompareImagesCommand, TellsAlikeFromDifferent) {
  Image a(20, 10), b(20, 10);
  for (std::size_t i = 3; i < a.rgba.size(); i += 4) a.rgba[i] = b.rgba[i] = 255;
  b.set_pixel(3, 3, {9, 0, 0, 255});
  write_png(a, (folder / "a.png").string());
  write_png(b, (folder / "b.png").string());
  EXPECT_EQ(odontoscope({"compare-images", "a.png", "a.png"}).exit_code, 0);
  EXPECT_EQ(odontoscope({"compare-images", "a.png", "b.png"}).exit_code, 0) << "one pixel of 200";
  const Ending strict = odontoscope({"compare-images", "a.png", "b.png", "--share", "0", "--difference", "d.png"});
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_TRUE(strict.says("1 of 200 pixels")) << strict.out;
  EXPECT_EQ(read_png((folder / "d.png").string()).pixel(0, 0)[0], 0);
  EXPECT_GT(read_png((folder / "d.png").string()).pixel(3, 3)[0], 0);
  EXPECT_EQ(odontoscope({"compare-images", "a.png", "b.png", "--share", "0", "--channel", "9"}).exit_code, 0);
  EXPECT_EQ(odontoscope({"compare-images", "a.png", "missing.png"}).exit_code, 4);
  given("text.png", "no picture");
  EXPECT_EQ(odontoscope({"compare-images", "a.png", "text.png"}).exit_code, 3);
}

}  // namespace
}  // namespace odontoscope::testing_support
