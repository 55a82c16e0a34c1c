#pragma once
// Words for the person at the terminal, or for whoever reads the log later.

#include <chrono>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace odontoscope::app {

/// Results go to standard output. Progress goes to standard error: a bar that redraws itself on a terminal, otherwise
/// one line a stage and a sign of life now and then. Quiet: neither. Safe to call from several threads. Whoever has no
/// terminal (the Python package) takes complaints otherwise.
class Console {
 public:
  Console();
  virtual ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void be_quiet() { quiet_ = true; }

  /// One line of result.
  void say(std::string_view line);
  void progress(std::string_view stage, double fraction);
  /// Errors are said however quiet: "odontoscope: MESSAGE" on standard error.
  virtual void complain(std::string_view message);
  /// Takes the bar away and makes sure that all that was said has left; throws FileError if standard output took it
  /// not, unless files were written meanwhile (`wrote`): what happened to them is told by the exit code, and on
  /// standard error what was lost.
  void finish(bool wrote = false);

 private:
  using Clock = std::chrono::steady_clock;
  void draw_bar(std::string_view stage, double fraction);
  void erase_bar();

  std::mutex mutex_;
  bool quiet_ = false;
  bool terminal_ = false;
  bool bar_shown_ = false;
  std::string stage_;
  std::set<std::string, std::less<>> stages_told_;
  Clock::time_point last_told_;
};

}  // namespace odontoscope::app
