#include "recon/core/work_apart.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <new>

#include "recon/core/error.h"
#include "recon/core/sanitized.h"
#include "recon/core/system_processes.h"

namespace odontoscope {
namespace {

constexpr bool memory_is_bounded = !address_sanitized && !thread_sanitized;

/// Reads until the child shuts its end or says nothing for too long. True: it shut its end.
bool listen(const system::Descriptor& child, unsigned silent_seconds, std::string& sent, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  constexpr int look_every = 100;  // milliseconds
  std::array<char, 1 << 16> piece;
  for (auto last = Clock::now();;) {
    progress.check();
    const std::ptrdiff_t got = system::read_within(child, piece.data(), piece.size(), look_every);
    if (got == 0) return true;
    if (got == -1) return false;
    if (got > 0) {
      sent.append(piece.data(), static_cast<std::size_t>(got));
      last = Clock::now();
    }
    if (Clock::now() - last > std::chrono::seconds(silent_seconds)) return false;
  }
}

}  // namespace

DoneApart work_apart(const std::function<void(const SendToParent&)>& work, const ApartLimits& limits,
                     const Progress& progress) {
  system::Connection connection = system::connect();
  if (!connection.childs.is_open()) throw std::bad_alloc();
  const auto send = [&connection](const char* bytes, std::size_t count) {
    if (!system::write(connection.childs, {bytes, count})) system::end_at_once(1);
  };
  system::Process child;
  const bool started = child.start_work([&] { work(send); }, {.bytes = memory_is_bounded ? limits.bytes : 0,
                                                              .processor_seconds = limits.processor_seconds});
  if (!started)
    throw FileError("", fmt::format("no process can be started ({})", std::strerror(errno)), "End other programs");
  connection.childs.close();
  DoneApart done;
  done.whole = listen(connection.ours, limits.silent_seconds, done.sent, progress) && child.wait().exit_code == 0;
  return done;
}

}  // namespace odontoscope
