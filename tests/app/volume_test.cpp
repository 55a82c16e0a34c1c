// Volumes at the terminal: thresholds without knowing numbers, labels by name, small contours, and what a file does not
// say.

#include <functional>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

/// A NRRD in text, 12 x 12 x 8 voxels.
std::string nrrd(
    const std::function<int(int i, int j, int k)>& value,
    const std::string& more = "space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,1)\n") {
  std::string text = "NRRD0004\ntype: short\ndimension: 3\nsizes: 12 12 8\n" + more + "encoding: text\n\n";
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i) text += std::to_string(value(i, j, k)) + " ";
  return text;
}

bool inside(int i, int j) { return i > 0 && j > 0 && i < 11 && j < 11; }

/// A block of about 1000 in about 100, with a canal of one voxel of about 100.
int block(int i, int j, int k) {
  const int grain = (7 * i + 5 * j + 3 * k) % 11;
  return (inside(i, j) && !(i == 4 && j == 4) ? 1000 : 100) + grain;
}

class Volumes : public ProgramTest {};

TEST_F(Volumes, AreContouredWithoutKnowingTheirNumbers) {
  given("a.nrrd", nrrd(block));
  const Ending ending = odontoscope({"contours", "a.nrrd", "--iso", "auto", "-o", "a.json"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("Otsu's thresholds: 2 classes 55")) << ending.out;  // (110 + 1000) / 2
  EXPECT_TRUE(ending.says("tooth (at 55")) << ending.out;
  EXPECT_EQ(odontoscope({"contours", "a.nrrd", "--iso", "auto:3/2=enamel", "-o", "a.json"}).exit_code, 0);
  for (const char* wrong : {"auto:3/3", "auto:9/1", "auto:3", "automatic"})
    EXPECT_EQ(odontoscope({"contours", "a.nrrd", "--iso", wrong, "-o", "b.json"}).exit_code, 2) << wrong;
}

TEST_F(Volumes, ShowTheirHistogram) {
  given("a.nrrd", nrrd(block));
  const Ending ending = odontoscope({"contours", "a.nrrd", "--histogram"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("|##")) << ending.out;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.nrrd"}));
  EXPECT_EQ(odontoscope({"contours", "a.nrrd", "--iso", "5"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"contours", "a.nrrd", "--histogram", "-o", "a.json"}).exit_code, 2);
}

TEST_F(Volumes, CountSmallContoursInPixelsAndWarnOfCanals) {
  given("a.nrrd", nrrd(block));
  const Ending pixels = odontoscope({"contours", "a.nrrd", "--iso", "500", "--min-area", "2", "-o", "a.json"});
  EXPECT_EQ(pixels.exit_code, 0) << pixels.err;
  EXPECT_TRUE(pixels.says("left out 8 holes")) << pixels.out;
  EXPECT_TRUE(
      pixels.says("Warning: tooth: 8 of those left out go on in a neighbouring slice, the longest through 8 slices"))
      << pixels.out;
  // A pixel has 0.25 mm^2: two of them are half a square millimetre.
  EXPECT_TRUE(odontoscope({"contours", "a.nrrd", "--iso", "500", "--min-area", "0.5mm2", "-o", "a.json"})
                  .says("left out 8 holes"));
  // Crossings lie at 39/89 of 0.5 mm from the hole's middle: 2 (0.219 mm)^2 = 0.096 mm^2.
  EXPECT_FALSE(
      odontoscope({"contours", "a.nrrd", "--iso", "500", "--min-area", "0.09mm2", "-o", "a.json"}).says("left out"));
  for (const char* wrong : {"-1", "nan", "4cm2", "x", "mm2"})
    EXPECT_EQ(odontoscope({"contours", "a.nrrd", "--iso", "500", "--min-area", wrong, "-o", "b.json"}).exit_code, 2)
        << wrong;
}

TEST_F(Volumes, TellOfACanalThatFallsToPieces) {
  given("a.nrrd", nrrd([](int i, int j, int k) { return inside(i, j) && !(i == 2 + k && j == 2 + k) ? 1 : 0; }));
  EXPECT_TRUE(odontoscope({"contours", "a.nrrd", "--iso", "1", "-o", "a.json"}).says("may fall to pieces"));
}

TEST_F(Volumes, OfLabelsAreToldFromImagesAndTakenByName) {
  const auto labels = [](int i, int j, int) { return !inside(i, j) ? 0 : i == 4 && j == 4 ? 2 : 1; };
  given("map.nrrd",
        nrrd(labels, "Segment0_Name:=Dentine\nSegment0_LabelValue:=1\nSegment1_Name:=Pulp\nSegment1_LabelValue:=2\n"));
  const Ending grey = odontoscope({"contours", "map.nrrd", "--iso", "1", "-o", "a.json"});
  EXPECT_TRUE(grey.says("looks like a label map, with the labels 1=Dentine, 2=Pulp")) << grey.out;
  EXPECT_TRUE(odontoscope({"contours", "map.nrrd", "--label", "pulp=canal", "--label", "1", "-o", "a.json"})
                  .says("canal: 8 contours"));
  EXPECT_TRUE(odontoscope({"contours", "map.nrrd", "--label", "2", "-o", "a.json"}).says("Pulp: 8 contours"));
  given("names.txt", "# names\n1 0 0 0 1 1 1 \"Tooth\"\n2 9 9 9 1 1 1 \"Root canal\"\n");
  EXPECT_TRUE(
      odontoscope({"contours", "map.nrrd", "--label-names", "names.txt", "--label", "Root canal", "-o", "a.json"})
          .says("Root canal: 8 contours"));
  const Ending none = odontoscope({"contours", "map.nrrd", "--label", "Enamel", "-o", "b.json"});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_TRUE(none.complains("Dentine (1), Pulp (2)")) << none.err;
}

TEST_F(Volumes, AreKnownWhateverTheirNames) {
  given("scan", nrrd(block, ""));
  given("IM0001", std::string(128, '\0') + "DICM");
  for (const char* name : {"scan", "IM0001"}) {
    const Ending ending = odontoscope({"reconstruct", name, "-o", "a.glb"});
    EXPECT_EQ(ending.exit_code, 2) << name;
    EXPECT_TRUE(ending.complains("looks like a volume")) << ending.err;
  }
  EXPECT_EQ(odontoscope({"render", "scan", "--show", "volume", "-o", "a.png"}).exit_code, 0);
}

TEST_F(Volumes, SayWhatTheyAssume) {
  given("a.nrrd", nrrd(block, ""));
  EXPECT_TRUE(
      odontoscope({"contours", "a.nrrd", "--iso", "500", "-o", "a.json"}).says("1 mm is assumed; --spacing X,Y,Z"));
  EXPECT_EQ(odontoscope({"reconstruct", "a.nrrd", "--allow-outside", "-o", "b.glb"}).exit_code, 2);
}

TEST_F(Volumes, LabelsThatShareWallsBecomeOnePartition) {
  given("map.nrrd", nrrd([](int i, int j, int) { return !inside(i, j) ? 0 : i == 4 && j == 4 ? 2 : 1; }));
  const auto made = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"reconstruct", "map.nrrd", "--label", "1=dentine", "--label",
                                   "2=pulp",      "-o",       "a.glb",   "--report",  "a.json"};
    words.insert(words.end(), more.begin(), more.end());
    const Ending ending = odontoscope(words);
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    return std::pair(bytes_of("a.json").find("\"partition\"") != std::string::npos,
                     ending.says("became one partition. --independent makes each by itself"));
  };
  EXPECT_EQ(made({}), std::pair(true, true));
  EXPECT_EQ(made({"--partition"}), std::pair(true, false));
  EXPECT_EQ(made({"--triangles", "60"}), std::pair(true, true));
  EXPECT_EQ(made({"--independent"}), std::pair(false, false));
  EXPECT_EQ(made({"--correspondence", "medial"}), std::pair(false, false));
  EXPECT_EQ(
      odontoscope({"reconstruct", "map.nrrd", "--label", "1", "--partition", "--independent", "-o", "a.glb"}).exit_code,
      2);
}

}  // namespace
}  // namespace odontoscope::testing_support
