// Strange stacks: no valid one may fail. ODONTOSCOPE_STRANGE_STACKS says how many (default 1,000 cheap ones; if it is set, of any size), ODONTOSCOPE_STRANGE_FIRST_SEED
// where to begin, ODONTOSCOPE_STRANGE_KIND which kind alone, ODONTOSCOPE_STRANGE_FOLDER where shrunk failures are written. Each shard prints a summary.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

#include "tests/delaunay/strange_run.h"
#include "tests/support/stack_text.h"

namespace odontoscope::test {
namespace {

constexpr int shards = 4;          // so that ctest -j has something to spread
constexpr double slowest_allowed = 10;   // seconds of processor time, for 2,000 points and fewer

const char* from_environment(const char* name, const char* otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : text;
}

std::size_t points_of(const ContourStack& stack) {
  std::size_t points = 0;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) points += contour.points.size();
  return points;
}

/// Counts, and the smallest failure of each sort.
class Tally {
 public:
  void add(std::uint64_t seed, const StrangeStack& strange, const StrangeOutcome& outcome) {
    ++stacks_;
    thrown_away_ += std::size_t(strange.thrown_away);
    const std::size_t points = points_of(strange.stack);
    if (outcome.end == StrangeEnd::certified) ++certified_;
    else ++ends_[outcome.sort()][strange.kind];
    if (outcome.seconds > slowest_) {
      slowest_ = outcome.seconds;
      slowest_words_ = "seed " + std::to_string(seed) + " (" + strange.kind + ", " + std::to_string(points) + " points)";
    }
    if (!outcome.failed()) return;
    Worst& smallest = failures_[strange.kind + ", " + outcome.sort()];
    if (smallest.points == 0 || points < smallest.points) smallest = {points, seed, outcome.message};
  }

  void print(std::ostream& out, double seconds) const {
    out << stacks_ << " stacks, " << certified_ << " certified, " << thrown_away_ << " drafts thrown away, " << seconds << " s; slowest " << slowest_
        << " s of processor time: " << slowest_words_ << "\n";
    for (const auto& [sort, kinds] : ends_) {
      std::size_t all = 0;
      for (const auto& [kind, count] : kinds) all += count;
      out << "  " << all << "  " << sort << "  [";
      for (const auto& [kind, count] : kinds) out << " " << kind << " " << count;
      out << " ]\n";
    }
  }

  struct Worst {
    std::size_t points = 0;
    std::uint64_t seed = 0;
    std::string message;
  };
  const std::map<std::string, Worst>& failures() const { return failures_; }

 private:
  std::size_t stacks_ = 0, certified_ = 0, thrown_away_ = 0;
  double slowest_ = 0;
  std::string slowest_words_;
  std::map<std::string, std::map<std::string, std::size_t>> ends_;   // by sort, by kind
  std::map<std::string, Worst> failures_;
};

void report_failures(const Tally& tally, StrangeSize size, std::size_t shrunk_at_most) {
  const std::string folder = from_environment("ODONTOSCOPE_STRANGE_FOLDER", "");
  for (const auto& [name, worst] : tally.failures()) {
    ADD_FAILURE() << "seed " << worst.seed << " (" << name << "): " << worst.message;
    if (shrunk_at_most-- == 0) return;
    const StrangeStack strange = strange_stack(worst.seed, size);
    const LinkedStack small = smallest_alike({strange.stack, strange.links}, criterion_of(worst.seed));
    std::cout << odontoscope::name(criterion_of(worst.seed)) << ", seed " << worst.seed << ", " << name << ":\n" << to_text(small.stack) << "\n";
    if (!small.links.empty()) std::cout << to_text(small.links) << "\n";
    if (folder.empty()) continue;
    std::string file = folder + "/" + name + "-" + odontoscope::name(criterion_of(worst.seed)) + "-" + std::to_string(worst.seed);
    std::replace_if(file.begin() + long(folder.size()) + 1, file.end(), [](char c) { return c == ' ' || c == ':' || c == ',' || c == '/'; }, '_');
    std::ofstream(file + ".json") << to_text(small.stack);
    if (!small.links.empty()) std::ofstream(file + ".links") << to_text(small.links);
  }
}

class StrangeStackShard : public testing::TestWithParam<int> {};

TEST_P(StrangeStackShard, NeverFails) {
  const bool by_command = std::getenv("ODONTOSCOPE_STRANGE_STACKS") != nullptr;
  const std::uint64_t count = std::strtoull(from_environment("ODONTOSCOPE_STRANGE_STACKS", "1000"), nullptr, 10);
  const std::uint64_t first = std::strtoull(from_environment("ODONTOSCOPE_STRANGE_FIRST_SEED", "0"), nullptr, 10);
  const std::string kind = from_environment("ODONTOSCOPE_STRANGE_KIND", "");
  const StrangeSize size = by_command ? StrangeSize::any : StrangeSize::cheap;
  const auto start = std::chrono::steady_clock::now();
  Tally tally;
  const std::uint64_t shard = std::uint64_t(GetParam());   // in a row, so that each shard has every kind
  for (std::uint64_t seed = first + count * shard / shards; seed < first + count * (shard + 1) / shards; ++seed) {
    if (!kind.empty() && strange_kinds()[seed % strange_kinds().size()] != kind) continue;
    const StrangeStack strange = strange_stack(seed, size);
    StrangeOutcome outcome = outcome_of(LinkedStack{strange.stack, strange.links}, criterion_of(seed));
    if (by_command && !outcome.failed() && outcome.seconds > slowest_allowed) {   // other programs' load does not count
      outcome.end = StrangeEnd::too_slow;
      outcome.message = "slower than allowed";
    }
    tally.add(seed, strange, outcome);
  }
  tally.print(std::cout, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  report_failures(tally, size, by_command ? 1000 : 2);
}

INSTANTIATE_TEST_SUITE_P(All, StrangeStackShard, testing::Range(0, shards));

}  // namespace
}  // namespace odontoscope::test
