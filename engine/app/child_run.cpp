#include "engine/app/child_run.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "recon/core/error.h"
#include "recon/core/progress.h"
#include "recon/core/system_processes.h"

namespace odontoscope::app {
namespace {

using Clock = std::chrono::steady_clock;

/// What it says, the end of it kept, until it ends, the time is over, or the work is stopped. True if it had its time.
bool listen(const system::Descriptor& child, Clock::time_point deadline, const std::stop_token& stop,
            std::string& text) {
  constexpr int timeout_ms = 50;
  constexpr std::size_t kept = 16384;
  std::array<char, 4096> piece;
  while (!stop.stop_requested() && Clock::now() < deadline) {
    const std::ptrdiff_t got = system::read_within(child, piece.data(), piece.size(), timeout_ms);
    if (got == 0 || got == -1) return true;
    if (got > 0) text.append(piece.data(), static_cast<std::size_t>(got));
    if (text.size() > 2 * kept) text.erase(0, text.size() - kept);
  }
  return false;
}

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

std::string ChildEnding::in_words() const {
  if (late) return "hang";
  return signal != 0 ? fmt::format("signal {}", signal) : std::to_string(exit_code);
}

bool ChildEnding::is_bad() const {
  constexpr int aborted = 128 + SIGABRT, no_program = 127;
  return late || signal != 0 || exit_code == static_cast<int>(ExitCode::internal) || exit_code == aborted ||
         exit_code == no_program;
}

ChildEnding run_again(const std::vector<std::string>& arguments, const ChildBounds& bounds,
                      const std::stop_token& stop) {
  system::Connection connection = system::connect();
  if (!connection.childs.is_open())
    throw FileError("a connection", std::strerror(errno), "Try again with less at work");
  const auto start = Clock::now();
  const auto deadline =
      start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(bounds.seconds));
  system::Process child;
  if (!child.start_this_program(arguments, connection.childs, {.bytes = bounds.megabytes << 20}))
    throw FileError("a process", "cannot be started", "Try again with less at work");
  connection.childs.close();
  ChildEnding ending;
  ending.late = !listen(connection.ours, deadline, stop, ending.err);
  if (ending.late) child.kill();
  const system::Ending ended = child.wait();
  if (stop.stop_requested()) throw Cancelled{};
  constexpr double megabyte = 1 << 20;
  ending.exit_code = ended.exit_code;
  ending.signal = ended.signal;
  ending.seconds = seconds_since(start);
  ending.megabytes = ended.peak_bytes / megabyte;
  return ending;
}

}  // namespace odontoscope::app
