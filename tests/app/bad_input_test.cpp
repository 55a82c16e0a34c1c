// Bad data: exit code 3 (4 where nothing can be read), a message that names file and cause, and outputs left as they
// were.

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

struct BadFile {
  const char* name;
  std::string text;
  const char* cause;
};

class BadStack : public ProgramTest, public ::testing::WithParamInterface<BadFile> {};

TEST_P(BadStack, IsRefusedAndOutputsStayAsTheyWere) {
  given("bad.json", GetParam().text);
  given("old.glb", "what was there");
  const Ending ending =
      odontoscope({"reconstruct", "bad.json", "-o", "old.glb", "-o", "new.stl", "--report", "new.json"});
  EXPECT_EQ(ending.exit_code, 3) << ending.err;
  EXPECT_TRUE(ending.complains("bad.json")) << ending.err;
  EXPECT_TRUE(ending.complains(std::string("[") + GetParam().cause + "]")) << ending.err;
  EXPECT_EQ(bytes_of("old.glb"), "what was there");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"bad.json", "old.glb"}));
}

const BadFile bad_files[] = {
    {"Empty", "", "unparsable"},
    {"Truncated", cube_stack().substr(0, 150), "unparsable"},
    {"WrongFormat", R"({"format":"something","version":1,"unit":"mm","slices":[]})", "wrong-format"},
    {"WrongVersion", R"({"format":"odontoscope.contours","version":2,"unit":"mm","slices":[]})", "wrong-version"},
    {"WrongUnit", R"({"format":"odontoscope.contours","version":1,"unit":"parsec","slices":[]})", "wrong-unit"},
    {"NoSlices", R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[]})", "empty-stack"},
    {"TwoPoints", cube_stack("[[0,0],[1,0]]"), "too-few-points"},
    {"RepeatedPoint", cube_stack("[[0,0],[1,0],[1,0],[0,1]]"), "repeated-point"},
    {"ZeroArea", cube_stack("[[0,0],[1,0],[2,0]]"), "zero-area"},
    {"BowTie", cube_stack("[[0,0],[1,1],[1,0],[0,1]]"), "self-crossing"},
    {"Absurd", cube_stack("[[0,0],[1e30,0],[1,1]]"), "too-large"},
    {"Overflow", cube_stack("[[0,0],[1e999,0],[1,1]]"), "not-finite"},
};

INSTANTIATE_TEST_SUITE_P(Files, BadStack, ::testing::ValuesIn(bad_files),
                         [](const auto& test) { return std::string(test.param.name); });

class BadInput : public ProgramTest {};

TEST_F(BadInput, MissingFileIsAFileError) {
  const Ending ending = odontoscope({"reconstruct", "nowhere.json", "-o", "a.glb"});
  EXPECT_EQ(ending.exit_code, 4);
  EXPECT_TRUE(ending.complains("nowhere.json")) << ending.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST_F(BadInput, AnEmptyFileIsCalledEmptyWhateverItsName) {
  for (const char* name : {"a.json", "a.stl", "a.glb", "a.nrrd", "a.dcm", "a"}) {
    given(name, "");
    for (std::vector<std::string> call : {std::vector<std::string>{"check", name},
                                          {"contours", name, "--iso", "1", "-o", "b.json"},
                                          {"anatomy", name},
                                          {"reconstruct", name, "-o", "b.glb"}}) {
      const Ending ending = odontoscope(call);
      if (ending.exit_code == 2) continue;  // named like a volume: where in it?
      EXPECT_EQ(ending.exit_code, 3) << call[0] << " " << name;
      EXPECT_TRUE(ending.complains("the file is empty")) << call[0] << " " << name << ": " << ending.err;
    }
  }
}

TEST_F(BadInput, UnknownStructureTogether) {
  given("cube.json", cube_stack());
  const Ending ending = odontoscope({"reconstruct", "cube.json", "--together", "tooth,pulp", "-o", "a.glb"});
  EXPECT_EQ(ending.exit_code, 3) << ending.err;
  EXPECT_TRUE(ending.complains("[unknown-structure]")) << ending.err;
  EXPECT_FALSE(exists("a.glb"));
}

TEST_F(BadInput, LinkThatNamesWhatIsNotThere) {
  given("cube.json", cube_stack());
  given(
      "links.json",
      R"({"format":"odontoscope.links","version":1,"links":[{"structure":"tooth","slice":7,"lower":0,"upper":0,"connect":true}]})");
  const Ending ending = odontoscope({"reconstruct", "cube.json", "--links", "links.json", "-o", "a.glb"});
  EXPECT_EQ(ending.exit_code, 3) << ending.err;
  EXPECT_TRUE(ending.complains("[link-unknown-slice]")) << ending.err;
  EXPECT_TRUE(ending.complains("links.json")) << ending.err;
  EXPECT_FALSE(exists("a.glb"));
}

TEST_F(BadInput, VolumeOfNonsense) {
  given("scan.nrrd", "no volume at all");
  for (const char* subcommand : {"contours", "reconstruct"}) {
    const std::string output = std::string(subcommand) == "contours" ? "a.json" : "a.glb";
    const Ending ending = odontoscope({subcommand, "scan.nrrd", "--iso", "1", "-o", output});
    EXPECT_EQ(ending.exit_code, 3) << ending.err;
    EXPECT_TRUE(ending.complains("scan.nrrd")) << ending.err;
    EXPECT_FALSE(exists(output));
  }
}

TEST_F(BadInput, CheckOfNonsense) {
  given("thing.glb", "neither mesh nor stack");
  const Ending ending = odontoscope({"check", "thing.glb"});
  EXPECT_EQ(ending.exit_code, 3) << ending.err;
  EXPECT_TRUE(ending.complains("thing.glb")) << ending.err;
}

TEST_F(BadInput, ErrorsAreSaidHoweverQuiet) {
  given("bad.json", "");
  const Ending ending = odontoscope({"--quiet", "reconstruct", "bad.json", "-o", "a.glb"});
  EXPECT_EQ(ending.exit_code, 3);
  EXPECT_TRUE(ending.complains("[unparsable]"));
}

}  // namespace
}  // namespace odontoscope::testing_support
