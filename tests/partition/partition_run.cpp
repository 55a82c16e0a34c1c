#include "tests/partition/partition_run.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <set>
#include <thread>

#include "recon/core/error.h"
#include "recon/partition/reconstruct_partition.h"
#include "tests/partition/partition_oracle.h"
#include "tests/support/refusal_check.h"
#include "tests/support/shrink.h"
#include "tests/support/stack_text.h"

namespace odontoscope::test {
namespace {

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// Asks for a stop once the processor time is up; a run that does not heed it for twice as long ends the program,
/// saying for which stack.
class Timeout {
 public:
  Timeout(double seconds, const ContourStack& stack)
      : end_(processor_seconds() + seconds),
        hard_end_(end_ + 2 * seconds),
        thread_([this, &stack](std::stop_token done) { watch(done, stack); }) {}
  std::stop_token token() const { return stop_.get_token(); }

 private:
  void watch(std::stop_token done, const ContourStack& stack) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, done, std::chrono::milliseconds(500), [&] { return done.stop_requested(); }) &&
           !done.stop_requested()) {
      if (processor_seconds() > end_) stop_.request_stop();
      if (processor_seconds() < hard_end_) continue;
      std::fprintf(stderr, "hangs, and heeds no stop:\n%s\n", to_text(stack).c_str());
      std::_Exit(1);
    }
  }

  double end_, hard_end_;
  std::stop_source stop_;
  std::jthread thread_;
};

bool same(const TetraMesh& a, const TetraMesh& b) {
  return a.points == b.points && a.tetrahedra == b.tetrahedra && a.labels == b.labels;
}

bool same(const Reconstruction& a, const Reconstruction& b) {
  const auto same_face = [](const InterfaceTriangle& f, const InterfaceTriangle& g) {
    return f.triangle == g.triangle && f.inner == g.inner && f.outer == g.outer;
  };
  const auto same_solid = [](const Solid& s, const Solid& t) {
    return s.structure == t.structure && same(s.tetrahedra, t.tetrahedra) && s.surface.points == t.surface.points &&
           s.surface.triangles == t.surface.triangles;
  };
  const auto &f = a.complex->interfaces, &g = b.complex->interfaces;
  return a.complex->structures == b.complex->structures && same(a.complex->mesh, b.complex->mesh) &&
         std::equal(f.begin(), f.end(), g.begin(), g.end(), same_face) &&
         std::equal(a.solids.begin(), a.solids.end(), b.solids.begin(), b.solids.end(), same_solid);
}

std::vector<std::string> names_in(const ContourStack& stack) {
  std::set<std::string> names;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) names.insert(contour.structure);
  return {names.begin(), names.end()};
}

PartitionOptions options_of(const PartitionCase& given, int threads) {
  PartitionOptions options;
  const std::vector<std::string> there = names_in(given.stack);
  for (const std::string& structure : given.priority)
    if (std::find(there.begin(), there.end(), structure) != there.end()) options.priority.push_back(structure);
  options.gap = given.gap;
  options.between = given.delaunay ? Between::delaunay : Between::blended;
  options.threads = threads;
  return options;
}

void note(const Reconstruction& result, PartitionOutcome& outcome) {
  for (const SlabTopology& slab : result.topology) {
    ++outcome.slabs;
    outcome.not_as_implied += !slab.as_implied();
  }
  outcome.raised = result.counts.raised_slabs;
  outcome.constrained = result.counts.constrained_slices;
  outcome.relabelled = result.partition.relabelled;
  if (result.complex) outcome.tetrahedra = result.complex->mesh.tetrahedra.size();
}

}  // namespace

const char* name(PartitionEnd end) {
  constexpr const char* names[] = {"certified",          "refused", "false refusal", "internal error", "faulty",
                                   "depends on threads", "too slow"};
  return names[int(end)];
}

std::string PartitionOutcome::sort() const {
  std::string letters = name(end);
  letters += ": ";
  for (char c : message) {
    if (c == '\n' || c == ',' || letters.size() > 90) break;
    const char before = letters.back();
    if (std::isalpha(static_cast<unsigned char>(c)) || ((c == ' ' || c == '-') && before != ' ')) letters += c;
  }
  return letters;
}

PartitionOutcome outcome_of(const PartitionCase& given, double timeout, bool twice) {
  PartitionOutcome outcome;
  const double start = processor_seconds();
  const auto ends = [&](PartitionEnd end, const std::string& message) {
    outcome.end = end;
    outcome.message = message;
    if (outcome.seconds == 0) outcome.seconds = processor_seconds() - start;
  };
  try {
    const Timeout watch(timeout, given.stack);
    const PartitionOptions options = options_of(given, 1);
    const Reconstruction result = reconstruct_partition(given.stack, options, {.report = {}, .stop = watch.token()});
    outcome.seconds = processor_seconds() - start;
    note(result, outcome);
    for (const std::string& fault : partition_faults(result, given.stack, {options.priority, options.gap}))
      outcome.message += fault + "\n";
    if (!outcome.message.empty()) {
      outcome.end = PartitionEnd::faulty;
      if (options.gap > 0) outcome.message = "with a gap: " + outcome.message;
    }
    if (outcome.end == PartitionEnd::certified && twice &&
        !same(result, reconstruct_partition(given.stack, options_of(given, 2))))
      ends(PartitionEnd::depends_on_threads, "other bytes with two threads");
  } catch (const InputError& refusal) {
    const std::string wrong = what_is_false(refusal, given.stack, {});
    ends(wrong.empty() ? PartitionEnd::refused : PartitionEnd::false_refusal, wrong.empty() ? refusal.cause() : wrong);
  } catch (const Cancelled&) {
    ends(PartitionEnd::too_slow, "stopped");
  } catch (const std::exception& error) {
    ends(PartitionEnd::internal_error, error.what());
  }
  return outcome;
}

PartitionCase smallest_alike(const PartitionCase& given) {
  const std::string sort = outcome_of(given).sort();
  PartitionCase small = given;
  const auto fails = [&](const ContourStack& candidate) {
    small.stack = candidate;
    return outcome_of(small, 20).sort() == sort;
  };
  small.stack = shrunk(given.stack, fails, std::chrono::seconds(8));
  return small;
}

}  // namespace odontoscope::test
