// Ctrl-C in the middle of work leaves every file as it was.

#include <signal.h>

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
      text += (i == 0 ? "[" : ",[") + std::to_string(100 * std::cos(turn)) + "," + std::to_string(100 * std::sin(turn)) + "]";
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

INSTANTIATE_TEST_SUITE_P(BySignal, Interrupted, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace odontoscope::testing_support
