// Ctrl-C in the middle of work leaves every file as it was.

#include <signal.h>
#include <sys/stat.h>

#include <cmath>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

/// `slices` slices of one regular polygon: takes the engine seconds.
std::string long_work(int slices, int corners) {
  std::string text = R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[)";
  for (int slice = 0; slice < slices; ++slice) {
    text += slice == 0 ? "" : ",";
    text += "{\"z\":" + std::to_string(slice) + ",\"contours\":[{\"points\":[";
    for (int i = 0; i < corners; ++i) {
      const double turn = 2 * 3.14159265358979 * (i + 0.37 * (slice % 3)) / corners;
      text += (i == 0 ? "[" : ",[") + std::to_string(100 * std::cos(turn)) + "," +
              std::to_string(100 * std::sin(turn)) + "]";
    }
    text += "]}]}";
  }
  return text + "]}";
}

class Interrupted : public ProgramTest, public ::testing::WithParamInterface<int> {};

TEST_P(Interrupted, ReconstructionWritesNothing) {
  given("long.json", long_work(400, 1000));
  given("old.stl", "what was there");
  const Ending ending = run({.arguments = {"reconstruct", "long.json", "-o", "old.stl", "-o", "new.glb"},
                             .folder = folder.path().string(),
                             .signals = {GetParam()}});
  EXPECT_EQ(ending.exit_code, 130) << ending.err;
  EXPECT_TRUE(ending.complains("stopped; no file was touched")) << ending.err;
  EXPECT_EQ(bytes_of("old.stl"), "what was there");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"long.json", "old.stl"}));
}

/// Nobody writes to it: a pipe is waited for, but not against a signal.
TEST_P(Interrupted, WaitingForAPipeIsGivenUpAtTheFirstSignal) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"reconstruct", "pipe", "-o", "new.glb"},
                                             {"contours", "pipe", "-o", "new.json"},
                                             {"check", "pipe"},
                                             {"render", "pipe", "-o", "new.png"},
                                             {"web", "pipe", "-o", "new.html"}}) {
    const Ending ending =
        run({.arguments = arguments, .folder = folder.path().string(), .signals = {GetParam()}, .says_nothing = true});
    EXPECT_EQ(ending.exit_code, 130) << arguments[0] << ": " << ending.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"pipe"}));
  }
}

INSTANTIATE_TEST_SUITE_P(BySignal, Interrupted, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace odontoscope::testing_support
