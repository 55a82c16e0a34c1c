#include "engine/app/interrupt.h"

#include <cstdio>
#include <string_view>

#include "recon/core/system_processes.h"

namespace odontoscope::app {

Interrupts::Interrupts() {
  system::hold_requests_to_end();
  listener_ = std::thread([this] { listen(); });
}

Interrupts::~Interrupts() {
  over_ = true;
  system::wake(listener_);
  listener_.join();
}

void Interrupts::listen() {
  while (true) {
    system::wait_to_be_asked_to_end();
    if (over_) return;
    if (stop_.stop_requested()) {
      const auto lock = hold();
      system::end_at_once(interrupted_exit_code);
    }
    constexpr std::string_view words = "\nodontoscope: stopping, nothing will be written (once more to end at once)\n";
    std::fwrite(words.data(), 1, words.size(), stderr);
    stop_.request_stop();
  }
}

}  // namespace odontoscope::app
