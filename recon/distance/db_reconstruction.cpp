#include "recon/distance/db_reconstruction.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "recon/core/arena.h"
#include "recon/distance/limits.h"
#include "recon/input/validate.h"

namespace odontoscope {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(std::vector<DbStageTime>& times) : times_(times) {}
  /// Books the time since the last lap (or the start) on `stage`.
  void lap(const char* stage) {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    const auto known =
        std::find_if(times_.begin(), times_.end(), [stage](const DbStageTime& t) { return t.stage == stage; });
    if (known != times_.end()) {
      known->seconds += seconds;
    } else {
      times_.push_back({stage, seconds});
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<DbStageTime>& times_;
  Clock::time_point last_ = Clock::now();
};

void count_input(const ContourStack& stack, DbReconstruction& result) {
  result.slices = stack.slices.size();
  for (const Slice& slice : stack.slices) {
    result.contours += slice.contours.size();
    for (const Contour& contour : slice.contours) result.points += contour.points.size();
  }
}

void name_shells(DbSurface& made) {
  for (SurfaceReport* report : {&made.report, &made.before}) {
    for (Shell& shell : report->shells) shell.structure = made.structure;
  }
}

void decimate_all(DbReconstruction& result, const DecimateOptions& wanted, const Progress& progress) {
  std::size_t triangles = 0, done = 0;
  for (const DbSurface& made : result.surfaces) triangles += made.surface.triangles.size();
  DecimateOptions options = wanted;
  if (options.largest_error == 0)
    options.largest_error = limits::decimation_error * std::max(result.grid.dx, result.grid.dy);
  for (DbSurface& made : result.surfaces) {
    progress.check();
    progress.tell("decimate", static_cast<double>(done++) / static_cast<double>(result.surfaces.size()));
    if (wanted.triangles) {
      const double share =
          static_cast<double>(made.surface.triangles.size()) / static_cast<double>(std::max<std::size_t>(triangles, 1));
      options.triangles = static_cast<std::size_t>(share * static_cast<double>(*wanted.triangles));
    }
    DecimatedSurface fewer = decimate(made.surface, options);
    made.surface = std::move(fewer.surface);
    made.report = std::move(fewer.report);
    made.decimation_error = fewer.error;
  }
}

DbReconstruction run(const ValidStack& stack, const DbOptions& options, const Progress& progress) {
  DbReconstruction result;
  Stopwatch watch(result.seconds);
  const ContourStack sorted = ordered(stack).stack;
  const std::vector<std::string> structures = structures_of(sorted);
  count_input(sorted, result);
  result.grid = make_grid(sorted, options.grid);  // one field at a time is in memory
  watch.lap("prepare");
  for (const std::string& structure : structures) {
    const Field field = sample_field(sorted, structure, result.grid, options.field, progress);
    watch.lap("distance field");
    DbSurface made{structure, march(result.grid, field, options.cases, progress).mesh, {}, {}, {}};
    watch.lap("marching cubes");
    made.before = inspect(made.surface);
    made.report = made.before;
    result.surfaces.push_back(std::move(made));
    watch.lap("inspect");
  }
  if (options.decimation) {
    decimate_all(result, *options.decimation, progress);
    watch.lap("decimate");
  }
  result.certified = true;
  for (DbSurface& made : result.surfaces) {
    name_shells(made);
    result.certified = result.certified && made.report.closed_oriented_manifold();
  }
  return result;
}

}  // namespace

DbReconstruction reconstruct_by_distance(const ContourStack& stack, const DbOptions& options,
                                         const Progress& progress) {
  const auto limit = allow_threads(options.threads);
  return reconstruct_by_distance(validate(stack, progress), options, progress);
}

DbReconstruction reconstruct_by_distance(const ValidStack& stack, const DbOptions& options, const Progress& progress) {
  const int threads = threads_of(options.threads);
  const auto limit = allow_threads(threads);
  tbb::task_arena arena = arena_of(threads);
  DbReconstruction result = arena.execute([&] { return run(stack, options, progress); });
  result.threads = threads;
  return result;
}

}  // namespace odontoscope
