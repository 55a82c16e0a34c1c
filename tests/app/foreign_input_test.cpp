// `contours` and `reconstruct` on meshes and on other programs' contours, as a user calls them.

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class ForeignInput : public ProgramTest {};

const std::string csl =
    "CSLC\n2 2\n1 4 1 0 0 1 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n4 1 0 1 2 3\n2 4 1 0 0 1 -1\n0 0 1\n4 0 1\n4 4 1\n0 4 1\n4 "
    "1 ";

TEST_F(ForeignInput, OurOwnModelComesBackAsContours) {
  given("cube.json", cube_stack());
  ASSERT_EQ(
      odontoscope({"reconstruct", "cube.json", "-o", "a.glb", "-o", "a.stl", "-o", "a.ply", "-o", "a.obj"}).exit_code,
      0);
  for (const char* mesh : {"a.glb", "a.stl", "a.ply", "a.obj"}) {
    const Ending ending = odontoscope({"contours", mesh, "--spacing-z", "0.25", "-o", "back.json"});
    EXPECT_EQ(ending.exit_code, 0) << ending.err;
    EXPECT_TRUE(ending.says("4 slices from z = 0.125 to 0.875 mm, 4 contours")) << ending.out;
    EXPECT_TRUE(ending.says("structure: tooth")) << ending.out;
    EXPECT_EQ(odontoscope({"reconstruct", mesh, "--at", "0.25", "--at", "0.75", "-o", "again.glb"}).exit_code, 0)
        << mesh;
    EXPECT_EQ(odontoscope({"check", "again.glb"}).exit_code, 0);
  }
}

TEST_F(ForeignInput, SeveralMeshesBecomeOneStack) {
  given("a.json", cube_stack());
  ASSERT_EQ(
      odontoscope({"reconstruct", "a.json", "-o", "dentine.stl", "-o", "enamel.ply", "-o", "dentine.obj"}).exit_code,
      0);
  const Ending both = odontoscope({"contours", "dentine.stl", "enamel.ply", "--spacing-z", "0.25", "-o", "both.json"});
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_TRUE(both.says("4 slices from z = 0.125 to 0.875 mm, 8 contours")) << both.out;
  EXPECT_TRUE(both.says("structures: dentine, enamel")) << both.out;
  const Ending twice = odontoscope({"contours", "dentine.stl", "dentine.obj", "--spacing-z", "0.25", "-o", "b.json"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_TRUE(twice.complains("both dentine.stl and dentine.obj have a structure called \"dentine\"")) << twice.err;
  EXPECT_EQ(odontoscope({"contours", "dentine.stl", "a.json", "--spacing-z", "0.25", "-o", "b.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"contours", "dentine.stl", "enamel.ply", "-o", "b.json"}).exit_code, 2);
  EXPECT_FALSE(exists("b.json"));
}

TEST_F(ForeignInput, ContentDecidesNotTheEnding) {
  given("planes.txt", csl + "0 1 2 3\n");
  const Ending ending = odontoscope({"reconstruct", "planes.txt", "-o", "a.glb"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("certified")) << ending.out;
}

TEST_F(ForeignInput, RepairIsOfferedAndTellsWhatItDid) {
  given("crossed.csl", csl + "0 2 1 3\n");
  const Ending refused = odontoscope({"reconstruct", "crossed.csl", "-o", "a.glb"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_TRUE(refused.complains("[self-crossing]")) << refused.err;
  EXPECT_TRUE(refused.complains("slice 1 (z = 1), contour 0")) << refused.err;
  EXPECT_TRUE(refused.complains("--repair")) << refused.err;
  EXPECT_FALSE(exists("a.glb"));
  const Ending repaired = odontoscope({"reconstruct", "crossed.csl", "--repair", "-o", "a.glb"});
  EXPECT_EQ(repaired.exit_code, 0) << repaired.err;
  EXPECT_TRUE(repaired.says("slice 1 (z = 1), contour 0, tooth: crossed itself at (2, 2): 1 contour became 2"))
      << repaired.out;
}

TEST_F(ForeignInput, OtherSubcommandsReadThemToo) {
  given("planes.csl", csl + "0 1 2 3\n");
  EXPECT_EQ(odontoscope({"check", "planes.csl"}).exit_code, 0);
  EXPECT_EQ(odontoscope({"compare", "planes.csl", "--grid", "32"}).exit_code, 0);
  EXPECT_EQ(odontoscope({"section", "planes.csl", "-o", "a.json"}).exit_code, 0);
  EXPECT_EQ(odontoscope({"check", "a.json"}).exit_code, 0);
}

TEST_F(ForeignInput, WhatIsNoneOfAllIsSaid) {
  given("model.msh", "$MeshFormat\n");
  const Ending nothing = odontoscope({"contours", "model.msh", "-o", "a.json"});
  EXPECT_EQ(nothing.exit_code, 3);
  EXPECT_TRUE(nothing.complains("[unknown-format]")) << nothing.err;
  given("s.12", "<?xml version=\"1.0\"?>\n<Section index=\"12\" thickness=\"1\"></Section>");
  const Ending section = odontoscope({"contours", "s.12", "-o", "a.json"});
  EXPECT_EQ(section.exit_code, 3);
  EXPECT_TRUE(section.complains("Give the .ser")) << section.err;
}

TEST_F(ForeignInput, AStackOfOursCanBeRepairedToo) {
  given("bow-tie.json", cube_stack("[[0,0],[1,1],[1,0],[0,1]]"));
  EXPECT_EQ(odontoscope({"contours", "bow-tie.json", "-o", "mended.json"}).exit_code, 3);
  EXPECT_EQ(odontoscope({"contours", "bow-tie.json", "--repair", "-o", "mended.json"}).exit_code, 0);
  EXPECT_EQ(odontoscope({"check", "mended.json"}).exit_code, 0);
}

TEST_F(ForeignInput, UsageThatMakesNoSenseIsSaid) {
  given("cube.json", cube_stack());
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "a.stl"}).exit_code, 0);
  const Ending no_planes = odontoscope({"contours", "a.stl", "-o", "b.json"});
  EXPECT_EQ(no_planes.exit_code, 2);
  EXPECT_TRUE(no_planes.complains("--spacing-z")) << no_planes.err;
  EXPECT_EQ(odontoscope({"contours", "a.stl", "--spacing-z", "0", "-o", "b.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"contours", "a.stl", "--spacing-z", "0.1", "--at", "1", "-o", "b.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"contours", "a.stl", "--spacing-z", "0.1", "--widest-gap", "1", "-o", "b.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"contours", "a.stl", "--at", "nan", "-o", "b.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"contours", "cube.json", "--spacing-z", "0.1", "-o", "b.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"contours", "a.stl", "--iso", "1", "--repair", "-o", "b.json"}).exit_code, 2);
  const Ending unknown =
      odontoscope({"contours", "a.stl", "--spacing-z", "0.1", "--structure", "pulp", "-o", "b.json"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_TRUE(unknown.complains("[unknown-structure]")) << unknown.err;
  EXPECT_FALSE(exists("b.json"));
}

}  // namespace
}  // namespace odontoscope::testing_support
