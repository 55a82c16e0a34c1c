// Outputs that cannot be written: exit code 4 before the long work, and none of the others is written either.

#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

namespace fs = std::filesystem;

class Outputs : public ProgramTest {
 protected:
  void SetUp() override { given("cube.json", cube_stack()); }
  void expect_refused(const std::string& output) {
    const std::vector<std::string> before = folder.names();
    const Ending ending = odontoscope({"reconstruct", "cube.json", "-o", "good.stl", "-o", output});
    EXPECT_EQ(ending.exit_code, 4) << ending.err;
    EXPECT_TRUE(ending.complains(output)) << ending.err;
    EXPECT_EQ(folder.names(), before);
    EXPECT_FALSE(ending.complains("certify"))
        << "the long work was done before the output was looked at: " << ending.err;
  }
};

TEST_F(Outputs, MissingFolder) { expect_refused("missing/a.glb"); }

TEST_F(Outputs, AFolderOfThatName) {
  fs::create_directory(folder / "a.glb");
  expect_refused("a.glb");
}

TEST_F(Outputs, ADevice) {
  fs::create_symlink("/dev/full", folder / "a.glb");
  expect_refused("a.glb");
}

TEST_F(Outputs, ALinkThatLeadsNowhere) {
  fs::create_symlink("nowhere", folder / "a.glb");
  expect_refused("a.glb");
}

TEST_F(Outputs, AFolderWithoutPermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  expect_refused("locked/a.glb");
}

TEST_F(Outputs, ALinkIsFollowedAndStaysALink) {
  given("real.stl", "old");
  fs::create_symlink("real.stl", folder / "link.stl");
  EXPECT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "link.stl"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link.stl"));
  EXPECT_GT(bytes_of("real.stl").size(), 84u);
}

TEST_F(Outputs, SameFileThroughALinkIsRefused) {
  given("a.stl", "old");
  fs::create_symlink("a.stl", folder / "b.stl");
  const Ending ending = odontoscope({"reconstruct", "cube.json", "-o", "a.stl", "-o", "b.stl"});
  EXPECT_EQ(ending.exit_code, 2) << ending.err;
  EXPECT_EQ(bytes_of("a.stl"), "old");
}

TEST_F(Outputs, InputThroughAHardLinkIsRefused) {
  fs::create_hard_link(folder / "cube.json", folder / "report.json");
  const Ending ending = odontoscope({"reconstruct", "cube.json", "-o", "a.stl", "--report", "report.json"});
  EXPECT_EQ(ending.exit_code, 2) << ending.err;
  EXPECT_EQ(bytes_of("cube.json"), cube_stack());
}

TEST_F(Outputs, FullStandardOutputIsAFileError) {
  const Ending ending =
      run({.arguments = {"check", "cube.json"}, .folder = folder.path().string(), .out_to = "/dev/full"});
  EXPECT_EQ(ending.exit_code, 4) << ending.err;
  EXPECT_TRUE(ending.complains("standard output")) << ending.err;
}

TEST_F(Outputs, FullStandardOutputHidesNoFileThatWasWritten) {
  const Ending ending = run({.arguments = {"reconstruct", "cube.json", "-o", "a.stl"},
                             .folder = folder.path().string(),
                             .out_to = "/dev/full"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.complains("the files are written")) << ending.err;
  EXPECT_TRUE(exists("a.stl"));
}

TEST_F(Outputs, FullStandardErrorEndsNothing) {
  const Ending good = run({.arguments = {"reconstruct", "cube.json", "-o", "a.stl"},
                           .folder = folder.path().string(),
                           .err_to = "/dev/full"});
  EXPECT_EQ(good.exit_code, 0) << good.out;
  EXPECT_TRUE(exists("a.stl"));
  const Ending bad = run({.arguments = {"reconstruct", "nothing.json", "-o", "b.stl"},
                          .folder = folder.path().string(),
                          .err_to = "/dev/full"});
  EXPECT_EQ(bad.exit_code, 4) << bad.out;
  EXPECT_EQ(run({.arguments = {}, .folder = folder.path().string(), .err_to = "/dev/full"}).exit_code, 2);
}

TEST_F(Outputs, NothingTemporaryIsLeftBehind) {
  EXPECT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "a.glb", "-o", "a.ply", "--report", "a.json"}).exit_code, 0);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.glb", "a.json", "a.ply", "cube.json"}));
}

}  // namespace
}  // namespace odontoscope::testing_support
