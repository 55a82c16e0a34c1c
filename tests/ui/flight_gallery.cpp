// For people: pictures of flights to be looked at, and what a frame costs. Run with --gtest_also_run_disabled_tests.

#include <chrono>
#include <cstdio>
#include <ctime>

#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

TEST_F(FlightTest, DISABLED_FrameCost) {
  size_ = {1280, 800};
  viewer_with(ct_molar_there() ? ct_molar_loaded() : sample_tooth_loaded());
  struct Cost {
    double wall = 0, processor = 0;  // ms; the second over all threads, so that a busy machine does not count
  };
  const auto milliseconds = [&] {
    constexpr int count = 40;
    frames(5);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t began = std::clock();
    for (int i = 0; i < count; ++i) frame(1e-6);
    gl().Finish();
    return Cost{std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / count,
                1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC / count};
  };
  const auto tell = [](const char* what, const Cost& cost) {
    std::printf("%-28s %6.2f ms, %6.2f ms of processors\n", what, cost.wall, cost.processor);
  };
  std::printf("a frame that redraws nothing of the model:\n");
  tell("outside", milliseconds());
  type(U'c');
  fade();
  tell("in flight", milliseconds());
  fly().habits.labels = false;
  tell("without names", milliseconds());
  fly().habits.inset = false;
  tell("nor small pictures", milliseconds());
  viewer().state().settings.panel = false;
  tell("nor the panel", milliseconds());
}

TEST_F(FlightTest, DISABLED_Gallery) {
  size_ = {1280, 800};
  for (const LoadedModel& tooth : {sample_tooth_loaded(), ct_molar_loaded()}) {
    viewer_with(tooth, {});
    type(U'c');
    fade();
    keep_picture("gallery-" + tooth.title + "-0enter");
    fly().flight = looking(fly().flight.eye, {0.1, 0.1, -1});
    frames(3, 0.05);
    keep_picture("gallery-" + tooth.title + "-1floor");
    type(U'?');
    keep_picture("gallery-" + tooth.title + "-help");
    press_key(Key::escape);
    type(U'n');
    keep_picture("gallery-" + tooth.title + "-note");
    press_key(Key::escape);
    const CentreLines& lines = spaces().cavities[0].lines;
    ASSERT_FALSE(lines.canals.empty());
    for (const double part : {0.1, 0.5, 0.8}) {
      const CentreLine& canal = lines.canals[0];
      const auto i = static_cast<std::size_t>(part * static_cast<double>(canal.points.size() - 1));
      if (!fly().ride) {
        type(U'1');
        fade();
        press_key(Key::space);
      }
      fly().ride->along = canal.points[i].along;
      frames(3, 0.05);
      keep_picture("gallery-" + tooth.title + "-canal-" + std::to_string(static_cast<int>(10 * part)));
    }
    type(U'c');
    fade();
    type(U'a');
    fade();
    keep_picture("gallery-" + tooth.title + "-outdoors");
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
