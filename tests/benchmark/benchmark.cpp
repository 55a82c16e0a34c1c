// Is the engine as fast as it should be? Bare Delaunay triangulation of all slabs against everything from contours in
// memory to the certified surface, in one run on one machine, and the ratios; DT against DB (distance field and
// marching cubes), with how far DB stays off the contours at each grid; then peak memory for each contour point.
//
//   odontoscope_benchmark              the molar; Google Benchmark's own options apply
//   odontoscope_benchmark --large      also a made-up stack of 2,000 slices with 2,000 points each (minutes, and
//   gigabytes)

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "recon/compare/contour_fit.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/validate.h"
#include "tests/benchmark/bare_delaunay.h"
#include "tests/benchmark/inputs.h"
#include "tests/benchmark/peak_memory.h"

namespace odontoscope {
namespace {

using benchmark_inputs::points_of;

constexpr const char* bare = "bare Delaunay, 1 thread";
constexpr const char* whole_1 = "contours to certified, 1 thread";
constexpr const char* whole_2 = "contours to certified, 2 threads";

constexpr std::size_t db_grids[] = {64, 128, 256, 512};

std::string db_name(std::size_t grid) { return "DB, grid " + std::to_string(grid) + ", 1 thread"; }

DbOptions db_options(std::size_t grid) {
  DbOptions options;
  options.grid.columns = options.grid.rows = grid;
  options.threads = 1;
  return options;
}

/// From contours in memory to the inspected surface, as for DT.
void contours_by_distance(benchmark::State& state, const ContourStack& stack, std::size_t grid) {
  for (auto _ : state) {
    const DbReconstruction result = reconstruct_by_distance(stack, db_options(grid));
    state.counters["triangles"] = double(result.surfaces.at(0).report.triangles);
    for (const DbStageTime& stage : result.seconds) state.counters[stage.stage + "_ms"] = stage.seconds * 1e3;
  }
}

void bare_delaunay(benchmark::State& state, const ContourStack& stack) {
  const BareDelaunay slabs(stack);
  for (auto _ : state) benchmark::DoNotOptimize(slabs.run());
}

void contours_to_certified(benchmark::State& state, const ContourStack& stack, int threads) {
  for (auto _ : state) {
    const Reconstruction result =
        reconstruct(stack, {.correspondence = Correspondence::medial, .links = {}, .threads = threads});
    if (!result.certified) state.SkipWithError("not certified");
    state.counters["tetrahedra"] = double(result.counts.kept);
    for (const StageTime& stage : result.seconds) state.counters[stage.stage + "_ms"] = stage.seconds * 1e3;
  }
}

struct Seconds {
  double wall = 0, processor = 0;
};

/// Shows what Google Benchmark shows, and keeps the least of all repetitions for the ratios: others' work on the
/// machine only adds.
class Reporter : public benchmark::ConsoleReporter {
 public:
  Reporter() : ConsoleReporter(isatty(STDOUT_FILENO) != 0 ? OO_Defaults : OO_Tabular) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double count = double(run.iterations);
      const Seconds here{run.real_accumulated_time / count, run.cpu_accumulated_time / count};
      Seconds& least = least_.emplace(run.run_name.function_name, here).first->second;
      least = {std::min(least.wall, here.wall), std::min(least.processor, here.processor)};
    }
    ConsoleReporter::ReportRuns(runs);
  }
  Seconds least(const std::string& name) const {
    const auto found = least_.find(name);
    return found == least_.end() ? Seconds{} : found->second;
  }

 private:
  std::map<std::string, Seconds> least_;
};

void print_ratios(const Reporter& reporter) {
  const Seconds base = reporter.least(bare), one = reporter.least(whole_1), two = reporter.least(whole_2);
  if (base.wall == 0 || one.wall == 0)
    std::printf("no ratios: they need single repetitions, not filtered out and not only aggregates\n");
  if (base.wall > 0 && one.wall > 0)
    std::printf("one thread takes %.2f times bare Delaunay, %.2f in processor time (bar: at most 1.5)\n",
                one.wall / base.wall, one.processor / base.processor);
  if (one.wall > 0 && two.wall > 0)
    std::printf("two threads are %.2f times as fast as one (bar: at least 1.8); it takes two idle cores to tell\n",
                one.wall / two.wall);
}

/// All structures' contours to their surfaces, mm.
ContourFit fit_of_db(const ContourStack& stack, std::size_t grid) {
  const ContourStack sorted = ordered(stack).stack;
  std::vector<WeightedFit> fits;
  for (const DbSurface& made : reconstruct_by_distance(stack, db_options(grid)).surfaces)
    fits.push_back({contour_fit(sorted, made.structure, made.surface), contour_length(sorted, made.structure)});
  return joined(fits);
}

/// DT passes through the contours; no grid does, so there is no equal distance: what a grid costs in time is set beside
/// what it lacks.
void print_dt_against_db(const Reporter& reporter, const ContourStack& stack) {
  const Seconds dt = reporter.least(whole_1);
  for (const std::size_t grid : db_grids) {
    const Seconds db = reporter.least(db_name(grid));
    if (dt.wall == 0 || db.wall == 0) continue;
    const ContourFit fit = fit_of_db(stack, grid);
    std::printf(
        "DB on %zu x %zu takes %.2f times as long as DT, %.2f in processor time; contours to surface %.4f mm on "
        "average, %.3f at most (DT: 0)\n",
        grid, grid, db.wall / dt.wall, db.processor / dt.processor, fit.contours_to_surface.mean,
        fit.contours_to_surface.largest);
  }
}

void print_memory(const char* name, const PeakMemory& memory, std::size_t points) {
  if (!memory.measured) {
    std::printf("%s: peak memory could not be measured\n", name);
    return;
  }
  const double mebi = 1024.0 * 1024.0;
  std::printf("%s: peak %.1f MiB, %.0f bytes a contour point (bar: below 2048) over the %.1f MiB before it; %.2f s\n",
              name, double(memory.peak) / mebi, double(memory.peak - memory.contours) / double(points),
              double(memory.contours) / mebi, memory.seconds);
}

void large(int threads) {
  constexpr std::size_t slices = 2000, points = 2000;
  const PeakMemory memory = peak_memory([] { return benchmark_inputs::made_up(slices, points); }, threads);
  print_memory("2,000 slices of 2,000 points", memory, slices * points);
  if (memory.measured)
    std::printf("that is %.2f GiB in all (bar: within 12)\n", double(memory.peak) / (1024.0 * 1024.0 * 1024.0));
}

}  // namespace
}  // namespace odontoscope

int main(int argc, char** argv) {
  using namespace odontoscope;
  bool with_large = false;
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--large") == 0) {
      with_large = true;
      std::copy(argv + i + 1, argv + argc, argv + i);
      --argc;
    }
  // First, while this process is small: a child starts with its parent's memory.
  const PeakMemory memory = peak_memory([] { return benchmark_inputs::molar().stack; }, 1);
  if (with_large) large(2);

  const benchmark_inputs::Molar molar = benchmark_inputs::molar();
  std::printf("%s: %zu slices, %zu points\n", molar.name.c_str(), molar.stack.slices.size(), points_of(molar.stack));
  const auto add = [](const char* name, auto run) {
    benchmark::RegisterBenchmark(name, run)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime()
        ->Repetitions(5);
  };
  add(bare, [&](benchmark::State& state) { bare_delaunay(state, molar.stack); });
  add(whole_1, [&](benchmark::State& state) { contours_to_certified(state, molar.stack, 1); });
  add(whole_2, [&](benchmark::State& state) { contours_to_certified(state, molar.stack, 2); });
  for (const std::size_t grid : db_grids)
    add(db_name(grid).c_str(),
        [&molar, grid](benchmark::State& state) { contours_by_distance(state, molar.stack, grid); });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  print_ratios(reporter);
  print_dt_against_db(reporter, molar.stack);
  print_memory(molar.name.c_str(), memory, points_of(molar.stack));
  return 0;
}
