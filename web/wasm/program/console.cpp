// In place of engine/app/console.cpp: progress goes to JavaScript as numbers, every time; words go where the module's
// print functions take them. JavaScript is on the first thread alone: what others have done is told with what it does
// itself.
#include "engine/app/console.h"

#include <emscripten.h>
#include <emscripten/threading.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

// clang-format off
EM_JS(void, odontoscope_tell_progress, (const char* stage, double fraction), {
  if (Module.onProgress) Module.onProgress(UTF8ToString(stage), fraction);
});
// clang-format on

namespace odontoscope::app {

Console::Console() = default;
Console::~Console() = default;

void Console::say(std::string_view line) {
  if (!quiet_) std::fputs(fmt::format("{}\n", line).c_str(), stdout);
}

void Console::complain(std::string_view message) {
  std::fputs(fmt::format("odontoscope: {}\n", message).c_str(), stderr);
}

void Console::progress(std::string_view stage, double fraction) {
  constexpr auto interval = std::chrono::milliseconds(40);
  if (emscripten_is_main_runtime_thread() == 0) return;
  const auto now = Clock::now();
  if (quiet_ || (stage_ == stage && now - last_told_ < interval)) return;
  stage_ = stage;
  last_told_ = now;
  odontoscope_tell_progress(stage_.c_str(), std::clamp(fraction, 0.0, 1.0));
}

void Console::draw_bar(std::string_view, double) {}
void Console::erase_bar() {}
void Console::finish(bool) { std::fflush(stdout); }

}  // namespace odontoscope::app
