#pragma once
// Runs something in a process of its own that may take only so much memory and processor time.

#include <cstddef>
#include <functional>
#include <string>

namespace odontoscope::hostile {

struct Bounds {
  /// Beyond what the process holds at the start. Not enforced under the address sanitizer, which reserves terabytes.
  std::size_t megabytes = 512;
  /// Of the processor, so that a busy machine changes nothing.
  unsigned seconds = 10;
};

/// What became of it: "accepted", the cause of an InputError, "cannot be read" (FileError), "out of memory", "out of
/// time", or what else it threw or was ended by.
std::string outcome_within(const Bounds& bounds, const std::function<void()>& action);

}  // namespace odontoscope::hostile
