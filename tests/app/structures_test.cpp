// Contours and solids written for viewers of images, and read again.

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Structures : public ProgramTest {
 protected:
  void SetUp() override { given("cube.json", cube_stack()); }
  Ending must(const std::vector<std::string>& arguments) {
    const Ending ending = odontoscope(arguments);
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    return ending;
  }
  /// Nothing is written, and the message has these words.
  void expect_misuse(const std::vector<std::string>& arguments, const std::string& words) {
    const std::vector<std::string> before = folder.names();
    const Ending ending = odontoscope(arguments);
    EXPECT_EQ(ending.exit_code, 2) << ending.out;
    EXPECT_TRUE(ending.complains(words)) << ending.err;
    EXPECT_EQ(folder.names(), before);
  }
};

TEST_F(Structures, ComeBackFromAStructureSetToTheByte) {
  const Ending written = must({"contours", "cube.json", "-o", "a.dcm", "-o", "a.json"});
  EXPECT_TRUE(written.says("a.dcm belongs to a new study without a patient")) << written.out;
  must({"contours", "a.dcm", "-o", "b.json"});
  EXPECT_EQ(bytes_of("b.json"), bytes_of("a.json"));
  must({"contours", "a.dcm", "-o", "c.dcm"});
  EXPECT_NE(bytes_of("c.dcm"), "");
}

TEST_F(Structures, ComeBackFromALabelMapByName) {
  must({"contours", "cube.json", "--voxels", "0.1,0.1,1", "-o", "a.seg.nrrd", "-o", "a.seg.dcm"});
  const Ending read = must({"contours", "a.seg.nrrd", "--label", "tooth", "-o", "b.json"});
  EXPECT_TRUE(read.says("tooth: 2 contours")) << read.out;
  must({"contours", "a.seg.dcm", "--label", "tooth", "-o", "d.json"});
  EXPECT_EQ(bytes_of("d.json"), bytes_of("b.json"));
  must({"contours", "b.json", "--voxels", "0.1,0.1,1", "--voxel-origin", "-0.1,-0.1,0", "-o", "c.seg.nrrd"});
  must({"contours", "c.seg.nrrd", "--label", "tooth", "-o", "c.json"});
  EXPECT_EQ(nlohmann::json::parse(bytes_of("c.json"))["slices"][0]["contours"][0]["points"].size(),
            nlohmann::json::parse(bytes_of("b.json"))["slices"][0]["contours"][0]["points"].size());
}

TEST_F(Structures, OfSolidsFillTheSpaceBetweenSlices) {
  const Ending ending = must({"reconstruct", "cube.json", "--voxels", "0.1,0.1,0.1", "--voxel-origin", "0.05,0.05,0.05",
                              "-o", "a.seg.nrrd", "-o", "a.seg.dcm", "-o", "a.stl"});
  EXPECT_TRUE(ending.says("tooth: 1,000 voxels (1 mm^3)")) << ending.out;
  EXPECT_TRUE(exists("a.seg.dcm"));
  EXPECT_TRUE(exists("a.stl"));
}

TEST_F(Structures, AreRefusedBeforeTheWork) {
  expect_misuse({"contours", "cube.json", "-o", "a.seg.nrrd"}, "nothing says how large its voxels are");
  expect_misuse({"reconstruct", "cube.json", "-o", "a.seg.dcm"}, "nothing says how large its voxels are");
  expect_misuse({"reconstruct", "cube.json", "--voxels", "1,1", "-o", "a.seg.dcm"}, "1,1");
  expect_misuse({"reconstruct", "cube.json", "--voxels", "1,1,1", "--voxel-origin", "1,x,1", "-o", "a.seg.dcm"},
                "--voxel-origin");
  expect_misuse({"reconstruct", "cube.json", "--voxels", "1,1,1", "-o", "a.stl"}, "files of voxels");
  expect_misuse({"reconstruct", "cube.json", "--method", "db", "--voxels", "1,1,1", "-o", "a.seg.nrrd"},
                "have no inside");
  expect_misuse({"contours", "cube.json", "-o", "a.txt"}, ".seg.dcm");
}

TEST_F(Structures, OfContoursAreAsThickAsSlicesAreApart) {
  expect_misuse({"contours", "cube.json", "--voxels", "0.1,0.1,0.1", "-o", "a.seg.nrrd"}, "--voxels 0.1,0.1,1");
  expect_misuse({"contours", "cube.json", "--voxels", "0.00001,0.00001,1", "-o", "a.seg.nrrd"}, "Make voxels larger");
}

TEST_F(Structures, TooThinForAVoxelAreWarnedAbout) {
  const Ending ending =
      must({"reconstruct", "cube.json", "--voxels", "4,4,4", "--voxel-origin", "-1,-1,-1", "-o", "a.seg.nrrd"});
  EXPECT_TRUE(ending.complains("no voxel's centre lies in tooth")) << ending.err;
  expect_misuse({"reconstruct", "cube.json", "--voxels", "4,4,4", "--voxel-origin", "-1,-1,-1", "-o", "a.seg.dcm"},
                "nothing to write as a segmentation");
}

}  // namespace
}  // namespace odontoscope::testing_support
