// render --radiograph as a user meets it.
#include <cmath>
#include <functional>

#include "engine/picture/png.h"
#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Radiographs : public ProgramTest {
 protected:
  Image film(const std::string& name) { return read_png((folder / name).string()); }
  static int grey(const Image& image, int x, int y) {
    EXPECT_EQ(image.pixel(x, y)[0], image.pixel(x, y)[1]);
    EXPECT_EQ(image.pixel(x, y)[3], 255);
    return image.pixel(x, y)[0];
  }
  Ending taken(std::vector<std::string> more) {
    std::vector<std::string> words{"render", "in", "--radiograph", "-o", "film.png"};
    words[1] = input;
    words.insert(words.end(), more.begin(), more.end());
    return odontoscope(words);
  }
  std::string input = "cube.json";
};

// A cube of 1 mm of dentine swallows what the program says a mm of it does.
TEST_F(Radiographs, ShowWhatSolidsSwallow) {
  given("cube.json", cube_stack());
  const Ending ending = taken({"--beam", "parallel", "--film", "4x4", "--pixel", "0.1", "--attenuation", "tooth=2"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("Radiograph at 70 kV, as of 35 keV: attenuation per mm: tooth 2")) << ending.out;
  const Image image = film("film.png");
  EXPECT_EQ(image.width, 40);
  EXPECT_EQ(image.height, 40);
  EXPECT_EQ(grey(image, 20, 20), 128);  // 2 of 4
  EXPECT_EQ(grey(image, 2, 2), 0);
  EXPECT_EQ(taken({"--beam", "parallel", "--film", "4x4", "--pixel", "0.1", "--attenuation", "tooth=2", "--inverted",
                   "--exposure", "2.718281828"})
                .exit_code,
            0);
  EXPECT_EQ(grey(film("film.png"), 20, 20), 191);  // 255 - 64
}

TEST_F(Radiographs, AreTakenAllAround) {
  given("cube.json", cube_stack());
  EXPECT_EQ(taken({"--turntable", "3", "--film", "4x4", "--pixel", "0.2"}).exit_code, 0);
  for (const char* name : {"film-000.png", "film-001.png", "film-002.png"})
    EXPECT_GT(grey(film(name), 10, 10), 5) << name;
  EXPECT_NE(film("film-000.png"), film("film-001.png"));
}

std::string nrrd(const std::string& more = "") {
  std::string text =
      "NRRD0004\ntype: short\ndimension: 3\nsizes: 12 12 8\nspace: left-posterior-superior\nspace directions: "
      "(0.5,0,0) (0,0.5,0) (0,0,1)\n" +
      more + "encoding: text\n\n";
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i)
        text += (i > 0 && j > 0 && i < 11 && j < 11 ? std::to_string(1000 + (i + j + k) % 3)
                                                    : std::to_string(20 + (i + k) % 9)) +
                " ";
  return text;
}

TEST_F(Radiographs, ShowWhatVoxelsSwallow) {
  given("a.nrrd", nrrd());
  input = "a.nrrd";
  const Ending itself = taken({"--beam", "parallel", "--kv", "60"});
  EXPECT_EQ(itself.exit_code, 0) << itself.err;
  EXPECT_TRUE(itself.says("value 2") && itself.says("is taken as air and 100")) << itself.out;
  const Ending told = taken({"--beam", "parallel", "--grey", "20,1000", "--film", "10x10", "--pixel", "0.1"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  // 10 voxels of 0.5 mm and half of their neighbours': 5 mm of dentine at 0.228 a mm, and a little of the neighbours.
  EXPECT_NEAR(grey(film("film.png"), 50, 50), 255 * 0.228 * 5 / 4, 3);
  EXPECT_EQ(grey(film("film.png"), 2, 2), 0);
}

// Both kinds agree on one thing.
TEST_F(Radiographs, OfAVolumeAndOfItsModelAreAlike) {
  given("a.nrrd", nrrd());
  input = "a.nrrd";
  EXPECT_EQ(taken({"--grey", "20,1001", "--film", "10x10", "--pixel", "0.1"}).exit_code, 0);
  const Image voxels = film("film.png");
  const Ending ending = taken({"--iso", "510", "--film", "10x10", "--pixel", "0.1"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  const Image solid = film("film.png");
  for (const auto& [x, y] : {std::pair{50, 50}, {40, 35}, {60, 60}})
    EXPECT_NEAR(grey(voxels, x, y), grey(solid, x, y), 3);
}

TEST_F(Radiographs, RefuseWhatMakesNoSense) {
  given("cube.json", cube_stack());
  given("a.nrrd", nrrd());
  given("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
  given("inside_out.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  const auto code = [&](const std::string& file, std::vector<std::string> more) {
    input = file;
    const Ending ending = taken(std::move(more));
    const auto first = ending.err.find("odontoscope: ");  // one complaint, and nothing else but stages
    EXPECT_TRUE(first != std::string::npos && first == ending.err.rfind("odontoscope: ")) << ending.err;
    EXPECT_FALSE(exists("film.png"));
    return ending.exit_code;
  };
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--section", "buccal"},
                                             {"--size", "20x20"},
                                             {"--tube", "80,0"},
                                             {"--tube", "1"},
                                             {"--tube", "nan,0"},
                                             {"--film", "0x4"},
                                             {"--film", "9"},
                                             {"--film", "1e5x1e5"},
                                             {"--pixel", "1e-6"},
                                             {"--pixel", "nan"},
                                             {"--beam", "fan"},
                                             {"--beam", "parallel", "--focus", "9"},
                                             {"--focus", "0.5"},
                                             {"--kv", "5"},
                                             {"--exposure", "0"},
                                             {"--exposure", "inf"},
                                             {"--attenuation", "crown=1"},
                                             {"--attenuation", "tooth=-1"},
                                             {"--attenuation", "tooth"},
                                             {"--attenuation", "=1"},
                                             {"--grey", "1,2"},
                                             {"--hide", "tooth"},
                                             {"--hide", "x"}})
    EXPECT_EQ(code("cube.json", words), 2) << words[0] << " " << words[1];
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--grey", "5,5"},
                                                                                     {"--grey", "9,5"},
                                                                                     {"--grey", "a,b"},
                                                                                     {"--attenuation", "tooth=1"},
                                                                                     {"--hide", "tooth"},
                                                                                     {"--upright"}})
    EXPECT_EQ(code("a.nrrd", words), 2) << words[0];
  EXPECT_EQ(code("open.obj", {"--attenuation", "open=1"}), 3);
  EXPECT_EQ(code("inside_out.obj", {"--attenuation", "inside_out=1"}), 3);
  EXPECT_EQ(code("open.obj", {}), 3);
  EXPECT_EQ(odontoscope({"render", "cube.json", "--kv", "60", "-o", "film.png"}).exit_code, 2);
}

TEST_F(Radiographs, AskForTheTissueOfANameThatTellsNone) {
  given("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  input = "t.obj";
  const Ending ending = taken({});
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_TRUE(ending.complains("--attenuation \"t\"=dentine")) << ending.err;
  EXPECT_EQ(taken({"--attenuation", "t=enamel"}).exit_code, 0);
}

}  // namespace
}  // namespace odontoscope::testing_support
