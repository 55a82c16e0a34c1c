#pragma once
// Work in a child process, so that nothing that other people's code does with hostile or awkward data can end this
// program: assert, abort, overrun, never return, or take all memory.
//
// The child is a fork without a new program, so that every program which links this library has it (tests and viewers
// too) and no second executable must be found. Of a process with threads a fork keeps the calling one alone; glibc
// makes malloc and stdio usable in the child, which may use nothing else of this process: no lock of ours, no TBB; no
// destructor of the parent's runs there, since it leaves by _exit. What it prints goes nowhere. It ends with its
// parent.

#include <cstddef>
#include <functional>
#include <string>

#include "recon/core/progress.h"

namespace odontoscope {

struct ApartLimits {
  unsigned processor_seconds = 60;
  unsigned silent_seconds = 300;  // by the clock, without sending anything
  std::size_t bytes = 1u << 30;   // of memory, beyond what it began with; not bounded under sanitizers
};

struct DoneApart {
  std::string sent;    // all that came before the end
  bool whole = false;  // the child returned from its work
};

/// Hands bytes to the parent. May be called as often as one likes.
using SendToParent = std::function<void(const char* bytes, std::size_t count)>;

/// Runs `work` in a child and waits for it. What it throws, or dies of, shows as not whole. Throws Cancelled (and ends
/// the child); FileError if no process can be started.
DoneApart work_apart(const std::function<void(const SendToParent&)>& work, const ApartLimits& limits,
                     const Progress& progress);

}  // namespace odontoscope
