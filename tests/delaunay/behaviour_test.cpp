// Threads, cancellation, progress, and what is refused.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "recon/core/error.h"
#include "tests/delaunay/engine_checks.h"
#include "tests/support/random_stacks.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

ContourStack long_tube(int slices) {
  std::vector<std::vector<Ring>> rings;
  for (int i = 0; i < slices; ++i)
    rings.push_back({circle(3, {0.3 * std::sin(0.2 * i), 0}), circle(1, {0.3 * std::cos(0.3 * i), 0})});
  return stack_of(rings);
}

TEST(Threads, DoNotChangeAByte) {
  const auto with = [](const ContourStack& stack, int threads) {
    return reconstruct(stack, {.correspondence = Correspondence::medial, .links = {}, .threads = threads});
  };
  const ContourStack tube = long_tube(60);
  const Reconstruction one = with(tube, 1);
  for (int threads : {2, 3, 0}) EXPECT_EQ(difference(one, with(tube, threads)), "") << threads;
  EXPECT_EQ(difference(one, with(tube, 1)), "") << "not even with one";
  for (std::uint64_t seed = 0; seed < random_stacks_of(60); ++seed) {
    const ContourStack stack = random_stack(seed).stack;
    const auto by = [&](int threads) {  // interpolated slices take as long as all the others
      return seed % 4 == 0 ? with(stack, threads)
                           : reconstruct(stack, {.correspondence = Correspondence::medial,
                                                 .between = Between::delaunay,
                                                 .links = {},
                                                 .threads = threads});
    };
    EXPECT_EQ(difference(by(1), by(2)), "") << "seed " << seed;
  }
}

TEST(Threads, AreCountedInTheResult) {
  EXPECT_EQ(reconstruct(long_tube(4), {.correspondence = Correspondence::medial, .links = {}, .threads = 2}).threads,
            2);
  EXPECT_GE(reconstruct(long_tube(4)).threads, 1);
}

TEST(Cancellation, BeforeTheStart) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(reconstruct(long_tube(5), {}, {.report = {}, .stop = source.get_token()}), Cancelled);
}

TEST(Cancellation, FromAnotherThreadInTheMiddle) {
  for (int threads : {1, 2}) {
    std::stop_source source;
    std::mutex mutex;
    std::condition_variable changed;
    bool started = false;
    std::thread user([&] {
      std::unique_lock lock(mutex);
      changed.wait_for(lock, std::chrono::seconds(60), [&] { return started; });
      source.request_stop();
      changed.notify_all();
    });
    // The first report holds the work until the stop has been requested elsewhere.
    const Progress progress{[&](std::string_view, double) {
                              std::unique_lock lock(mutex);
                              started = true;
                              changed.notify_all();
                              changed.wait(lock, [&] { return source.stop_requested(); });
                            },
                            source.get_token()};
    EXPECT_THROW(reconstruct(long_tube(200),
                             {.correspondence = Correspondence::medial, .links = {}, .threads = threads}, progress),
                 Cancelled);
    user.join();
    EXPECT_TRUE(started) << "no progress was ever told";
  }
}

TEST(Progress, RunsFromNothingToAllInEveryStage) {
  std::mutex mutex;
  std::map<std::string, std::vector<double>> told;
  certified(long_tube(40), {}, {});
  reconstruct(long_tube(40), {},
              {.report =
                   [&](std::string_view stage, double fraction) {
                     const std::lock_guard lock(mutex);
                     told[std::string(stage)].push_back(fraction);
                   },
               .stop = {}});
  ASSERT_FALSE(told.empty());
  for (const auto& [stage, fractions] : told)
    for (double fraction : fractions) {
      EXPECT_GE(fraction, 0) << stage;
      EXPECT_LE(fraction, 1) << stage;
    }
}

std::string cause_of(const ContourStack& stack) {
  try {
    reconstruct(stack);
    return "accepted";
  } catch (const InputError& error) {
    return error.cause();
  }
}

TEST(BadInput, IsRefusedByTheEngineToo) {
  EXPECT_EQ(cause_of({}), "empty-stack");
  EXPECT_EQ(cause_of(stack_of({{circle(1)}})), "single-slice");
  EXPECT_EQ(cause_of(stack_of({{}, {}})), "empty-stack");
  EXPECT_EQ(cause_of(stack_of({{circle(1), circle(1, {1, 0})}, {circle(1)}})), "contours-cross");
  EXPECT_EQ(cause_of(stack_of({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, {circle(1)}})), "self-crossing");
  ContourStack twice = stack_of({{circle(1)}, {circle(1)}});
  twice.slices[1].z = 0;
  EXPECT_EQ(cause_of(twice), "repeated-z");
  ContourStack nan = stack_of({{circle(1)}, {circle(1)}});
  nan.slices[0].contours[0].points[3].x = std::nan("");
  EXPECT_EQ(cause_of(nan), "not-finite");
}

TEST(Structures, AreReconstructedIndependently) {
  ContourStack stack = islands_nested_four_deep();
  for (Slice& slice : stack.slices)
    for (std::size_t c : {2u, 3u}) slice.contours[c].structure = "pulp";
  const Reconstruction result = certified(stack);
  ASSERT_EQ(result.solids.size(), 2u);
  EXPECT_EQ(result.solids[0].structure, "tooth");
  EXPECT_EQ(result.solids[1].structure, "pulp");
  EXPECT_EQ(topology_of(result), shells({"tooth external genus 1", "pulp external genus 1"}));
}

TEST(Structures, OneMayBeMissingFromSomeSlices) {
  ContourStack stack = stack_of({{circle(4)}, {circle(4), circle(1)}, {circle(4), circle(1)}, {circle(4)}});
  for (std::size_t k : {1u, 2u}) stack.slices[k].contours[1].structure = "pulp";
  EXPECT_EQ(topology_of(certified(stack)), shells({"tooth external genus 0", "pulp external genus 0"}));
  // Together, the pulp is a cavity.
  for (std::size_t k : {1u, 2u}) stack.slices[k].contours[1].structure = "tooth";
  EXPECT_EQ(topology_of(certified(stack)), shells({"tooth external genus 0", "tooth cavity genus 0"}));
}

TEST(Counts, AddUp) {
  const Reconstruction result = certified(two_over_two_crosswise());
  EXPECT_EQ(result.counts.slices, 2u);
  EXPECT_EQ(result.counts.contours, 4u);
  EXPECT_EQ(result.counts.points, 4u * round_points);
  EXPECT_EQ(result.counts.kept, result.solids[0].tetrahedra.tetrahedra.size());
  EXPECT_LE(result.counts.largest_sideways, 1);
}

}  // namespace
}  // namespace odontoscope::test
