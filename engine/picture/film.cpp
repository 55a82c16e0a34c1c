#include "engine/picture/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"

extern char** environ;

namespace odontoscope {
namespace {

/// How often a request to stop is looked for while ffmpeg is slow.
constexpr int patience_ms = 50;
/// In the child: what ffmpeg writes.
constexpr int film_descriptor = 3;

/// The descriptor goes with it. Never one of those that the child gets its own under.
class Descriptor {
 public:
  explicit Descriptor(int opened) {
    constexpr int beyond_the_childs = 16;
    if (opened < 0) return;
    number_ = ::fcntl(opened, F_DUPFD_CLOEXEC, beyond_the_childs);
    ::close(opened);
  }
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  int number() const { return number_; }

 private:
  int number_ = -1;
};

/// A file without a name, open for reading and writing.
int nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "odontoscope-film-XXXXXX").string();
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

/// What a program says last is most often what is wrong.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return {};
  const std::size_t start = text.find_last_of("\r\n", end);
  std::string line = text.substr(start == std::string::npos ? 0 : start + 1, end - (start == std::string::npos ? 0 : start + 1) + 1);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  constexpr std::size_t most = 300;
  return line.substr(0, most);
}

std::string ending_of(const std::string& film) { return lower_case(std::filesystem::path(film).extension().string()); }

std::vector<std::string> words_for(const std::string& film, const FilmOptions& options) {
  std::vector<std::string> words = {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
                                    "-f", "rawvideo", "-pix_fmt", "rgba", "-s", fmt::format("{}x{}", options.width, options.height),
                                    "-r", fmt::format("{:g}", options.pictures_per_second), "-i", "pipe:0",
                                    "-an", "-map_metadata", "-1", "-fflags", "+bitexact",   // the same pictures give the same bytes
                                    "-vf", "scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p",
                                    "-color_range", "tv", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"};
  const std::vector<std::string> mp4 = {"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"};
  const std::vector<std::string> webm = {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-f", "webm"};
  const std::vector<std::string>& format = ending_of(film) == ".webm" ? webm : mp4;
  words.insert(words.end(), format.begin(), format.end());
  words.push_back(fmt::format("/dev/fd/{}", film_descriptor));
  return words;
}

}  // namespace

const std::vector<std::string>& film_endings() {
  static const std::vector<std::string> endings{".mp4", ".webm"};
  return endings;
}

void need_ffmpeg(const std::string& film) {
  const char* path = std::getenv("PATH");
  const std::string folders = path ? path : "";
  for (std::size_t from = 0; from <= folders.size();) {
    const std::size_t colon = std::min(folders.find(':', from), folders.size());
    const std::filesystem::path program = std::filesystem::path(folders.substr(from, colon - from)) / "ffmpeg";
    std::error_code error;
    if (std::filesystem::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0) return;
    from = colon + 1;
  }
  throw FileError(film, "cannot be made: films are made by ffmpeg, and it is not on the PATH", "Install it (Debian: ffmpeg), or name a folder for single pictures");
}

struct FilmMaker::Process {
  std::string film;
  pid_t child = -1;
  Descriptor ours, childs;   // two ends: pictures go in at ours
  Descriptor made{nameless_file()}, complaints{nameless_file()};

  Process(const std::string& name, std::array<int, 2> ends) : film(name), ours(ends[0]), childs(ends[1]) {}
  ~Process() {
    if (child <= 0) return;
    ::kill(child, SIGKILL);
    while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  void start(const FilmOptions& options) {
    if (ours.number() < 0 || childs.number() < 0 || made.number() < 0 || complaints.number() < 0) fail(fmt::format("no temporary file or connection: {}", std::strerror(errno)));
    std::vector<std::string> words = words_for(film, options);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, childs.number(), STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, complaints.number(), STDERR_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, made.number(), film_descriptor);
    // A group of its own, so that Ctrl-C is ours alone; and no signal blocked, as this program's threads have them.
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    const int error = ::posix_spawnp(&child, "ffmpeg", &files, &attributes, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    if (error != 0) child = -1;
    if (error != 0) fail(fmt::format("ffmpeg does not start: {}", std::strerror(error)));
    childs.close();
  }

  /// Waits for its end.
  int status(const Progress& progress) {
    int status = 0;
    while (true) {
      const pid_t ended = ::waitpid(child, &status, WNOHANG);
      if (ended == child) break;
      if (ended < 0 && errno != EINTR) fail(fmt::format("ffmpeg's end is not known: {}", std::strerror(errno)));
      progress.check();
      std::this_thread::sleep_for(std::chrono::milliseconds(patience_ms));
    }
    child = -1;
    return status;
  }

  [[noreturn]] void fail(const std::string& why) const { throw FileError(film, fmt::format("cannot be made: {}", why), "Name a folder instead, for single pictures"); }

  [[noreturn]] void fail_as_ended(int status) const {
    const std::string words = last_line(all_bytes(complaints.number()));
    fail(fmt::format("ffmpeg {}{}{}", WIFSIGNALED(status) ? fmt::format("was ended by signal {}", WTERMSIG(status)) : fmt::format("ended with exit code {}", WEXITSTATUS(status)),
                     words.empty() ? "" : ": ", words));
  }
};

FilmMaker::FilmMaker(const std::string& film, const FilmOptions& options) {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) ends = {-1, -1};
  process_ = std::make_unique<Process>(film, ends);
  process_->start(options);
}

FilmMaker::~FilmMaker() = default;

void FilmMaker::add(const Image& picture, const Progress& progress) {
  const std::uint8_t* from = picture.rgba.data();
  std::size_t left = picture.rgba.size();
  while (left > 0) {
    progress.check();
    pollfd ready{process_->ours.number(), POLLOUT, 0};
    if (::poll(&ready, 1, patience_ms) <= 0) continue;
    // A connection and not a pipe: a reader that is gone is an error here and not a signal that ends us.
    const ssize_t sent = ::send(process_->ours.number(), from, left, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent < 0) {
      process_->ours.close();
      process_->fail_as_ended(process_->status(progress));
    }
    from += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

std::string FilmMaker::finish(const Progress& progress) {
  process_->ours.close();   // its end: no more pictures
  const int status = process_->status(progress);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) process_->fail_as_ended(status);
  std::string bytes = all_bytes(process_->made.number());
  if (bytes.empty()) process_->fail("ffmpeg wrote nothing");
  return bytes;
}

}  // namespace odontoscope
