#pragma once
// One stack made into a partition, and judged.

#include <string>

#include "tests/partition/partition_stacks.h"

namespace odontoscope::test {

enum class PartitionEnd { certified, refused, false_refusal, internal_error, faulty, depends_on_threads, too_slow };
const char* name(PartitionEnd end);

struct PartitionOutcome {
  PartitionEnd end = PartitionEnd::certified;
  std::string message;  // empty if certified; the cause if refused
  double seconds = 0;   // processor time of the first run, on one thread
  std::size_t not_as_implied = 0, slabs = 0, raised = 0, constrained = 0, relabelled = 0, tetrahedra = 0;
  bool failed() const { return end != PartitionEnd::certified && end != PartitionEnd::refused; }
  /// The same for failures of one sort, whatever numbers their messages hold.
  std::string sort() const;
};

/// With one thread, and, if `twice`, with two, whose bytes must be the same. Stopped (too_slow) after `timeout`
/// seconds.
PartitionOutcome outcome_of(const PartitionCase& given, double timeout = 60, bool twice = true);

/// A smallest stack with the same sort of outcome.
PartitionCase smallest_alike(const PartitionCase& given);

}  // namespace odontoscope::test
