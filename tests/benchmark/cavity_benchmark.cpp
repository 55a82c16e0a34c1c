// How long until the centre lines are there, once the model is? (Bar: 200 ms for the CT molar.) And what a question to
// the wall costs.

#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include <string>
#include <vector>

#include "recon/cavity/centre_lines.h"
#include "recon/cavity/wall_tree.h"
#include "recon/core/error.h"
#include "recon/delaunay/reconstruct.h"
#include "tests/benchmark/inputs.h"

namespace odontoscope {
namespace {

Cavity largest_void(const ContourStack& stack) {
  std::vector<StructureSurface> surfaces;
  const Reconstruction made = reconstruct(stack);
  for (const Solid& solid : made.solids) surfaces.push_back({solid.structure, &solid.surface});
  std::vector<Cavity> cavities = cavities_in(surfaces);
  if (cavities.empty()) throw InternalError("the molar has no pulp");
  return std::move(cavities.front());
}

void lines(benchmark::State& state, const Cavity& cavity, int threads) {
  tbb::task_arena arena(threads);
  for (auto _ : state) {
    const CentreLines found = arena.execute([&] { return centre_lines(cavity); });
    state.counters["canals"] = static_cast<double>(found.canals.size());
  }
  state.counters["triangles"] = static_cast<double>(cavity.wall.triangles.size());
}

void wall_distance(benchmark::State& state, const Cavity& cavity) {
  const WallTree tree(cavity.wall);
  const CentreLines found = centre_lines(cavity);
  std::size_t i = 0;
  const std::vector<CentrePoint>& points = found.canals.at(0).points;
  for (auto _ : state) benchmark::DoNotOptimize(tree.clearance(points[i++ % points.size()].at));
}

}  // namespace
}  // namespace odontoscope

int main(int argc, char** argv) {
  using namespace odontoscope;
  benchmark::Initialize(&argc, argv);
  const benchmark_inputs::Molar molar = benchmark_inputs::molar();
  const Cavity cavity = largest_void(molar.stack);
  for (const int threads : {1, 2})
    benchmark::RegisterBenchmark((molar.name + ": centre lines, threads: " + std::to_string(threads)).c_str(),
                                 [&cavity, threads](benchmark::State& state) { lines(state, cavity, threads); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  benchmark::RegisterBenchmark((molar.name + ": distance to the wall from the centre line").c_str(),
                               [&cavity](benchmark::State& state) { wall_distance(state, cavity); });
  benchmark::RunSpecifiedBenchmarks();
}
