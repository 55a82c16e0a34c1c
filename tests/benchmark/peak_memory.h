#pragma once
// Peak memory of one reconstruction, in a process of its own: a benchmark's own peaks would hide it.

#include <cstddef>
#include <functional>

#include "recon/input/contour_stack.h"

namespace odontoscope {

struct PeakMemory {
  bool measured = false;     // false: the process failed, or the system has no /proc
  std::size_t contours = 0;  // bytes resident with the contours in memory, before reconstruct()
  std::size_t peak = 0;      // most bytes resident until reconstruct() returned
  double seconds = 0;        // of reconstruct()
};

/// Makes the contours and reconstructs them on `threads` threads in a child process. Call it before anything large is
/// in memory.
PeakMemory peak_memory(const std::function<ContourStack()>& make, int threads);

}  // namespace odontoscope
