// In place of recon/core/work_apart.cpp: a WebAssembly module can start no process, and is one itself. What dies in it ends the run, and nothing else of the page;
// what never returns is ended with its worker. Limits of time and memory are those of the module.
#include "recon/core/work_apart.h"

namespace odontoscope {

DoneApart work_apart(const std::function<void(const SendToParent&)>& work, const ApartLimits&, const Progress& progress) {
  progress.check();
  DoneApart done;
  try {
    work([&](const char* bytes, std::size_t count) { done.sent.append(bytes, count); });
    done.whole = true;
  } catch (...) {   // TetGen throws numbers
  }
  return done;
}

}  // namespace odontoscope
