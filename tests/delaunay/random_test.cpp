// Random stacks, each also seen differently. ODONTOSCOPE_RANDOM_STACKS says how many (default 200),
// ODONTOSCOPE_RANDOM_FIRST_SEED where to begin (default 0); as a plain test every second one is seen from one side
// only. A failing seed is printed with a smallest stack that fails alike, ready for tests/corpus/engine.

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/delaunay/engine_checks.h"
#include "tests/support/random_stacks.h"
#include "tests/support/variants.h"

namespace odontoscope::test {
namespace {

constexpr int shards = 4;           // so that ctest -j has something to spread
constexpr int shrunk_failures = 3;  // of each shard; further ones are only listed

ReconstructOptions options_for(std::uint64_t seed) {
  constexpr Correspondence all[] = {Correspondence::tracked, Correspondence::medial, Correspondence::overlap,
                                    Correspondence::reverse};
  return {.correspondence = all[seed / 5 % 4], .between = Between::delaunay, .links = {}, .threads = 1};
}

/// Empty if all is well with this stack; else what is wrong, in words that do not depend on its size. Turned copies
/// must come out alike where the two slices alone decide; a raster between them does not turn with them.
std::string trouble_with(const ContourStack& stack, std::uint64_t seed, bool general_position, bool every_side) {
  const ReconstructOptions options = options_for(seed);
  const Outcome usual = outcome_of(stack, options);
  if (!usual.failure.empty()) return usual.failure;
  if (seed % 3 == 0) {  // it takes as long as several of the others
    ReconstructOptions blended = options;
    blended.between = Between::blended;
    if (const Outcome seen = outcome_of(stack, blended); !seen.failure.empty()) return "blended: " + seen.failure;
  }
  if (!every_side) return {};
  for (const Variant& variant : variants_of(stack, seed)) {
    const Outcome seen = outcome_of(variant.stack, options);
    if (!seen.failure.empty()) return std::string(variant.name) + ": " + seen.failure;
    if ((general_position || variant.keeps_order_of_points) && seen.topology != usual.topology)
      return std::string("another topology when ") + variant.name;
  }
  return {};
}

class RandomStackShard : public testing::TestWithParam<int> {};

TEST_P(RandomStackShard, IsCertifiedFromEverySide) {
  const bool by_command = std::getenv("ODONTOSCOPE_RANDOM_STACKS") != nullptr;
  const std::uint64_t count = number_from_environment("ODONTOSCOPE_RANDOM_STACKS", 200);
  const std::uint64_t first = number_from_environment("ODONTOSCOPE_RANDOM_FIRST_SEED", 0);
  int failures = 0;
  for (std::uint64_t seed = first + std::uint64_t(GetParam()); seed < first + count; seed += shards) {
    const RandomStack random = random_stack(seed);
    const bool every_side = by_command || seed / shards % 2 == 0;
    const auto trouble = [&](const ContourStack& stack) {
      return trouble_with(stack, seed, random.general_position, every_side);
    };
    const std::string what = trouble(random.stack);
    if (what.empty()) continue;
    ADD_FAILURE() << "seed " << seed << " (" << random.kind << "): " << what;
    if (++failures <= shrunk_failures)
      ADD_FAILURE() << "seed " << seed << " shrunk: " << smallest_failing(random.stack, trouble);
  }
}

INSTANTIATE_TEST_SUITE_P(All, RandomStackShard, testing::Range(0, shards));

}  // namespace
}  // namespace odontoscope::test
