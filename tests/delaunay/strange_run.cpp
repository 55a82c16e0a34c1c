#include "tests/delaunay/strange_run.h"

#include <atomic>
#include <cctype>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <thread>

#include "tests/delaunay/engine_checks.h"
#include "tests/support/oracle_topology.h"
#include "tests/support/refusal_check.h"
#include "tests/support/stack_text.h"

namespace odontoscope::test {
namespace {

/// Triangles of a surface that are judged for meeting each other: more take seconds.
constexpr std::size_t judged_triangles = 4000;

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// Asks for a stop once the processor time is up; a run that does not heed it for twice as long ends the program,
/// saying for which stack.
class Timeout {
 public:
  Timeout(double seconds, const LinkedStack& linked)
      : end_(processor_seconds() + seconds),
        hard_end_(end_ + 2 * seconds),
        thread_([this, &linked](std::stop_token done) { watch(done, linked); }) {}
  std::stop_token token() const { return stop_.get_token(); }

 private:
  void watch(std::stop_token done, const LinkedStack& linked) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, done, std::chrono::milliseconds(500), [&] { return done.stop_requested(); }) &&
           !done.stop_requested()) {
      if (processor_seconds() > end_) stop_.request_stop();
      if (processor_seconds() < hard_end_) continue;
      std::fprintf(stderr, "hangs, and heeds no stop:\n%s\n%s\n", to_text(linked.stack).c_str(),
                   to_text(linked.links).c_str());
      std::_Exit(1);
    }
  }

  double end_, hard_end_;
  std::stop_source stop_;
  std::jthread thread_;
};

std::size_t largest_surface(const Reconstruction& result) {
  std::size_t largest = 0;
  for (const Solid& solid : result.solids) largest = std::max(largest, solid.surface.triangles.size());
  return largest;
}

void judge_result(const Reconstruction& result, const LinkedStack& linked, ReconstructOptions options,
                  StrangeOutcome& outcome) {
  options.threads = 2;
  if (const std::string what = difference(result, reconstruct(linked.stack, options)); !what.empty()) {
    outcome.end = StrangeEnd::depends_on_threads;
    outcome.message = what;
    return;
  }
  for (const std::string& fault :
       faults_of(result, linked.stack, {.self_intersections = largest_surface(result) < judged_triangles}))
    outcome.message += fault + "\n";
  if (!outcome.message.empty())
    outcome.end = StrangeEnd::faulty;
  else
    outcome.not_as_implied = judge_topology(result, linked.stack).not_as_implied;
}

}  // namespace

const char* name(StrangeEnd end) {
  constexpr const char* names[] = {"certified",          "refused", "false refusal", "internal error", "faulty",
                                   "depends on threads", "too slow"};
  return names[int(end)];
}

std::string StrangeOutcome::sort() const {
  std::string letters = name(end);
  letters += ": ";
  for (char c : message) {
    if (c == '\n' || letters.size() > 90) break;
    const char before = letters.back();
    if (std::isalpha(static_cast<unsigned char>(c)) || (c == ' ' && before != ' ') || (c == '-' && before != ' '))
      letters += c;
  }
  return letters;
}

std::string in_words(const StrangeWay& way) {
  return std::string(odontoscope::name(way.criterion)) + (way.between == Between::blended ? " blended" : "");
}

StrangeWay way_of(std::uint64_t seed) {
  constexpr StrangeWay ways[] = {
      {Correspondence::tracked, Between::blended},  {Correspondence::tracked, Between::delaunay},
      {Correspondence::medial, Between::delaunay},  {Correspondence::overlap, Between::blended},
      {Correspondence::tracked, Between::blended},  {Correspondence::overlap, Between::delaunay},
      {Correspondence::tracked, Between::delaunay}, {Correspondence::reverse, Between::blended},
      {Correspondence::reverse, Between::delaunay}, {Correspondence::medial, Between::blended}};
  return ways[seed / strange_kinds().size() % std::size(ways)];
}

StrangeOutcome outcome_of(const LinkedStack& linked, const StrangeWay& way, double timeout, bool judged) {
  StrangeOutcome outcome;
  const ReconstructOptions options{
      .correspondence = way.criterion, .between = way.between, .links = linked.links, .threads = 1};
  const double start = processor_seconds();
  const auto ends = [&](StrangeEnd end, const std::string& message) {
    outcome.end = end;
    outcome.message = message;
    if (outcome.seconds == 0) outcome.seconds = processor_seconds() - start;
  };
  try {
    const Timeout watch(timeout, linked);
    const Reconstruction result = reconstruct(linked.stack, options, {.report = {}, .stop = watch.token()});
    outcome.seconds = processor_seconds() - start;
    if (judged) judge_result(result, linked, options, outcome);
  } catch (const InputError& refusal) {
    const std::string wrong = what_is_false(refusal, linked.stack, linked.links);
    ends(wrong.empty() ? StrangeEnd::refused : StrangeEnd::false_refusal, wrong.empty() ? refusal.cause() : wrong);
  } catch (const Cancelled&) {
    ends(StrangeEnd::too_slow, "stopped");
  } catch (const std::exception& error) {
    ends(StrangeEnd::internal_error, error.what());
  }
  return outcome;
}

LinkedStack smallest_alike(const LinkedStack& linked, const StrangeWay& way) {
  const std::string sort = outcome_of(linked, way).sort();
  return shrunk(linked, [&](const LinkedStack& candidate) { return outcome_of(candidate, way, 20).sort() == sort; });
}

}  // namespace odontoscope::test
