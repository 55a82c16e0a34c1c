#include "engine/app/piped_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "recon/core/error.h"

extern char** environ;

namespace odontoscope::app {
namespace {

constexpr int patience_ms = 50;
constexpr int beyond_the_childs = 16;  // descriptors here, so that none is one that the child gets its own under
constexpr int child_reads = 3, child_writes = 4;
constexpr std::size_t longest_message = 1u << 30;  // a picture of the largest size, in base64

void close_end(int& end) {
  if (end >= 0) ::close(end);
  end = -1;
}

int moved_up(int opened) {
  if (opened < 0) return -1;
  const int moved = ::fcntl(opened, F_DUPFD_CLOEXEC, beyond_the_childs);
  ::close(opened);
  return moved;
}

/// Both ends of a connection, ours first. A socket, since nobody at its other end is an error there, and no signal.
std::array<int, 2> connection() {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return {-1, -1};
  return {moved_up(ends[0]), moved_up(ends[1])};
}

int nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "odontoscope-said-XXXXXX").string();
  const int opened = ::mkostemp(name.data(), O_CLOEXEC);
  if (opened >= 0) ::unlink(name.c_str());
  return moved_up(opened);
}

}  // namespace

struct PipedProcess::Ends {
  pid_t child = -1;
  int to = -1, from = -1, said = -1;
  std::string come;  // of the next message

  ~Ends() {
    if (child > 0) {
      ::kill(-child, SIGKILL);
      while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
    for (int* end : {&to, &from, &said}) close_end(*end);
  }

  /// The error's number, or 0.
  int spawn(std::vector<std::string> words, int reads, int writes) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, said, STDERR_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, reads, child_reads);
    ::posix_spawn_file_actions_adddup2(&files, writes, child_writes);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setpgroup(&attributes, 0);  // so that Ctrl-C is ours alone, and what it starts ends with it
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    const int error = ::posix_spawnp(&child, argv.front(), &files, &attributes, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    if (error != 0) child = -1;
    return error;
  }
};

PipedProcess::PipedProcess(const std::vector<std::string>& words) : ends_(std::make_unique<Ends>()) {
  std::array<int, 2> there = connection(), back = connection();
  ends_->to = there[0];
  ends_->from = back[0];
  ends_->said = nameless_file();
  const bool ready = there[1] >= 0 && back[1] >= 0 && ends_->said >= 0;
  const int error = ready ? ends_->spawn(words, there[1], back[1]) : errno;
  close_end(there[1]);
  close_end(back[1]);
  if (error != 0 || !ready)
    throw FileError(words.front(), fmt::format("does not start: {}", std::strerror(error)),
                    "Name the program by its path");
}

PipedProcess::~PipedProcess() = default;

bool PipedProcess::send(std::string_view message) {
  std::string bytes(message);
  bytes.push_back('\0');
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t count = ::send(ends_->to, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
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
    pollfd watched{ends_->from, POLLIN, 0};
    if (::poll(&watched, 1, patience_ms) <= 0) continue;
    const ssize_t count = ::read(ends_->from, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    come.append(piece.data(), static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

void PipedProcess::wait(Clock::time_point deadline) {
  while (ends_->child > 0 && Clock::now() < deadline) {
    if (::waitpid(ends_->child, nullptr, WNOHANG) == ends_->child) {
      ::kill(-ends_->child, SIGKILL);  // what it left behind
      ends_->child = -1;
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(patience_ms / 5));
  }
}

std::string PipedProcess::complaint() const {
  constexpr off_t kept = 8192;
  std::string text(kept, '\0');
  const off_t size = ::lseek(ends_->said, 0, SEEK_END);
  const ssize_t count = ::pread(ends_->said, text.data(), text.size(), std::max<off_t>(0, size - kept));
  text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  const std::size_t end = text.find_last_not_of(" \r\n\t");
  if (end == text.npos) return {};
  const std::size_t before = text.rfind('\n', end);
  return text.substr(before == text.npos ? 0 : before + 1, end - (before == text.npos ? 0 : before + 1) + 1);
}

OwnFolder::OwnFolder() : path_((std::filesystem::temp_directory_path() / "odontoscope-XXXXXX").string()) {
  if (::mkdtemp(path_.data()) == nullptr)
    throw FileError(path_, std::strerror(errno), "Let TMPDIR name a folder that can be written to");
}

OwnFolder::~OwnFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::string program_in_path(const std::vector<std::string>& names) {
  const char* const variable = std::getenv("PATH");
  const std::string folders = variable == nullptr ? "" : variable;
  for (const std::string& name : names)
    for (std::size_t at = 0; at <= folders.size();) {
      const std::size_t end = std::min(folders.find(':', at), folders.size());
      const std::string file = (std::filesystem::path(folders.substr(at, end - at)) / name).string();
      if (end > at && ::access(file.c_str(), X_OK) == 0) return file;
      at = end + 1;
    }
  return {};
}

bool is_root() { return ::geteuid() == 0; }

}  // namespace odontoscope::app
