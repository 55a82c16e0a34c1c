#include "engine/app/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "recon/core/error.h"
#include "recon/core/system_processes.h"

namespace odontoscope::app {
namespace {

constexpr auto bar_interval = std::chrono::milliseconds(100);
constexpr auto log_interval = std::chrono::seconds(10);
constexpr int widest_bar = 40;
constexpr int narrowest_bar = 8;
constexpr int words_beside_bar = 30;

/// Where nobody takes it, it is lost: what cannot be said must not end the work. For standard output finish() tells.
void put(std::FILE* to, std::string_view text) { std::fwrite(text.data(), 1, text.size(), to); }

bool stderr_is_terminal() {
  const char* kind = std::getenv("TERM");
  return system::errors_go_to_terminal() && kind != nullptr && std::string_view(kind) != "dumb";
}

}  // namespace

Console::Console() : terminal_(stderr_is_terminal()) {}

Console::~Console() { erase_bar(); }

void Console::say(std::string_view line) {
  const std::lock_guard lock(mutex_);
  if (quiet_) return;
  erase_bar();
  put(stdout, fmt::format("{}\n", line));
}

void Console::complain(std::string_view message) {
  const std::lock_guard lock(mutex_);
  erase_bar();
  put(stderr, fmt::format("odontoscope: {}\n", message));
}

void Console::progress(std::string_view stage, double fraction) {
  const std::lock_guard lock(mutex_);
  if (quiet_) return;
  const auto now = Clock::now();
  if (terminal_) {
    if (bar_shown_ && now - last_told_ < bar_interval) return;
    last_told_ = now;
    draw_bar(stage, std::clamp(fraction, 0.0, 1.0));
    return;
  }
  const bool news = stages_told_.emplace(stage).second;
  if (!news && now - last_told_ < log_interval) return;
  last_told_ = now;
  if (news)
    put(stderr, fmt::format("{}\n", stage));
  else
    put(stderr, fmt::format("{}: {:.0f} %\n", stage, 100 * std::clamp(fraction, 0.0, 1.0)));
}

void Console::draw_bar(std::string_view stage, double fraction) {
  constexpr int customary_columns = 80;
  const int columns = system::terminal_columns().value_or(customary_columns);
  const int cells = std::clamp(columns - words_beside_bar, narrowest_bar, widest_bar);
  const int full = static_cast<int>(fraction * cells);
  put(stderr, fmt::format("\r\033[K[{:#<{}}{:.<{}}] {:3.0f} % {}", "", full, "", cells - full, 100 * fraction, stage));
  std::fflush(stderr);
  bar_shown_ = true;
}

void Console::erase_bar() {
  if (!bar_shown_) return;
  put(stderr, "\r\033[K");
  std::fflush(stderr);
  bar_shown_ = false;
}

void Console::finish(bool wrote) {
  const std::lock_guard lock(mutex_);
  erase_bar();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    if (wrote)
      return put(stderr, "odontoscope: standard output did not take all that was to be said; the files are written.\n");
    throw FileError("standard output", "did not take what was to be said", "Is the disk full?");
  }
}

}  // namespace odontoscope::app
