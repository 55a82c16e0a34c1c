#pragma once
// Ctrl-C, and the signals by which a system asks a program to end, as a stop request that long work notices.

#include <atomic>
#include <mutex>
#include <stop_token>
#include <thread>

namespace odontoscope::app {

/// While one lives, SIGINT, SIGTERM and SIGHUP request a stop; the work then throws Cancelled and nothing is written. A
/// second one ends the program at once, but not in the middle of writing files. Make it before any thread is started:
/// threads inherit from the one that starts them that the signals are not theirs. A signal that was ignored when the
/// program started (nohup, background jobs) stays ignored.
class Interrupts {
 public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  /// Files were written: told by whoever did it, asked when something that comes after fails.
  void note_written() { written_ = true; }
  bool has_written() const { return written_; }
  /// While the lock is held even a second signal waits.
  [[nodiscard]] std::unique_lock<std::mutex> hold() { return std::unique_lock(writing_); }

 private:
  void listen();

  std::stop_source stop_;
  std::mutex writing_;
  std::atomic<bool> over_ = false, written_ = false;
  std::thread listener_;
};

/// What a shell reports for a program that Ctrl-C ended.
inline constexpr int interrupted_exit_code = 130;

}  // namespace odontoscope::app
