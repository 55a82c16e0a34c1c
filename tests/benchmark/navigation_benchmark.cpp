// What flying costs: the nearest wall, the exact side, and a frame's flight, in the pulp of the CT molar (of the sample
// molar where that data set is not there).
//
//   odontoscope_navigation_benchmark     Google Benchmark's own options apply

#include <benchmark/benchmark.h>

#include <glm/geometric.hpp>
#include <vector>

#include "engine/navigate/flight.h"
#include "tests/navigate/cavities.h"
#include "tests/support/random_numbers.h"

namespace odontoscope {
namespace {

struct Pulp {
  Walls walls;
  FlightRules rules;
  glm::dvec3 middle{0};
  std::vector<glm::dvec3> places;  // where flights come by

  Pulp() {
    const SurfaceMesh* ct = test::ct_molar_pulp();
    walls = Walls(ct ? *ct : test::sample_molar_pulp());
    const Walls outside(ct ? *test::ct_molar_outside() : test::sample_molar_outside());
    rules = rules_for(0.5 * glm::length(outside.bounds().high - outside.bounds().low));
    middle = place_of_largest_clearance(walls)->at;
    test::RandomNumbers random(7);
    Flight flight = looking(middle, {0, 0, -1});
    FlightWish wish{{0, 0, 1}, {}};
    for (int i = 0; i < 20'000; ++i) {
      if (random.chance(0.03))
        wish = {{random.between(-1, 1), random.between(-1, 1), 1}, {random.between(-1, 1), random.between(-1, 1)}};
      flight = flight_after(flight, wish, walls, rules, 1.0 / 60);
      places.push_back(flight.eye);
    }
  }
};

const Pulp& pulp() {
  static const Pulp made;
  return made;
}

void nearest_wall(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(pulp().walls.nearest(pulp().places[i++ % pulp().places.size()]));
  state.counters["triangles"] = double(pulp().walls.size());
}

void exact_side(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(pulp().walls.locate(pulp().places[i++ % pulp().places.size()]));
}

void frame_at_60(benchmark::State& state) {
  Flight flight = looking(pulp().middle, {0, 0, -1});
  for (auto _ : state) {
    flight = flight_after(flight, {{0.3, 0, 1}, {0.2, 0.05}}, pulp().walls, pulp().rules, 1.0 / 60);
    benchmark::DoNotOptimize(flight);
  }
}

void walls_made(benchmark::State& state) {
  const SurfaceMesh& surface = test::ct_molar_pulp() ? *test::ct_molar_pulp() : test::sample_molar_pulp();
  for (auto _ : state) benchmark::DoNotOptimize(Walls(surface));
}

void roomiest(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(place_of_largest_clearance(pulp().walls));
}

BENCHMARK(nearest_wall);
BENCHMARK(exact_side);
BENCHMARK(frame_at_60);
BENCHMARK(walls_made)->Unit(benchmark::kMillisecond);
BENCHMARK(roomiest)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace odontoscope

BENCHMARK_MAIN();
