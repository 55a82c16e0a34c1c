#pragma once
// This program once more, as a process of its own that may take only so much memory and time: whatever becomes of it is
// told.

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

namespace odontoscope::app {

struct ChildBounds {
  double seconds = 60;           // by the clock
  std::size_t megabytes = 4096;  // of address space
};

struct ChildEnding {
  int exit_code = -1;  // -1 if it did not exit by itself
  int signal = 0;      // that ended it
  bool late = false;   // it was ended for taking too long
  std::string err;     // the last of what it said on standard error
  double seconds = 0;
  double megabytes = 0;  // at its peak, resident

  /// "3", "signal 6", "hang".
  std::string in_words() const;
  /// A signal, too long, a bug of ours (70), or an abort told as an exit code by a shell (134).
  bool is_bad() const;
};

/// Runs this very program with `arguments`; it sees no input, and what it says on standard output is dropped. Safe to
/// call from several threads. Throws Cancelled once a stop was requested (the child is ended), FileError if no process
/// can be started.
ChildEnding run_again(const std::vector<std::string>& arguments, const ChildBounds& bounds,
                      const std::stop_token& stop);

}  // namespace odontoscope::app
