#include "engine/app/child_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "recon/core/error.h"

namespace odontoscope::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* this_program = "/proc/self/exe";

/// Between fork and exec of a process with threads: system calls alone.
[[noreturn]] void become(char* const* argv, int err, const ChildBounds& bounds) {
  ::setpgid(0, 0);   // so that its own children end with it
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_DFL);
  const rlim_t bytes = static_cast<rlim_t>(bounds.megabytes) << 20;
  const rlimit memory{bytes, bytes}, no_core{0, 0};
  ::setrlimit(RLIMIT_AS, &memory);
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = ::open("/dev/null", O_RDWR);
  if (::dup2(nothing, STDIN_FILENO) >= 0 && ::dup2(nothing, STDOUT_FILENO) >= 0 && ::dup2(err, STDERR_FILENO) >= 0) ::execv(this_program, argv);
  ::_exit(127);
}

/// Keeps the end of what comes; false when no more will.
bool take(int descriptor, std::string& text) {
  std::array<char, 4096> buffer;
  const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
  if (count < 0 && errno == EINTR) return true;
  if (count <= 0) return false;
  constexpr std::size_t kept = 16384;
  text.append(buffer.data(), static_cast<std::size_t>(count));
  if (text.size() > 2 * kept) text.erase(0, text.size() - kept);
  return true;
}

/// What it says, until it ends, the time is over, or the work is stopped. True if it had its time.
bool listen(int descriptor, Clock::time_point deadline, const std::stop_token& stop, std::string& text) {
  constexpr int patience_ms = 50;
  while (!stop.stop_requested() && Clock::now() < deadline) {
    pollfd watched{descriptor, POLLIN, 0};
    if (::poll(&watched, 1, patience_ms) > 0 && !take(descriptor, text)) return true;
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
  return late || signal != 0 || exit_code == static_cast<int>(ExitCode::internal) || exit_code == aborted || exit_code == no_program;
}

ChildEnding run_again(const std::vector<std::string>& arguments, const ChildBounds& bounds, const std::stop_token& stop) {
  std::vector<std::string> words{"odontoscope"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw FileError("a pipe", std::strerror(errno), "Try again with less at work");
  const auto start = Clock::now();
  const pid_t child = ::fork();
  if (child == 0) become(argv.data(), ends[1], bounds);
  ::close(ends[1]);
  ChildEnding ending;
  bool in_time = false;
  if (child > 0) {
    ::setpgid(child, child);
    in_time = listen(ends[0], start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(bounds.seconds)), stop, ending.err);
  }
  ::close(ends[0]);
  if (child < 0) throw FileError("a process", "cannot be started", "Try again with less at work");
  if (!in_time) ::kill(-child, SIGKILL);
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  if (stop.stop_requested()) throw Cancelled{};
  ending.late = !in_time;
  if (WIFEXITED(status)) ending.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  ending.seconds = seconds_since(start);
  ending.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  return ending;
}

}  // namespace odontoscope::app
