#include "engine/app/piped_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "engine/picture/other_program.h"
#include "recon/core/error.h"

namespace odontoscope::app {
namespace {

constexpr int patience_ms = 50;
constexpr int child_reads = 3, child_writes = 4;
constexpr std::size_t longest_message = 1u << 30;  // a picture of the largest size, in base64

}  // namespace

struct PipedProcess::Ends {
  OtherProgram program;
  Connection to, from;
  Descriptor said{nameless_file()};
  std::string come;  // of the next message
};

PipedProcess::PipedProcess(const std::vector<std::string>& words) : ends_(std::make_unique<Ends>()) {
  Ends& ends = *ends_;
  const bool ready = ends.to.childs.number() >= 0 && ends.from.childs.number() >= 0 && ends.said.number() >= 0;
  const int error = ready ? ends.program.start(words, {{ends.said.number(), STDERR_FILENO},
                                                       {ends.to.childs.number(), child_reads},
                                                       {ends.from.childs.number(), child_writes}})
                          : errno;
  ends.to.childs.close();
  ends.from.childs.close();
  if (error != 0 || !ready)
    throw FileError(words.front(), fmt::format("does not start: {}", std::strerror(error)),
                    "Name the program by its path");
}

PipedProcess::~PipedProcess() = default;

bool PipedProcess::send(std::string_view message) {
  std::string bytes(message);
  bytes.push_back('\0');
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t count = ::send(ends_->to.ours.number(), bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
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
    pollfd watched{ends_->from.ours.number(), POLLIN, 0};
    if (::poll(&watched, 1, patience_ms) <= 0) continue;
    const ssize_t count = ::read(ends_->from.ours.number(), piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    come.append(piece.data(), static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

void PipedProcess::wait(Clock::time_point deadline) {
  int status = 0;
  while (ends_->program.runs() && Clock::now() < deadline && !ends_->program.ended(status))
    std::this_thread::sleep_for(std::chrono::milliseconds(patience_ms / 5));
}

std::string PipedProcess::complaint() const { return last_line(all_bytes(ends_->said.number())); }

OwnFolder::OwnFolder() : path_((std::filesystem::temp_directory_path() / "odontoscope-XXXXXX").string()) {
  if (::mkdtemp(path_.data()) == nullptr)
    throw FileError(path_, std::strerror(errno), "Let TMPDIR name a folder that can be written to");
}

OwnFolder::~OwnFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

bool is_root() { return ::geteuid() == 0; }

}  // namespace odontoscope::app
