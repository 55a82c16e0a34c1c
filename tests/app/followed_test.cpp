// Advice of all commands is followed, on inputs whose right answer is another call's: the same bytes, or the same words
// about the model. remedies_test.cpp has that of damaged inputs.

#include <cmath>
#include <numbers>

#include "tests/app/program.h"
#include "tests/volume/segmentation_object.h"
#include "tests/volume/volume_files.h"

namespace odontoscope::testing_support {
namespace {

using Words = std::vector<std::string>;

const std::string spaced = "space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,2)\n";

/// A blob of -200 to 600, taller than wide; with a bar beside it, so that both together are as wide as tall.
std::string blob(bool bar = false) {
  std::string text = "NRRD0004\ntype: short\ndimension: 3\nsizes: 40 12 10\n" + spaced + "encoding: text\n\n";
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 40; ++i) {
        const double square = std::pow((i - 5.5) / 4, 2) + std::pow((j - 5.5) / 4, 2) + std::pow((k - 4.5) / 3.5, 2);
        const bool in_bar = bar && i > 14 && i < 22 && j > 4 && j < 8 && k > 2 && k < 7;
        text += std::to_string(in_bar ? 500 + i : static_cast<int>(800 * std::exp(-square)) - 200) + " ";
      }
  return text;
}

/// A block of 500 in -40, with a canal one voxel wide.
std::string canal() {
  std::string text = "NRRD0004\ntype: short\ndimension: 3\nsizes: 14 14 12\n" + spaced + "encoding: text\n\n";
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 14; ++j)
      for (int i = 0; i < 14; ++i)
        text += i > 1 && i < 12 && j > 1 && j < 12 && !(i == 7 && j == 7 && k > 1 && k < 10) ? "500 " : "-40 ";
  return text;
}

std::string ring(double x, double radius, int corners) {
  std::string points;
  for (int n = 0; n < corners; ++n) {
    const double turn = 2 * std::numbers::pi * n / corners;
    points += (n == 0 ? "[" : ",[") + std::to_string(x + radius * std::cos(turn)) + "," +
              std::to_string(radius * std::sin(turn)) + "]";
  }
  return "{\"points\":[" + points + "]}";
}

std::string stack(const std::vector<std::vector<std::string>>& slices) {
  std::string text = R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[)";
  for (std::size_t z = 0; z < slices.size(); ++z) {
    text += std::string(z == 0 ? "" : ",") + "{\"z\":" + std::to_string(z) + ",\"contours\":[";
    for (std::size_t n = 0; n < slices[z].size(); ++n) text += (n == 0 ? "" : ",") + slices[z][n];
    text += "]}";
  }
  return text + "]}";
}

/// Six slices of a circle that jumps by `far` in the middle.
std::string jumping(double far) {
  std::vector<std::vector<std::string>> slices;
  for (int z = 0; z < 6; ++z) slices.push_back({ring(z < 3 ? 0 : far, 1, 24)});
  return stack(slices);
}

/// A block with a canal through it from end to end.
std::string drilled() {
  std::vector<std::vector<std::string>> slices;
  for (int z = 0; z < 14; ++z)
    slices.push_back(z == 0 || z == 13 ? Words{ring(0, 4, 24)} : Words{ring(0, 4, 24), ring(0, 0.5 + 0.01 * z, 16)});
  return stack(slices);
}

class Followed : public ProgramTest {
 protected:
  void SetUp() override {
    given("v.nrrd", blob());
    given("drilled.json", drilled());
  }
  void succeeds(const Words& call) {
    const Ending ending = odontoscope(call);
    ASSERT_EQ(ending.exit_code, 0) << ending.err;
  }
  /// `wrong` gives that advice; `followed` then works.
  void follow(const Words& wrong, const std::string& advice, const Words& followed) {
    const Ending before = odontoscope(wrong);
    EXPECT_TRUE(before.says(advice) || before.complains(advice)) << before.out << before.err;
    EXPECT_NE(before.exit_code, 0);
    const Ending after = odontoscope(followed);
    EXPECT_EQ(after.exit_code, 0) << after.err;
  }
  void expect_same(const std::string& a, const std::string& b) {
    EXPECT_TRUE(exists(a) && bytes_of(a) == bytes_of(b)) << a << " and " << b;
  }
};

TEST_F(Followed, AVolumeGetsALevel) {
  const std::string advice = "Give --iso T (or --iso auto) for an image, --label N for a label map";
  follow({"reconstruct", "v.nrrd", "-o", "a.ply"}, advice, {"reconstruct", "v.nrrd", "--iso", "100", "-o", "a.ply"});
  succeeds({"contours", "v.nrrd", "--iso", "100", "-o", "v.json"});
  succeeds({"reconstruct", "v.json", "-o", "b.ply"});
  expect_same("a.ply", "b.ply");
  given("canal.nrrd", canal());
  follow({"anatomy", "canal.nrrd"}, advice, {"anatomy", "canal.nrrd", "--iso", "auto"});
  follow({"compare", "v.nrrd"}, advice, {"compare", "v.nrrd", "--iso", "100", "--grid", "16"});
  follow({"check", "v.nrrd"}, "odontoscope contours v.nrrd --iso T -o FILE.json", {"check", "v.json"});
}

TEST_F(Followed, AMeshIsCut) {
  succeeds({"reconstruct", "drilled.json", "-o", "d.ply"});
  const std::string advice = "Cut it first: odontoscope contours d.ply --spacing-z D -o FILE.json";
  for (const Words& command : {Words{"compare", "d.ply"}, Words{"figures", "d.ply", "-o", "figures"}}) {
    const Ending ending = odontoscope(command);
    if (ending.exit_code == 5) continue;  // no picture can be drawn here
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_TRUE(ending.complains(advice)) << ending.err;
  }
  succeeds({"contours", "d.ply", "--spacing-z", "1", "-o", "cut.json"});
  succeeds({"compare", "cut.json", "--grid", "16"});
  follow({"contours", "d.ply", "--spacing-z", "100", "-o", "a.json"}, "Give a smaller one",
         {"contours", "d.ply", "--spacing-z", "1", "-o", "a.json"});
  expect_same("a.json", "cut.json");
  follow({"contours", "d.ply", "--spacing-z", "0.0001", "-o", "a.json"}, "Give a larger one",
         {"contours", "d.ply", "--spacing-z", "1", "-o", "a.json"});
  follow({"batch", "d.ply", "-o", "models"}, "Give --spacing-z D, or --at Z for each plane",
         {"batch", "d.ply", "-o", "models", "--with", "--spacing-z 1"});
  succeeds({"reconstruct", "cut.json", "-o", "d.glb"});
  EXPECT_TRUE(exists("models/d.glb"));
}

TEST_F(Followed, VoxelsThatAreWritten) {
  succeeds({"contours", "v.nrrd", "--iso", "100", "-o", "v.json"});
  follow({"contours", "v.json", "-o", "a.seg.nrrd"}, "Give --voxels X,Y,Z",
         {"contours", "v.json", "--voxels", "0.5,0.5,2", "-o", "a.seg.nrrd"});
  follow({"contours", "v.nrrd", "--iso", "100", "--voxels", "0.5,0.5,1", "-o", "b.seg.nrrd"}, "Give --voxels 0.5,0.5,2",
         {"contours", "v.nrrd", "--iso", "100", "--voxels", "0.5,0.5,2", "-o", "b.seg.nrrd"});
  expect_same("a.seg.nrrd", "b.seg.nrrd");
  succeeds({"reconstruct", "v.nrrd", "--iso", "100", "--voxels", "0.5,0.5,1", "-o",
            "c.seg.nrrd"});  // "or let reconstruct write the voxels"
  succeeds({"reconstruct", "v.json", "--voxels", "0.5,0.5,1", "-o", "d.seg.nrrd"});
  expect_same("c.seg.nrrd", "d.seg.nrrd");
  follow({"reconstruct", "v.json", "--voxels", "0.0005,0.0005,0.0005", "-o", "e.seg.nrrd"}, "Make voxels larger",
         {"reconstruct", "v.json", "--voxels", "0.5,0.5,1", "-o", "e.seg.nrrd"});
  follow({"reconstruct", "v.json", "--voxels", "50,50,50", "-o", "e.seg.dcm"}, "Make voxels smaller",
         {"reconstruct", "v.json", "--voxels", "0.5,0.5,1", "-o", "e.seg.dcm"});
  follow({"reconstruct", "v.json", "--voxels", "0.5,0.5,1", "--voxel-origin", "3,3,3", "-o", "e.seg.nrrd"},
         "or leave it out", {"reconstruct", "v.json", "--voxels", "0.5,0.5,1", "-o", "e.seg.nrrd"});
  expect_same("e.seg.nrrd", "d.seg.nrrd");
  follow({"contours", "v.nrrd", "--iso", "100", "--crop", "0,6,0,6,0,18", "-o", "f.seg.nrrd"},
         "Leave them out, or write contours (.json) or a model",
         {"contours", "v.nrrd", "--iso", "100", "--crop", "0,6,0,6,0,18", "-o", "f.json"});
  expect_same("f.json", "v.json");  // the box holds all of the blob
}

TEST_F(Followed, WhatIsNoTallerThanWideIsCroppedToTheTooth) {
  given("barred.nrrd", blob(true));
  const Words crop{"--crop", "0,6.9,0,6,0,18"};
  follow({"contours", "barred.nrrd", "--iso", "100", "--upright", "-o", "a.json"},
         "Crop the volume to the tooth (--crop)",
         {"contours", "barred.nrrd", "--iso", "100", "--upright", crop[0], crop[1], "-o", "a.json"});
  succeeds({"contours", "v.nrrd", "--iso", "100", "--upright", crop[0], crop[1], "-o", "b.json"});
  expect_same("a.json", "b.json");
}

TEST_F(Followed, OptionsThatDoNotGoTogether) {
  succeeds({"contours", "v.nrrd", "--iso", "100", "-o", "v.json"});
  follow({"reconstruct", "v.json", "--method", "db", "-o", "a.vtu"}, "Use .glb, .stl",
         {"reconstruct", "v.json", "--method", "db", "-o", "a.stl"});
  follow({"reconstruct", "v.json", "--method", "db", "--voxels", "1,1,1", "-o", "a.seg.nrrd"}, "Use --method dt",
         {"reconstruct", "v.json", "--method", "dt", "--voxels", "1,1,1", "-o", "a.seg.nrrd"});
  follow({"reconstruct", "v.json", "--method", "db", "--correspondence", "overlap", "-o", "a.stl"},
         "Leave them out, or part slices with --split", {"reconstruct", "v.json", "--method", "db", "-o", "a.stl"});
  follow({"reconstruct", "v.nrrd", "--iso", "100", "--upright", "--as-given", "-o", "a.inp"},
         "Leave it out: the report's matrix tells the turn",
         {"reconstruct", "v.nrrd", "--iso", "100", "--upright", "-o", "a.inp", "--report", "a.json"});
  EXPECT_NE(bytes_of("a.json").find("\"matrix\""), std::string::npos);
  follow({"contours", "v.nrrd", "--iso", "100", "--iso", "300", "-o", "a.json"},
         "Name them: --iso 120=dentine --iso 195=enamel",
         {"contours", "v.nrrd", "--iso", "100=dentine", "--iso", "300=enamel", "-o", "a.json"});
  follow({"contours", "v.nrrd", "--iso", "100"}, "Give -o FILE.json, or look at a volume's values with --histogram",
         {"contours", "v.nrrd", "--histogram"});
  follow({"contours", "v.nrrd", "--iso", "100", "--histogram"}, "Leave out -o, --iso and --label",
         {"contours", "v.nrrd", "--histogram"});
  given("canal.nrrd", canal());
  follow({"contours", "canal.nrrd", "--label", "Pulp", "-o", "a.json"}, "Give a number (--label N=NAME)",
         {"contours", "canal.nrrd", "--label", "500=Pulp", "-o", "a.json"});
  follow({"contours", "v.json", "--at", "3", "-o", "a.json"}, "Leave them out", {"contours", "v.json", "-o", "a.json"});
  expect_same("a.json", "v.json");
}

TEST_F(Followed, MoreContoursThanASliceMayHaveAreSpecks) {
  std::string text = "NRRD0004\ntype: short\ndimension: 3\nsizes: 220 220 2\n" + spaced + "encoding: text\n\n";
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 220; ++j)
      for (int i = 0; i < 220; ++i)
        text += i > 90 && i < 130 && j > 90 && j < 130 ? "100 " : i % 2 == 0 && j % 2 == 0 ? "99 " : "-7 ";
  given("noise.nrrd", text);
  follow({"contours", "noise.nrrd", "--iso", "50", "-o", "a.json"}, "drop small contours (--min-area A)",
         {"contours", "noise.nrrd", "--iso", "50", "--min-area", "4", "-o", "a.json"});
  EXPECT_TRUE(odontoscope({"check", "a.json"}).says("2 slices from z = 0 to 2 mm, 2 contours"));
}

TEST_F(Followed, CanalsThatMinAreaWouldTakeAreKeptByASmallerOne) {
  given("canal.nrrd", canal());
  const Ending lost = odontoscope({"reconstruct", "canal.nrrd", "--iso", "200", "--min-area", "4", "-o", "a.glb"});
  EXPECT_TRUE(lost.says("they may be canals. A smaller --min-area keeps them")) << lost.out;
  EXPECT_TRUE(lost.says("in 1 closed surface")) << lost.out;
  EXPECT_TRUE(odontoscope({"reconstruct", "canal.nrrd", "--iso", "200", "--min-area", "0.3", "-o", "a.glb"})
                  .says("in 2 closed surfaces"));
}

TEST_F(Followed, SegmentsThatOverlapAreTakenUnsmoothed) {
  test::SegmentationObject map;
  for (const char* z : {"10\\20\\30", "10\\20\\32", "10\\20\\34"}) {
    map.frames.push_back({1, z, 0xfff});
    map.frames.push_back({2, z, 0x060});
  }
  given("seg.dcm", map.bytes());
  follow({"contours", "seg.dcm", "--label", "tooth", "--label", "pulp", "--smooth", "0.1", "-o", "a.json"},
         "Leave out --smooth", {"contours", "seg.dcm", "--label", "tooth", "--label", "pulp", "-o", "a.json"});
}

/// Whatever a warning offers does what it says, and ends the doubt.
TEST_F(Followed, LinksThatAWarningOffers) {
  struct Offer {
    double far;
    const char *one, *two;  // what it says for one thing, and for two
  };
  for (const auto& [far, one, two] :
       {Offer{2.3, "if not, --link tooth:2:0-0", "If so, add --unlink tooth:2:0-0"},
        Offer{3, "If it is one, add --link tooth:2:0-0", "if two, --unlink tooth:2:0-0"}}) {
    given("s.json", jumping(far));
    const Ending asked = odontoscope({"reconstruct", "s.json", "-o", "s.glb"});
    EXPECT_TRUE(asked.complains(one) && asked.complains(two)) << asked.err;
    for (const auto& [option, words] :
         {std::pair{"--link", "in 1 closed surface"}, {"--unlink", "in 2 closed surfaces"}}) {
      const Ending followed = odontoscope({"reconstruct", "s.json", option, "tooth:2:0-0", "-o", "s.glb"});
      EXPECT_TRUE(followed.says(words)) << followed.out;
      EXPECT_FALSE(followed.complains("near")) << followed.err;
    }
  }
}

TEST_F(Followed, PicturesThatWantSomethingElse) {
  succeeds({"reconstruct", "drilled.json", "-o", "d.glb"});
  succeeds({"contours", "v.nrrd", "--iso", "100", "-o", "v.json"});
  const Ending plain = odontoscope({"render", "d.glb", "-o", "plain.png", "--size", "64x64"});
  if (plain.exit_code == 5) GTEST_SKIP() << plain.err;
  const auto render = [](Words words) {
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"-o", "a.png", "--size", "64x64"});
    return words;
  };
  follow(render({"v.nrrd"}), "Give --iso T (or --iso auto)", render({"v.nrrd", "--iso", "100"}));
  follow(render({"v.nrrd", "--show", "volume", "--resample", "0.5"}), "Say with --iso where it lies",
         render({"v.nrrd", "--show", "volume", "--resample", "0.5", "--iso", "100"}));
  follow(render({"v.json", "--cap", "ct", "--section", "+x"}),
         "Give the volume that the model was made from, with --iso",
         render({"v.nrrd", "--iso", "100", "--cap", "ct", "--section", "+x"}));
  follow(render({"d.glb", "--overlay", "contours"}), "Give the contour stack, or the volume, that it was made from",
         render({"drilled.json", "--overlay", "contours"}));
  follow(render({"drilled.json", "--overlay", "tetrahedra=99"}), "The slabs are counted from 0 to 12",
         render({"drilled.json", "--overlay", "tetrahedra=12"}));
  follow(render({"d.glb", "--contact-sheet", "2x2"}), "Say which line: --tour canal-1",
         {"render", "d.glb", "--tour", "canal-1", "--contact-sheet", "2x2", "-o", "sheet.png", "--size", "64x64"});
  follow({"render", "d.glb", "--radiograph", "--focus", "0.5", "-o", "a.png"}, "Move it away with --focus MM",
         {"render", "d.glb", "--radiograph", "--focus", "200", "-o", "a.png"});
  follow({"render", "d.glb", "--radiograph", "--zoom", "2", "-o", "a.png"}, "Leave the others out",
         {"render", "d.glb", "--radiograph", "-o", "a.png"});
  follow({"web", "v.nrrd", "-o", "a.html"}, "Give --iso T (or --iso auto)",
         {"web", "v.nrrd", "--iso", "100", "-o", "a.html"});
  follow({"web", "d.glb", "--db", "-o", "a.html"}, "or give what the mesh was made from",
         {"web", "drilled.json", "--db", "--grid", "16", "-o", "a.html"});
}

}  // namespace
}  // namespace odontoscope::testing_support
