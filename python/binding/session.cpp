#include "python/binding/session.h"

namespace odontoscope::python {

void KeptConsole::complain(std::string_view message) {
  constexpr std::string_view mark = "warning: ";
  if (message.starts_with(mark)) message.remove_prefix(mark.size());
  complaints_.emplace_back(message);
}

app::Session& QuietSession::watched_by(const Progress& progress) {
  session_.watched = progress;
  return session_;
}

void QuietSession::warn() const {
  constexpr Py_ssize_t caller_of_the_package = 3;
  for (const std::string& complaint : console_.complaints())
    if (PyErr_WarnEx(PyExc_UserWarning, complaint.c_str(), caller_of_the_package) != 0)
      throw pybind11::error_already_set();
}

}  // namespace odontoscope::python

// In place of engine/app/interrupt.cpp: signals are Python's, which looks for them in run_watched.
namespace odontoscope::app {

Interrupts::Interrupts() = default;
Interrupts::~Interrupts() = default;
void Interrupts::listen() {}

}  // namespace odontoscope::app
