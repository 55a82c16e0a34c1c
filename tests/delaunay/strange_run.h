#pragma once
// One strange stack reconstructed and judged.

#include <optional>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "tests/support/shrink.h"
#include "tests/support/strange_stacks.h"

namespace odontoscope::test {

enum class StrangeEnd { certified, refused, false_refusal, internal_error, faulty, depends_on_threads, too_slow };
const char* name(StrangeEnd end);

/// How a stack is reconstructed.
struct StrangeWay {
  Correspondence criterion = Correspondence::medial;
  Between between = Between::delaunay;
};
std::string in_words(const StrangeWay& way);

struct StrangeOutcome {
  StrangeEnd end = StrangeEnd::certified;
  std::string message;  // empty if certified; the cause if refused
  double seconds = 0;   // processor time of the first run, with one thread
  /// Slabs with other topology than the links imply: no failure, since plain Delaunay does not promise it, but counted.
  std::vector<std::string> not_as_implied;
  bool failed() const { return end != StrangeEnd::certified && end != StrangeEnd::refused; }
  /// The same for failures of one sort, whatever numbers their messages hold.
  std::string sort() const;
};

/// Reconstructs with one thread and with two, compares the bytes, and asks the oracle, or, if refused, whether that is
/// true. Stopped (too_slow) after `timeout` seconds of processor time. Unless `judged`, it is only timed: neither the
/// oracle nor two threads are asked.
StrangeOutcome outcome_of(const LinkedStack& linked, const StrangeWay& way, double timeout = 60, bool judged = true);

/// By the seed: every criterion with and without interpolated slices, most often `tracked`, the default.
StrangeWay way_of(std::uint64_t seed);

/// A smallest stack with the same sort of outcome.
LinkedStack smallest_alike(const LinkedStack& linked, const StrangeWay& way);

}  // namespace odontoscope::test
