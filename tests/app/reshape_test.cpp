// --crop, --resample, --upright and --as-given at the terminal.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

using nlohmann::json;

/// A rod of 4 x 3 mm, 16 mm long, leaning by 30 degrees in the plane of x and z; grey values fall off over a voxel, so
/// that its surface is smooth.
std::string leaning_rod(bool as_labels = false) {
  const double tilt = std::numbers::pi / 6;
  std::string text =
      "NRRD0004\ntype: short\ndimension: 3\nsizes: 36 20 44\nspace: left-posterior-superior\nspace directions: "
      "(0.5,0,0) (0,0.5,0) (0,0,0.5)\n"
      "space origin: (-9,5,100)\nencoding: text\n\n";
  for (int k = 0; k < 44; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 36; ++i) {
        const double x = (i - 17.5) / 2, y = (j - 9.5) / 2, z = (k - 21.5) / 2;
        const double along = z * std::cos(tilt) + x * std::sin(tilt), across = x * std::cos(tilt) - z * std::sin(tilt);
        const double depth = std::min({8 - std::abs(along), 2 - std::abs(across), 1.5 - std::abs(y)});
        const int value = static_cast<int>(std::lround(std::clamp(100 + 100 * depth, 0.0, 200.0)));
        text += std::to_string(as_labels ? (value >= 100 ? 7 : 0) : value) + " ";
      }
  return text;
}

class Reshape : public ProgramTest {
 protected:
  json report(const std::string& name) const { return json::parse(bytes_of(name)); }
};

TEST_F(Reshape, UprightTurnsTheLongestAxisToZAndTellsItsMatrix) {
  given("rod.nrrd", leaning_rod());
  const Ending ending =
      odontoscope({"reconstruct", "rod.nrrd", "--iso", "100", "--upright", "-o", "up.obj", "--report", "up.json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("stood upright: turned by 29.9")) << ending.out;  // its ends are cut across voxels
  const json up = report("up.json");
  EXPECT_NEAR(up["volume"]["upright"]["degrees"], 30, 0.5);
  EXPECT_EQ(up["volume"]["upright"]["as_given"], false);
  ASSERT_EQ(
      odontoscope({"reconstruct", "rod.nrrd", "--iso", "100", "-o", "plain.obj", "--report", "plain.json"}).exit_code,
      0);
  const double plain = report("plain.json")["surface"]["shells"][0]["volume"];
  EXPECT_NEAR(up["surface"]["shells"][0]["volume"], plain, 0.06 * plain) << "as large as it was";
  // Upright it is as high as long.
  const Ending cut = odontoscope({"contours", "up.obj", "--spacing-z", "1", "-o", "cut.json"});
  ASSERT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_NEAR(json::parse(bytes_of("cut.json"))["slices"].size(), 16, 1) << cut.out;
}

TEST_F(Reshape, AsGivenPutsTheModelBackWhereTheFileHasIt) {
  given("rod.nrrd", leaning_rod());
  ASSERT_EQ(
      odontoscope({"reconstruct", "rod.nrrd", "--iso", "100", "-o", "plain.obj", "--report", "plain.json"}).exit_code,
      0);
  const Ending ending = odontoscope({"reconstruct", "rod.nrrd", "--iso", "100", "--upright", "--as-given", "-o",
                                     "back.obj", "-o", "back.vtu", "--report", "back.json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const json back = report("back.json");
  EXPECT_EQ(back["volume"]["upright"]["as_given"], true);
  EXPECT_EQ(back["certified"], true);
  EXPECT_EQ(back["tetrahedra"]["non_positive"], 0);
  const auto middle_of = [&](const char* model) {
    EXPECT_EQ(odontoscope({"contours", model, "--at", "108", "--at", "112", "-o", "cut.json"}).exit_code, 0);
    double x = 0, count = 0;
    const json cut = json::parse(bytes_of("cut.json"));
    for (const json& point : cut["slices"][0]["contours"][0]["points"]) x += point[0].get<double>(), count += 1;
    return x / count;
  };
  EXPECT_NEAR(middle_of("back.obj"), middle_of("plain.obj"), 0.15);
}

TEST_F(Reshape, LabelsAreResampledByTheNearest) {
  given("rod.nrrd", leaning_rod(true));
  const Ending ending = odontoscope({"reconstruct", "rod.nrrd", "--label", "7=rod", "--resample", "0.4", "--upright",
                                     "-o", "a.glb", "--report", "a.json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("each with the label of the nearest")) << ending.out;
  EXPECT_NEAR(report("a.json")["surface"]["shells"][0]["volume"], 16 * 4 * 3, 0.1 * 192);
}

TEST_F(Reshape, ResampledGreyValuesKeepTheVolume) {
  given("rod.nrrd", leaning_rod());
  for (const char* spacing : {"0.25", "0.3", "0.7"}) {
    const Ending ending = odontoscope(
        {"reconstruct", "rod.nrrd", "--iso", "100", "--resample", spacing, "-o", "a.glb", "--report", "a.json"});
    ASSERT_EQ(ending.exit_code, 0) << ending.err;
    EXPECT_TRUE(ending.says("interpolated linearly")) << ending.out;
    EXPECT_NEAR(report("a.json")["surface"]["shells"][0]["volume"], 16 * 4 * 3, 0.08 * 192) << spacing;
  }
}

TEST_F(Reshape, CropKeepsPlacesAndTheHistogramTellsThem) {
  given("rod.nrrd", leaning_rod());
  EXPECT_TRUE(odontoscope({"contours", "rod.nrrd", "--histogram"})
                  .says("from -9 to 8.5 mm along x, 5 to 14.5 along y, 100 to 121.5 along z"));
  const Ending ending =
      odontoscope({"contours", "rod.nrrd", "--iso", "100", "--crop", "-9,8.5,5,14.5,108,112", "-o", "part.json"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("cropped to 36 x 20 x 9 voxels")) << ending.out;
  ASSERT_EQ(odontoscope({"contours", "rod.nrrd", "--iso", "100", "-o", "whole.json"}).exit_code, 0);
  const json part = json::parse(bytes_of("part.json")), whole = json::parse(bytes_of("whole.json"));
  for (const json& slice : part["slices"]) {
    const auto same = std::find(whole["slices"].begin(), whole["slices"].end(), slice);
    EXPECT_NE(same, whole["slices"].end()) << "z = " << slice["z"];
  }
}

TEST_F(Reshape, WhatMakesNoSenseIsSaid) {
  given("rod.nrrd", leaning_rod());
  given("cube.json", cube_stack());
  const std::vector<std::string> read{"contours", "rod.nrrd", "--iso", "100", "-o", "a.json"};
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{{"--crop", "1,2,3,4,5"},
                                                                                     {"--crop", "2,1,3,4,5,6"},
                                                                                     {"--crop", "a,b,c,d,e,f"},
                                                                                     {"--crop", "nan,1,0,1,0,1"},
                                                                                     {"--resample", "0"},
                                                                                     {"--resample", "-1"},
                                                                                     {"--resample", "nan"}}) {
    std::vector<std::string> words = read;
    words.insert(words.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(odontoscope(words).exit_code, 2) << wrong[0] << wrong[1];
  }
  EXPECT_EQ(odontoscope({"reconstruct", "cube.json", "--upright", "-o", "a.glb"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"reconstruct", "rod.nrrd", "--iso", "100", "--as-given", "-o", "a.glb"}).exit_code, 2);
  EXPECT_EQ(
      odontoscope({"reconstruct", "rod.nrrd", "--iso", "100", "--upright", "--as-given", "-o", "a.inp"}).exit_code, 2);
  const Ending fine = odontoscope({"contours", "rod.nrrd", "--iso", "100", "--resample", "0.001", "-o", "a.json"});
  EXPECT_EQ(fine.exit_code, 3) << fine.err;
  EXPECT_TRUE(fine.complains("[too-many-voxels]")) << fine.err;
  const Ending ball = odontoscope(
      {"contours", "rod.nrrd", "--iso", "100", "--crop", "-0.5,0.5,9,10.5,110,111.5", "--upright", "-o", "a.json"});
  EXPECT_EQ(ball.exit_code, 3) << ball.err;
  EXPECT_TRUE(ball.complains("[no-long-axis]")) << ball.err;
  EXPECT_FALSE(exists("a.json"));
}

}  // namespace
}  // namespace odontoscope::testing_support
