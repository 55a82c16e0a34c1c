// Doors of the system: closed outputs, limits on memory and files, what a killed run leaves, small files that stand for
// large ones.

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "recon/core/sanitized.h"
#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

namespace fs = std::filesystem;

class Doors : public ProgramTest {
 protected:
  void SetUp() override { given("cube.json", cube_stack()); }

  /// Through a shell, for what it can do to a program: close descriptors, set limits.
  Ending shell(const std::string& command) {
    const std::string out = (folder / "out").string(), err = (folder / "err").string();
    const std::string whole =
        "cd '" + folder.path().string() + "' && { " + command + "; } >>'" + out + "' 2>>'" + err + "'";
    const int status = std::system(whole.c_str());
    Ending ending;
    if (WIFEXITED(status)) ending.exit_code = WEXITSTATUS(status);
    ending.out = bytes_of("out");
    ending.err = bytes_of("err");
    fs::remove(folder / "out");
    fs::remove(folder / "err");
    return ending;
  }
  const std::string program = std::string("'") + ODONTOSCOPE_PROGRAM + "'";
};

TEST_F(Doors, ClosedOutputsSpoilNoFile) {
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "right.stl"}).exit_code, 0);
  for (const char* closed : {">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    const Ending ending = shell(program + " reconstruct cube.json -o a.stl " + closed);
    EXPECT_EQ(ending.exit_code, 0) << closed << ending.err;
    EXPECT_EQ(bytes_of("a.stl"), bytes_of("right.stl")) << closed;
    fs::remove(folder / "a.stl");
  }
  const Ending lost = shell(program + " check cube.json >&-");
  EXPECT_EQ(lost.exit_code, 4) << "nobody heard what check found";
  EXPECT_TRUE(lost.complains("standard output")) << lost.err;
  EXPECT_EQ(shell(program + " check --quiet cube.json >&-").exit_code, 0);
  EXPECT_EQ(shell(program + " check nothing.json 2>&-").exit_code, 4);
}

TEST_F(Doors, LimitOnFileSizeIsAFileErrorAndLeavesWhatWas) {
  given("a.stl", "what was there");
  given("b.glb", "this too");
  const Ending ending =
      shell("ulimit -f 1; " + program + " reconstruct cube.json -o a.stl -o b.glb");  // blocks of 512 or 1024 bytes
  EXPECT_EQ(ending.exit_code, 4) << ending.err;
  EXPECT_TRUE(ending.complains("cannot be written")) << ending.err;
  EXPECT_EQ(bytes_of("a.stl"), "what was there");
  EXPECT_EQ(bytes_of("b.glb"), "this too");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.stl", "b.glb", "cube.json"}));
}

TEST_F(Doors, WithoutMemoryEndWithWords) {
  if (address_sanitized) GTEST_SKIP() << "the address sanitizer reserves terabytes";
  ASSERT_EQ(odontoscope({"sample", "molar", "-o", "molar.json"}).exit_code, 0);
  int without = 0;
  constexpr int least = 30, most = 1000;
  const int step = std::getenv("ODONTOSCOPE_EVERY_LIMIT") != nullptr ? 6 : 18;  // by command: docs/testing.md
  for (int megabytes = least; megabytes < most; megabytes += step) {
    const std::string within = "ulimit -v " + std::to_string(megabytes * 1024) + "; " + program;
    const Ending ending = shell(within + " reconstruct molar.json --threads 1 -o a.glb");
    if (ending.exit_code == 0) break;
    EXPECT_FALSE(exists("a.glb"));
    // Not enough for the loader to bring the program up, or for what libraries do on their own before it begins (GDCM
    // fills a dictionary).
    if (shell(within + " --version").exit_code != 0) continue;
    ++without;
    EXPECT_EQ(ending.exit_code, 4) << megabytes << " MB: " << ending.err;
    EXPECT_TRUE(ending.complains("memory")) << ending.err;
  }
  EXPECT_GT(without, 0) << "no limit was too small: the test shows nothing";
}

TEST_F(Doors, WhatAKilledRunLeftIsCleanedByTheNext) {
  // A process that is surely over.
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ASSERT_GT(dead, 0);
  ::waitpid(dead, nullptr, 0);
  const std::string left = ".odontoscope-" + std::to_string(dead) + "-0.tmp",
                    living = ".odontoscope-" + std::to_string(::getpid()) + "-0.tmp";
  for (const std::string& name : {left, living, std::string(".odontoscope-1.tmp"), std::string(".odontoscope-x-1.tmp"),
                                  std::string("odontoscope-1-1.tmp")})
    given(name, "half");
  given(".odontoscope-" + std::to_string(dead) + "-1.tmp", "in use elsewhere");
  const int held = ::open((folder / (".odontoscope-" + std::to_string(dead) + "-1.tmp")).c_str(), O_RDONLY);
  ASSERT_GE(held, 0);
  ASSERT_EQ(::flock(held, LOCK_SH), 0);
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "a.stl"}).exit_code, 0);
  EXPECT_FALSE(exists(left));
  EXPECT_TRUE(exists(living)) << "its process lives";
  EXPECT_TRUE(exists(".odontoscope-" + std::to_string(dead) + "-1.tmp")) << "another machine may hold it";
  for (const char* foreign : {".odontoscope-1.tmp", ".odontoscope-x-1.tmp", "odontoscope-1-1.tmp"})
    EXPECT_TRUE(exists(foreign)) << foreign;
  ::close(held);
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "a.stl"}).exit_code, 0);
  EXPECT_FALSE(exists(".odontoscope-" + std::to_string(dead) + "-1.tmp"));
}

/// Somebody holds it open and writes nothing: the harder case of waiting for a pipe.
TEST_F(Doors, APipeThatIsHeldOpenAnswersTheFirstSignal) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int writer = ::open((folder / "pipe").c_str(), O_RDWR);
  ASSERT_GE(writer, 0);
  constexpr auto time_to_start = std::chrono::milliseconds(2000);  // before it listens, a signal ends it as any program
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"reconstruct", "pipe", "-o", "new.glb"},
                                             {"anatomy", "pipe"},
                                             {"reconstruct", "cube.json", "--links", "pipe", "-o", "new.glb"}}) {
    const Ending ending = run({.arguments = arguments,
                               .folder = folder.path().string(),
                               .signals = {SIGINT},
                               .says_nothing = true,
                               .pause = time_to_start});
    EXPECT_EQ(ending.exit_code, 130) << arguments[0] << ": " << ending.err << ending.signal;
  }
  ::close(writer);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"contours", "pipe", "--iso", "1", "-o", "new.json"},
           {"contours", "cube.json", "--label-names", "pipe", "--label", "1", "-o", "new.json"},
           {"corpus", "pipe"}}) {
    const Ending ending = run({.arguments = arguments,
                               .folder = folder.path().string(),
                               .signals = {SIGINT},
                               .says_nothing = true,
                               .pause = time_to_start});
    EXPECT_TRUE(ending.exit_code == 130 || ending.exit_code == 4)
        << arguments[0] << ": " << ending.exit_code << ending.err << ending.signal;
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
