#include "engine/app/piped_process.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <thread>

#include "engine/picture/other_program.h"
#include "recon/core/error.h"
#include "recon/core/system_processes.h"

namespace odontoscope::app {
namespace {

constexpr int timeout_ms = 50;
constexpr int child_complains = 2, child_reads = 3, child_writes = 4;
constexpr std::size_t longest_message = 1u << 30;  // a picture of the largest size, in base64

}  // namespace

struct PipedProcess::Ends {
  system::Connection to = system::connect(), from = system::connect();
  system::Descriptor said = system::nameless_file();
  system::Process program;
  std::string come;  // of the next message
};

PipedProcess::PipedProcess(const std::vector<std::string>& words) : ends_(std::make_unique<Ends>()) {
  Ends& ends = *ends_;
  const bool ready = ends.to.childs.is_open() && ends.from.childs.is_open() && ends.said.is_open();
  const bool started =
      ready &&
      ends.program.start(
          words, {{&ends.said, child_complains}, {&ends.to.childs, child_reads}, {&ends.from.childs, child_writes}});
  if (!started)
    throw FileError(words.front(), fmt::format("does not start: {}", std::strerror(errno)),
                    "Name the program by its path");
  ends.to.childs.close();
  ends.from.childs.close();
}

PipedProcess::~PipedProcess() = default;

bool PipedProcess::send(std::string_view message) {
  std::string bytes(message);
  bytes.push_back('\0');
  for (std::size_t at = 0; at < bytes.size();) {
    const std::ptrdiff_t count = system::send_within(ends_->to.ours, bytes.data() + at, bytes.size() - at, timeout_ms);
    if (count == system::nothing_yet) continue;
    if (count < 0) return false;
    at += static_cast<std::size_t>(count);
  }
  return true;
}

std::optional<std::string> PipedProcess::next(Clock::time_point deadline, const std::stop_token& stop) {
  std::string& come = ends_->come;
  std::array<char, 1 << 16> piece;
  for (std::size_t looked = 0; !stop.stop_requested();) {
    if (const std::size_t end = come.find('\0', looked); end != come.npos) {
      std::string message = come.substr(0, end);
      come.erase(0, end + 1);
      return message;
    }
    looked = come.size();
    if (Clock::now() >= deadline || looked > longest_message) return std::nullopt;
    const std::ptrdiff_t count = system::read_within(ends_->from.ours, piece.data(), piece.size(), timeout_ms);
    if (count == system::nothing_yet) continue;
    if (count <= 0) return std::nullopt;
    come.append(piece.data(), static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

void PipedProcess::wait(Clock::time_point deadline) {
  while (ends_->program.runs() && Clock::now() < deadline && !ends_->program.ended())
    std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms / 5));
}

std::string PipedProcess::complaint() const { return last_line(system::all_bytes(ends_->said)); }

OwnFolder::OwnFolder() {
  const auto made = system::new_folder();
  if (!made)
    throw FileError(std::filesystem::temp_directory_path().string(), std::strerror(errno),
                    "Let TMPDIR name a folder that can be written to");
  path_ = made->string();
}

OwnFolder::~OwnFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

}  // namespace odontoscope::app
