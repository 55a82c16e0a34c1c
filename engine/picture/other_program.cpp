#include "engine/picture/other_program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

extern char** environ;

namespace odontoscope {
namespace {

std::pair<int, int> connected() {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return {-1, -1};
  return {ends[0], ends[1]};
}

}  // namespace

Descriptor::Descriptor(int opened) {
  constexpr int beyond_the_childs = 16;
  if (opened < 0) return;
  number_ = ::fcntl(opened, F_DUPFD_CLOEXEC, beyond_the_childs);
  ::close(opened);
}

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

Connection::Connection() : Connection(connected()) {}

int nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "odontoscope-XXXXXX").string();
  const int opened = ::mkostemp(name.data(), O_CLOEXEC);
  if (opened >= 0) ::unlink(name.c_str());
  return opened;
}

std::string all_bytes(int descriptor) {
  std::string bytes;
  std::array<char, 1 << 16> piece;
  for (off_t at = 0;;) {
    const ssize_t count = ::pread(descriptor, piece.data(), piece.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(piece.data(), static_cast<std::size_t>(count));
    at += count;
  }
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return {};
  const std::size_t start = text.find_last_of("\r\n", end);
  const std::size_t first = start == std::string::npos ? 0 : start + 1;
  std::string line = text.substr(first, end - first + 1);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  constexpr std::size_t most = 300;
  return line.substr(0, most);
}

OtherProgram::~OtherProgram() {
  if (child_ <= 0) return;
  ::kill(-child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

int OtherProgram::start(std::vector<std::string> words, const std::vector<std::pair<int, int>>& files) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  for (const auto& [here, there] : files) ::posix_spawn_file_actions_adddup2(&actions, here, there);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  sigset_t none;
  ::sigemptyset(&none);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  const int error = ::posix_spawnp(&child_, argv.front(), &actions, &attributes, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (error != 0) child_ = -1;
  return error;
}

bool OtherProgram::ended(int& status) {
  const pid_t ended = ::waitpid(child_, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
  if (ended < 0)
    status = -1;
  else
    ::kill(-child_, SIGKILL);  // what it left behind
  child_ = -1;
  return true;
}

std::string program_in_path(const std::vector<std::string>& names) {
  const char* const variable = std::getenv("PATH");
  const std::string folders = variable == nullptr ? "" : variable;
  for (const std::string& name : names)
    for (std::size_t at = 0; at <= folders.size();) {
      const std::size_t end = std::min(folders.find(':', at), folders.size());
      const std::filesystem::path program = std::filesystem::path(folders.substr(at, end - at)) / name;
      std::error_code error;
      if (end > at && std::filesystem::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0)
        return program.string();
      at = end + 1;
    }
  return {};
}

}  // namespace odontoscope
