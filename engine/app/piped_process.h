#pragma once
// Another program that is spoken to in messages through two pipes, as browsers are with --remote-debugging-pipe: it
// reads from descriptor 3 and writes to 4.

#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope::app {

class PipedProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// `words`: the program, looked for in PATH unless it has a slash, and its arguments. Throws FileError, naming the
  /// program, if it does not start.
  explicit PipedProcess(const std::vector<std::string>& words);
  /// Ends it, and what it started.
  ~PipedProcess();

  /// False if nobody reads any more.
  bool send(std::string_view message);
  /// The next message; none once the time is over, the process has closed its end, or a stop is requested.
  std::optional<std::string> next(Clock::time_point deadline, const std::stop_token& stop);
  /// Waits so long for it to end by itself.
  void wait(Clock::time_point deadline);
  /// The last line that it said on standard error.
  std::string complaint() const;

 private:
  struct Ends;
  std::unique_ptr<Ends> ends_;
};

/// A folder of this process' own, which goes with its owner.
class OwnFolder {
 public:
  /// Throws FileError.
  OwnFolder();
  ~OwnFolder();
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace odontoscope::app
