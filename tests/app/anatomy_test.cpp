// Anatomy and films as a user meets them.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class AnatomyCommand : public ProgramTest {
 protected:
  void SetUp() override {
    given("block.json", R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[
      {"z":0,"contours":[{"points":[[0,0],[8,0],[8,8],[0,8]]}]},{"z":2,"contours":[{"points":[[0,0],[8,0],[8,8],[0,8]]}]}]})");
  }
};

TEST_F(AnatomyCommand, TellsTheSamplePremolarsCanalsByName) {
  ASSERT_EQ(odontoscope({"sample", "premolar", "-o", "p.json"}).exit_code, 0);
  const Ending told = odontoscope({"anatomy", "p.json", "-o", "a.json", "-o", "a.csv"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(told.says("buccal canal")) << told.out;
  EXPECT_TRUE(told.says("Vertucci I")) << told.out;
  const auto made = nlohmann::json::parse(bytes_of("a.json"));
  EXPECT_EQ(made.at("format"), "odontoscope.anatomy");
  EXPECT_EQ(made.at("source"), "p.json");
  ASSERT_EQ(made.at("canals").size(), 2u);
  EXPECT_EQ(made.at("roots").size(), 2u);
  EXPECT_GT(made.at("canals")[0].at("length"), 10);
  const std::string csv = bytes_of("a.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  // The same from the mesh of it.
  ASSERT_EQ(odontoscope({"reconstruct", "p.json", "-o", "p.glb"}).exit_code, 0);
  EXPECT_TRUE(odontoscope({"anatomy", "p.glb"}).says("lingual canal"));
  // And on one thread the same bytes.
  ASSERT_EQ(odontoscope({"anatomy", "p.json", "--threads", "1", "-o", "b.json"}).exit_code, 0);
  EXPECT_EQ(bytes_of("b.json"), bytes_of("a.json"));
}

TEST_F(AnatomyCommand, TellsTheSameOfAModelInAFile) {
  ASSERT_EQ(odontoscope({"sample", "premolar", "--slice-spacing", "0.3", "-o", "p.json"}).exit_code, 0);
  ASSERT_EQ(odontoscope({"anatomy", "p.json", "-o", "contours.json"}).exit_code, 0);
  ASSERT_EQ(odontoscope({"reconstruct", "p.json", "-o", "p.glb", "-o", "p.gltf"}).exit_code, 0);
  const auto contours = nlohmann::json::parse(bytes_of("contours.json"));
  for (const std::string file : {"p.glb", "p.gltf"}) {
    ASSERT_EQ(odontoscope({"anatomy", file, "-o", file + ".json"}).exit_code, 0);
    const auto model = nlohmann::json::parse(bytes_of(file + ".json"));
    // The slices given, whatever was interpolated between them.
    EXPECT_NEAR(model.at("slice_spacing").get<double>(), 0.3, 1e-4) << file;
    EXPECT_NEAR(contours.at("slice_spacing").get<double>(), 0.3, 1e-4);
    ASSERT_EQ(model.at("canals").size(), contours.at("canals").size());
    for (std::size_t c = 0; c < model.at("canals").size(); ++c)
      for (const char* figure : {"length", "mean_width"}) {
        const double one = contours.at("canals")[c].at(figure), other = model.at("canals")[c].at(figure);
        EXPECT_NEAR(one, other, 0.02 * one) << figure << " in " << file;
      }
  }
}

TEST_F(AnatomyCommand, WithoutAVoidSaysSoAndEndsWithOne) {
  const Ending told = odontoscope({"anatomy", "block.json"});
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_TRUE(told.says("No void inside")) << told.out;
}

TEST_F(AnatomyCommand, RefusesWhatMakesNoSense) {
  const std::vector<std::string> before = folder.names();
  EXPECT_EQ(odontoscope({"anatomy", "block.json", "-o", "a.txt"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"anatomy", "block.json", "-o", "block.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"anatomy", "missing.json"}).exit_code, 4);
  EXPECT_EQ(odontoscope({"render", "block.json", "--tour", "canal-1", "-o", "film.avi"}).exit_code, 2);
  EXPECT_TRUE(odontoscope({"render", "block.json", "--tour", "canal-1", "-o", "film.avi"}).complains("tour.mp4"));
  EXPECT_EQ(odontoscope({"render", "block.json", "--tour", "canal-1", "--turntable", "3", "-o", "."}).exit_code, 2);
  EXPECT_EQ(odontoscope({"render", "block.json", "--frames", "3", "-o", "a.png"}).exit_code, 2);
  EXPECT_EQ(folder.names(), before);
}

}  // namespace
}  // namespace odontoscope::testing_support
