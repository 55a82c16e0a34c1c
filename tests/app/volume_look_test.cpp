// render --show: a volume's grey values as a user asks for them. What is drawn is judged in tests/raycast.
#include <cmath>

#include "engine/picture/png.h"
#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

/// A lump of dentine with an enamel cap, in air.
std::string nrrd(const std::string& value = "") {
  std::string text =
      "NRRD0004\ntype: short\ndimension: 3\nsizes: 16 14 18\nspace: left-posterior-superior\nspace directions: "
      "(0.5,0,0) (0,0.5,0) (0,0,0.5)\nencoding: text\n\n";
  for (int k = 0; k < 18; ++k)
    for (int j = 0; j < 14; ++j)
      for (int i = 0; i < 16; ++i) {
        const double way = std::hypot(i - 7.5, j - 6.5, 0.8 * (k - 8.5));
        const int grain = (7 * i + 5 * j + 3 * k) % 5;
        if (value == "labels") {
          text += way < 5 ? "1 " : "0 ";
          continue;
        }
        text += value.empty() ? std::to_string((way < 5 ? k > 11 ? 1700 : 1000 : 10) + grain) + " " : value + " ";
      }
  return text;
}

class VolumeLooks : public ProgramTest {
 protected:
  Ending shown(std::vector<std::string> more, const std::string& input = "a.nrrd") {
    std::vector<std::string> words{"render", input, "-o", "a.png", "--size", "80x60", "--samples", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return odontoscope(words);
  }
  Image image() { return read_png((folder / "a.png").string()); }
  bool cannot_draw(const Ending& ending) { return ending.exit_code == 5; }
};

TEST_F(VolumeLooks, NeedNoSurface) {
  given("a.nrrd", nrrd());
  const Ending ending = shown({"--show", "volume"});
  if (cannot_draw(ending)) GTEST_SKIP() << ending.err;
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("The volume is shown by 16 x 14 x 18 values")) << ending.out;
  EXPECT_TRUE(image().pixel(40, 30) != image().pixel(2, 2));
  EXPECT_TRUE(content_of(image()).shows_something());
}

TEST_F(VolumeLooks, ColourSurfacesByTheCt) {
  given("a.nrrd", nrrd());
  const Ending plain = shown({"--iso", "500"});
  if (cannot_draw(plain)) GTEST_SKIP() << plain.err;
  std::vector<Image> seen{image()};
  for (const char* words : {"distance", "distance=0.01", "slope"}) {
    const Ending ending = shown({"--iso", "500", "--colour-by", words});
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    EXPECT_TRUE(ending.says("mm from where the CT's values cross its own (median)")) << ending.out;
    for (const Image& other : seen) EXPECT_NE(image(), other) << words;
    seen.push_back(image());
  }
  EXPECT_TRUE(
      shown({"--iso", "500", "--colour-by", "hue"}).complains("there is no colouring of surfaces called \"hue\""));
  EXPECT_TRUE(shown({"--iso", "500", "--colour-by", "distance=-1"}).complains("no number above 0"));
  EXPECT_TRUE(shown({"--show", "volume", "--colour-by", "distance"})
                  .complains("there is no value of a CT at which the surface was taken"));
  EXPECT_TRUE(
      shown({"--radiograph", "--iso", "500", "--colour-by", "distance"}).complains("a film has no surfaces to colour"));
}

TEST_F(VolumeLooks, DifferInEveryWayToCast) {
  given("a.nrrd", nrrd());
  std::vector<Image> seen;
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{},
                                             {"--cast", "maximum"},
                                             {"--cast", "maximum=0,4000"},
                                             {"--cast", "average"},
                                             {"--cast", "radiograph"},
                                             {"--cast", "radiograph", "--grey", "10,3000"},
                                             {"--cast", "surface=500"},
                                             {"--transfer", "enamel"},
                                             {"--transfer", "pulp"},
                                             {"--slopes", "100,700"},
                                             {"--transfer", "500:#ff0000:0,900:#ff0000:9"},
                                             {"--grey", "10,500"}}) {
    std::vector<std::string> all{"--show", "volume"};
    all.insert(all.end(), words.begin(), words.end());
    const Ending ending = shown(all);
    if (cannot_draw(ending)) GTEST_SKIP() << ending.err;
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    for (const Image& other : seen) EXPECT_NE(image(), other) << all.back();
    seen.push_back(image());
  }
}

TEST_F(VolumeLooks, StandBesideSurfaces) {
  given("a.nrrd", nrrd());
  const Ending surfaces = shown({"--iso", "500"});
  if (cannot_draw(surfaces)) GTEST_SKIP() << surfaces.err;
  const Image alone = image();
  EXPECT_EQ(shown({"--iso", "500", "--show", "surfaces"}).exit_code, 0);
  EXPECT_EQ(image(), alone);
  const Ending both =
      shown({"--iso", "500", "--show", "both", "--section", "buccal", "--cap", "ct", "--save-scene", "s.json"});
  EXPECT_EQ(both.exit_code, 0) << both.err;
  const Image with_volume = image();
  EXPECT_NE(with_volume, alone);
  EXPECT_EQ(shown({"--iso", "500", "--scene", "s.json"}).exit_code, 0);
  EXPECT_EQ(image(), with_volume) << "a saved scene holds the look";
}

TEST_F(VolumeLooks, RefuseWhatMakesNoSense) {
  given("a.nrrd", nrrd());
  given("constant.nrrd", nrrd("7"));
  given("labels.nrrd", nrrd("labels"));
  given("cube.json", cube_stack());
  const auto code = [&](std::vector<std::string> words, const std::string& input) {
    const Ending ending = shown(std::move(words), input);
    if (cannot_draw(ending)) return 5;
    const auto first = ending.err.find("odontoscope: ");
    EXPECT_TRUE(first != std::string::npos && first == ending.err.rfind("odontoscope: ")) << ending.err;
    EXPECT_FALSE(exists("a.png"));
    return ending.exit_code;
  };
  if (code({"--show", "volume"}, "cube.json") == 5) GTEST_SKIP() << "no picture can be drawn here";
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--show", "all"},
                                             {"--cast", "shaded"},
                                             {"--transfer", "tooth"},
                                             {"--show", "both"},
                                             {"--show", "surfaces", "--cast", "maximum"},
                                             {"--show", "volume", "--cast", "net"},
                                             {"--show", "volume", "--cast", "maximum=5,5"},
                                             {"--show", "volume", "--cast", "maximum=nan,5"},
                                             {"--show", "volume", "--cast", "surface"},
                                             {"--show", "volume", "--cast", "surface=inf"},
                                             {"--show", "volume", "--cast", "shaded=4"},
                                             {"--show", "volume", "--slopes", "9,5"},
                                             {"--show", "volume", "--slopes", "5"},
                                             {"--show", "volume", "--slopes", "0,0"},
                                             {"--show", "volume", "--slopes", "-1,5"},
                                             {"--show", "volume", "--cast", "maximum", "--slopes", "5,9"},
                                             {"--slopes", "5,9"},
                                             {"--show", "volume", "--transfer", "bone"},
                                             {"--show", "volume", "--transfer", "5:#ff0000"},
                                             {"--show", "volume", "--transfer", "5:red:4"},
                                             {"--show", "volume", "--transfer", "5:#ff0000:-1"},
                                             {"--show", "volume", "--transfer", "9:#ff0000:1,5:#ff0000:1"},
                                             {"--show", "volume", "--transfer", ":"},
                                             {"--show", "volume", "--grey", "9,5"},
                                             {"--grey", "5,9", "--iso", "500"},
                                             {"--show", "both", "--iso", "500", "--cast", "average"},
                                             {"--show", "volume", "--upright"},
                                             {"--show", "volume", "--links", "x.json"},
                                             {"--radiograph", "--show", "volume"}})
    EXPECT_NE(code(words, "a.nrrd"), 0) << words[0] << " " << words.back();
  EXPECT_EQ(code({"--show", "volume"}, "constant.nrrd"), 3);
  EXPECT_EQ(code({"--show", "volume"}, "labels.nrrd"), 2);
  EXPECT_EQ(code({"--show", "both"}, "cube.json"), 2);
}

}  // namespace
}  // namespace odontoscope::testing_support
