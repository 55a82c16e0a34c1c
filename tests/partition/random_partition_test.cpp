// Random stacks of several structures: no valid one may fail. ODONTOSCOPE_PARTITION_STACKS says how many (default 300
// small ones), ODONTOSCOPE_PARTITION_FIRST_SEED where to begin, ODONTOSCOPE_PARTITION_KIND which kind alone,
// ODONTOSCOPE_PARTITION_SIZE (small, any, large) of what size, ODONTOSCOPE_PARTITION_FOLDER where shrunk failures are
// written, ODONTOSCOPE_PARTITION_LOUD a line for each, ODONTOSCOPE_PARTITION_BETWEEN (blended, delaunay) how all are
// made, ODONTOSCOPE_PARTITION_PATIENCE seconds of processor time for each. The first failure of each sort is shrunk.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "tests/partition/partition_run.h"
#include "tests/support/stack_text.h"

namespace odontoscope::test {
namespace {

constexpr int shards = 2;
/// A gap is closed triangle by triangle, which may reach a little beyond it; the judge allows nothing beyond
/// (docs/reconstruction.md).
constexpr bool gaps_left_out = true;
constexpr double slowest_allowed = 10;  // seconds of processor time, for 2,000 points and fewer

std::string from_environment(const char* name, const char* otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : text;
}

std::size_t points_of(const ContourStack& stack) {
  std::size_t points = 0;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) points += contour.points.size();
  return points;
}

/// Counts by sort and kind.
class Tally {
 public:
  /// True for the first failure of its sort.
  bool add(std::uint64_t seed, const PartitionCase& given, const PartitionOutcome& outcome) {
    ++stacks_;
    slabs_ += outcome.slabs;
    not_as_implied_ += outcome.not_as_implied;
    raised_ += outcome.raised;
    constrained_ += outcome.constrained;
    tetrahedra_ += outcome.tetrahedra;
    relabelled_ += outcome.relabelled;
    if (outcome.seconds > slowest_) {
      slowest_ = outcome.seconds;
      slowest_words_ = "seed " + std::to_string(seed) + " (" + given.kind + ", " +
                       std::to_string(points_of(given.stack)) + " points)";
    }
    if (outcome.end == PartitionEnd::certified)
      ++certified_;
    else {
      auto& kinds = ends_[outcome.sort()];
      ++kinds[given.kind];
      return outcome.failed() && kinds.size() == 1 && kinds.begin()->second == 1;
    }
    return false;
  }

  void print(std::ostream& out, double seconds) const {
    out << stacks_ << " stacks, " << certified_ << " certified, " << seconds << " s; " << tetrahedra_ << " tetrahedra, "
        << relabelled_ << " relabelled, " << slabs_ << " slabs of structures, " << not_as_implied_
        << " not as implied, " << raised_ << " raised slabs, " << constrained_ << " constrained slices; slowest "
        << slowest_ << " s of processor time: " << slowest_words_ << "\n";
    for (const auto& [sort, kinds] : ends_) {
      std::size_t all = 0;
      for (const auto& [kind, count] : kinds) all += count;
      out << "  " << all << "  " << sort << "  [";
      for (const auto& [kind, count] : kinds) out << " " << kind << " " << count;
      out << " ]\n";
    }
  }

 private:
  std::size_t stacks_ = 0, certified_ = 0, slabs_ = 0, not_as_implied_ = 0, raised_ = 0, constrained_ = 0,
              tetrahedra_ = 0, relabelled_ = 0;
  double slowest_ = 0;
  std::string slowest_words_;
  std::map<std::string, std::map<std::string, std::size_t>> ends_;
};

std::string options_in_words(const PartitionCase& given) {
  std::string words = "--priority ";
  for (std::size_t i = 0; i < given.priority.size(); ++i) words += (i == 0 ? "" : ",") + given.priority[i];
  if (given.gap > 0) words += " --gap " + std::to_string(given.gap);
  return words + (given.delaunay ? " --between delaunay" : "");
}

/// Prints the failure in the fewest points, and writes it into the folder, if there is one, as drawn and in the fewest
/// points.
void show_small(std::uint64_t seed, const PartitionCase& given, const PartitionOutcome& outcome) {
  if (const std::string folder = from_environment("ODONTOSCOPE_PARTITION_FOLDER", ""); !folder.empty())
    std::ofstream(folder + "/drawn-" + std::to_string(seed) + ".json") << to_text(given.stack);
  const PartitionCase small = smallest_alike(given);
  std::cout << "seed " << seed << ", " << given.kind << ", " << options_in_words(small) << ", " << outcome.sort()
            << ":\n"
            << to_text(small.stack) << "\n"
            << std::flush;
  const std::string folder = from_environment("ODONTOSCOPE_PARTITION_FOLDER", "");
  if (folder.empty()) return;
  std::string file = given.kind + "-" + outcome.sort().substr(0, 60) + "-" + std::to_string(seed);
  std::replace_if(
      file.begin(), file.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '-'; }, '_');
  std::ofstream(folder + "/" + file + ".json") << to_text(small.stack);
  std::string message = outcome.message;
  std::replace(message.begin(), message.end(), '\n', ';');
  std::ofstream(folder + "/LIST.txt", std::ios::app)
      << "seed " << seed << " " << from_environment("ODONTOSCOPE_PARTITION_SIZE", "small") << " | " << file
      << ".json | " << options_in_words(small) << " | " << message.substr(0, 400) << "\n";
}

class RandomPartitions : public testing::TestWithParam<int> {};

TEST_P(RandomPartitions, NeverFail) {
  const bool by_command = std::getenv("ODONTOSCOPE_PARTITION_STACKS") != nullptr;
  const std::uint64_t count =
      std::strtoull(from_environment("ODONTOSCOPE_PARTITION_STACKS", "300").c_str(), nullptr, 10);
  const std::uint64_t first =
      std::strtoull(from_environment("ODONTOSCOPE_PARTITION_FIRST_SEED", "0").c_str(), nullptr, 10);
  const std::string kind = from_environment("ODONTOSCOPE_PARTITION_KIND", "");
  const std::string size = from_environment("ODONTOSCOPE_PARTITION_SIZE", "small");
  const PartitionSize wanted = size == "large" ? PartitionSize::large
                               : size == "any" ? PartitionSize::any
                                               : PartitionSize::small;
  const auto start = std::chrono::steady_clock::now();
  const double timeout = std::strtod(from_environment("ODONTOSCOPE_PARTITION_PATIENCE", "60").c_str(), nullptr);
  Tally tally;
  int shrunk = 0;                                         // as a plain test only one: it has to be quick
  const std::uint64_t shard = std::uint64_t(GetParam());  // in a row, so that each shard has every kind
  for (std::uint64_t seed = first + count * shard / shards; seed < first + count * (shard + 1) / shards; ++seed) {
    if (!kind.empty() && partition_kinds()[seed % partition_kinds().size()] != kind) continue;
    PartitionCase given = partition_case(seed, wanted);
    if (const std::string between = from_environment("ODONTOSCOPE_PARTITION_BETWEEN", ""); !between.empty())
      given.delaunay = between == "delaunay";
    if (!by_command && gaps_left_out) given.gap = 0;
    PartitionOutcome outcome = outcome_of(given, timeout);
    if (by_command && !outcome.failed() && outcome.seconds > slowest_allowed) {  // other programs' load does not count
      outcome.end = PartitionEnd::too_slow;
      outcome.message = "slower than allowed";
    }
    if (std::getenv("ODONTOSCOPE_PARTITION_LOUD") != nullptr)
      std::cout << seed << " " << given.kind << " " << points_of(given.stack) << " points, " << outcome.tetrahedra
                << " tetrahedra, " << outcome.seconds << " s: " << outcome.sort() << "\n"
                << std::flush;
    if (tally.add(seed, given, outcome)) {
      ADD_FAILURE() << "seed " << seed << " (" << given.kind << "): " << outcome.message;
      if (by_command || shrunk++ < 1) show_small(seed, given, outcome);
    }
  }
  tally.print(std::cout, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

/// ODONTOSCOPE_PARTITION_FILE, one stack as JSON, with ODONTOSCOPE_PARTITION_PRIORITY (names with commas) and _GAP,
/// judged by itself.
TEST(GivenPartition, IsCertified) {
  const std::string file = from_environment("ODONTOSCOPE_PARTITION_FILE", "");
  if (file.empty()) GTEST_SKIP() << "by command only";
  PartitionCase given{.stack = read_stack_file(file), .priority = {}, .kind = file};
  std::stringstream names(from_environment("ODONTOSCOPE_PARTITION_PRIORITY", ""));
  for (std::string name; std::getline(names, name, ',');) given.priority.push_back(name);
  given.gap = std::strtod(from_environment("ODONTOSCOPE_PARTITION_GAP", "0").c_str(), nullptr);
  given.delaunay = from_environment("ODONTOSCOPE_PARTITION_BETWEEN", "") == "delaunay";
  const PartitionOutcome outcome = outcome_of(given);
  std::cout << name(outcome.end) << " " << outcome.message << " " << outcome.tetrahedra << " tetrahedra\n";
  EXPECT_FALSE(outcome.failed());
}

INSTANTIATE_TEST_SUITE_P(All, RandomPartitions, testing::Range(0, shards));

}  // namespace
}  // namespace odontoscope::test
