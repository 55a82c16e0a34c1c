#pragma once
// Long work on behalf of a Python call: without the interpreter's lock, watched by a listener, ended by Ctrl-C.

#include <pybind11/pybind11.h>

#include <functional>

#include "recon/core/progress.h"

namespace odontoscope::python {

namespace py = pybind11;

/// Runs `work` on a thread of its own while the calling one waits with the interpreter's lock released. The calling
/// thread hands news to `listener(stage, fraction)` (None: nobody listens) and looks for signals twenty times a second;
/// should either raise, the work is cancelled and what was raised goes on. What `work` throws is thrown again. The lock
/// is held on entry and on return.
void run_watched(const py::object& listener, const std::function<void(const Progress&)>& work);

/// The same for work that has a result.
template <class Work>
auto watched(const py::object& listener, Work work) {
  decltype(work(Progress{})) result{};
  run_watched(listener, [&](const Progress& progress) { result = work(progress); });
  return result;
}

}  // namespace odontoscope::python
