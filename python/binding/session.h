#pragma once
// What the program's own code is given when it works for Python: nobody at a terminal, and Python's progress.

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "engine/app/command.h"

namespace odontoscope::python {

/// Says nothing; keeps what it would complain of.
class KeptConsole : public app::Console {
 public:
  KeptConsole() { be_quiet(); }
  void complain(std::string_view message) override;
  const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  std::vector<std::string> complaints_;  // by the one thread that works
};

class QuietSession {
 public:
  explicit QuietSession(int threads = 0) { session_.threads = threads; }

  /// For work that `progress` watches and stops.
  app::Session& watched_by(const Progress& progress);
  /// Complaints become warnings of Python, which may be told to raise them. With the interpreter's lock.
  void warn() const;

 private:
  KeptConsole console_;
  app::Interrupts interrupts_;
  app::Session session_{console_, interrupts_};
};

}  // namespace odontoscope::python
