// Strange stacks: no valid one may fail. ODONTOSCOPE_STRANGE_STACKS says how many (default 400 cheap ones; if it is
// set, of any size), ODONTOSCOPE_STRANGE_FIRST_SEED where to begin, ODONTOSCOPE_STRANGE_KIND which kind alone,
// ODONTOSCOPE_STRANGE_FOLDER where shrunk failures are written, ODONTOSCOPE_STRANGE_CHEAP that cheap ones will do,
// ODONTOSCOPE_STRANGE_LARGE that all have some 2,000 points, ODONTOSCOPE_STRANGE_BETWEEN (blended, delaunay) how all
// are made. The first failure of each sort and kind is shrunk. Each shard prints a summary. ODONTOSCOPE_STRANGE_TIMES,
// a number of stacks of each kind with some 2,000 points, makes StrangeTimes measure how long they take by `tracked`,
// both ways between slices.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

#include "tests/delaunay/strange_run.h"
#include "tests/support/stack_text.h"

namespace odontoscope::test {
namespace {

constexpr int shards = 4;               // so that ctest -j has something to spread
constexpr double slowest_allowed = 10;  // seconds of processor time, for 2,000 points and fewer

const char* from_environment(const char* name, const char* otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : text;
}

/// Counts by sort and kind.
class Tally {
 public:
  /// True for the first failure of its sort and kind.
  bool add(std::uint64_t seed, const StrangeStack& strange, const StrangeOutcome& outcome) {
    ++stacks_;
    thrown_away_ += std::size_t(strange.thrown_away);
    if (outcome.seconds > slowest_) {
      slowest_ = outcome.seconds;
      slowest_words_ = "seed " + std::to_string(seed) + " (" + strange.kind + ", " +
                       std::to_string(points_of(strange.stack)) + " points)";
    }
    if (!outcome.not_as_implied.empty()) ++not_as_implied_;
    if (outcome.end == StrangeEnd::certified)
      ++certified_;
    else if (++ends_[outcome.sort()][strange.kind] == 1)
      return outcome.failed();
    return false;
  }

  void print(std::ostream& out, double seconds) const {
    out << stacks_ << " stacks, " << certified_ << " certified (" << not_as_implied_
        << " with another topology than implied), " << thrown_away_ << " drafts thrown away, " << seconds
        << " s; slowest " << slowest_ << " s of processor time: " << slowest_words_ << "\n";
    for (const auto& [sort, kinds] : ends_) {
      std::size_t all = 0;
      for (const auto& [kind, count] : kinds) all += count;
      out << "  " << all << "  " << sort << "  [";
      for (const auto& [kind, count] : kinds) out << " " << kind << " " << count;
      out << " ]\n";
    }
  }

 private:
  std::size_t stacks_ = 0, certified_ = 0, not_as_implied_ = 0, thrown_away_ = 0;
  double slowest_ = 0;
  std::string slowest_words_;
  std::map<std::string, std::map<std::string, std::size_t>> ends_;
};

/// ODONTOSCOPE_STRANGE_BETWEEN, blended or delaunay, overrules the seed.
StrangeWay chosen_way(std::uint64_t seed) {
  StrangeWay way = way_of(seed);
  const std::string between = from_environment("ODONTOSCOPE_STRANGE_BETWEEN", "");
  if (between == "blended") way.between = Between::blended;
  if (between == "delaunay") way.between = Between::delaunay;
  return way;
}

/// Prints the failure in the fewest points, and writes it into the folder, if there is one.
void show_small(std::uint64_t seed, const StrangeStack& strange, const StrangeOutcome& outcome) {
  const StrangeWay way = chosen_way(seed);
  const LinkedStack small = smallest_alike({strange.stack, strange.links}, way);
  std::cout << in_words(way) << ", seed " << seed << ", " << strange.kind << ", " << outcome.sort() << ":\n"
            << to_text(small.stack) << "\n";
  if (!small.links.empty()) std::cout << to_text(small.links) << "\n";
  std::cout << std::flush;
  const std::string folder = from_environment("ODONTOSCOPE_STRANGE_FOLDER", "");
  if (folder.empty()) return;
  std::string file =
      strange.kind + "-" + outcome.sort().substr(0, 60) + "-" + in_words(way) + "-" + std::to_string(seed);
  std::replace_if(
      file.begin(), file.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '-'; }, '_');
  std::ofstream(folder + "/" + file + ".json") << to_text(small.stack);
  if (!small.links.empty()) std::ofstream(folder + "/" + file + ".links.json") << to_text(small.links);
}

class StrangeStackShard : public testing::TestWithParam<int> {};

TEST_P(StrangeStackShard, NeverFails) {
  const bool by_command = std::getenv("ODONTOSCOPE_STRANGE_STACKS") != nullptr;
  const std::uint64_t count = std::strtoull(from_environment("ODONTOSCOPE_STRANGE_STACKS", "400"), nullptr, 10);
  const std::uint64_t first = std::strtoull(from_environment("ODONTOSCOPE_STRANGE_FIRST_SEED", "0"), nullptr, 10);
  const std::string kind = from_environment("ODONTOSCOPE_STRANGE_KIND", "");
  const bool cheap = !by_command || std::getenv("ODONTOSCOPE_STRANGE_CHEAP") != nullptr;
  const bool large = by_command && std::getenv("ODONTOSCOPE_STRANGE_LARGE") != nullptr;
  const StrangeSize size = large ? StrangeSize::large : cheap ? StrangeSize::cheap : StrangeSize::any;
  const auto start = std::chrono::steady_clock::now();
  Tally tally;
  int shrunk = 0;                                         // as a plain test only two: it has to be quick
  const std::uint64_t shard = std::uint64_t(GetParam());  // in a row, so that each shard has every kind
  for (std::uint64_t seed = first + count * shard / shards; seed < first + count * (shard + 1) / shards; ++seed) {
    if (!kind.empty() && strange_kinds()[seed % strange_kinds().size()] != kind) continue;
    const StrangeStack strange = strange_stack(seed, size);
    StrangeOutcome outcome = outcome_of(LinkedStack{strange.stack, strange.links}, chosen_way(seed));
    if (by_command && !cheap && !outcome.failed() &&
        outcome.seconds > slowest_allowed) {  // other programs' load does not count
      outcome.end = StrangeEnd::too_slow;
      outcome.message = "slower than allowed";
    }
    if (tally.add(seed, strange, outcome)) {
      ADD_FAILURE() << "seed " << seed << " (" << strange.kind << "): " << outcome.message;
      if (by_command || shrunk++ < 2) show_small(seed, strange, outcome);
    }
  }
  tally.print(std::cout, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

TEST(StrangeTimes, AreBelowTenSecondsForTwoThousandPoints) {
  const std::uint64_t each = std::strtoull(from_environment("ODONTOSCOPE_STRANGE_TIMES", "0"), nullptr, 10);
  if (each == 0) GTEST_SKIP() << "by command only";
  const std::uint64_t first = std::strtoull(from_environment("ODONTOSCOPE_STRANGE_FIRST_SEED", "0"), nullptr, 10);
  const std::string kind = from_environment("ODONTOSCOPE_STRANGE_KIND", "");
  for (std::uint64_t seed = first; seed < first + each * strange_kinds().size(); ++seed) {
    const StrangeStack strange = strange_stack(seed, StrangeSize::large);
    if (!kind.empty() && strange.kind != kind) continue;
    std::cout << strange.kind << " (seed " << seed << "), " << points_of(strange.stack) << " points:";
    for (const Between between : {Between::delaunay, Between::blended}) {
      const StrangeOutcome outcome =
          outcome_of({strange.stack, strange.links}, {Correspondence::tracked, between}, 60, false);
      std::cout << " " << outcome.seconds << " s"
                << (outcome.end == StrangeEnd::certified ? "" : ", " + outcome.sort());
      EXPECT_FALSE(outcome.failed()) << outcome.message;
      EXPECT_LE(outcome.seconds, slowest_allowed) << strange.kind << ", seed " << seed;
    }
    std::cout << std::endl;
  }
}

INSTANTIATE_TEST_SUITE_P(All, StrangeStackShard, testing::Range(0, shards));

}  // namespace
}  // namespace odontoscope::test
