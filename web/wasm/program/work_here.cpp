// In place of recon/core/work_apart.cpp and posix_processes.cpp: a WebAssembly module can start no process, and is one
// itself. What dies in it ends the run, and nothing else of the page; what never returns is ended with its worker.
// Limits of time and memory are those of the module.
#include <limits>

#include "recon/core/system_processes.h"
#include "recon/core/work_apart.h"

namespace odontoscope {
namespace system {

int own_number() { return 1; }
bool runs(int process) { return process == own_number(); }
void occupy_closed_standard_files() {}
void let_writes_fail() {}
double memory_left_by_limit() { return std::numeric_limits<double>::infinity(); }

}  // namespace system

DoneApart work_apart(const std::function<void(const SendToParent&)>& work, const ApartLimits&,
                     const Progress& progress) {
  progress.check();
  DoneApart done;
  try {
    work([&](const char* bytes, std::size_t count) { done.sent.append(bytes, count); });
    done.whole = true;
  } catch (...) {  // TetGen throws numbers
  }
  return done;
}

}  // namespace odontoscope
