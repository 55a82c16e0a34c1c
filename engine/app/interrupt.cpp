#include "engine/app/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>

namespace odontoscope::app {
namespace {

/// Those of our signals that were not ignored when the program started.
sigset_t heeded_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  return signals;
}

}  // namespace

Interrupts::Interrupts() {
  const sigset_t signals = heeded_signals();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  listener_ = std::thread([this] { listen(); });
}

Interrupts::~Interrupts() {
  over_ = true;
  ::pthread_kill(listener_.native_handle(), SIGTERM);   // wakes the listener alone
  listener_.join();
}

void Interrupts::listen() {
  sigset_t signals = heeded_signals();
  sigaddset(&signals, SIGTERM);   // also where it is ignored: it is what the destructor wakes us with
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  while (true) {
    int signal = 0;
    if (::sigwait(&signals, &signal) != 0) continue;
    if (over_) return;
    if (stop_.stop_requested()) {
      const auto lock = hold();
      ::_exit(interrupted_exit_code);
    }
    constexpr std::string_view words = "\nodontoscope: stopping, nothing will be written (once more to end at once)\n";
    std::fwrite(words.data(), 1, words.size(), stderr);
    stop_.request_stop();
  }
}

}  // namespace odontoscope::app
