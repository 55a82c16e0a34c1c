#include "engine/picture/film.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "engine/picture/other_program.h"
#include "recon/core/error.h"
#include "recon/core/lower_case.h"

namespace odontoscope {
namespace {

/// How often a request to stop is looked for while ffmpeg is slow.
constexpr int patience_ms = 50;
/// In the child: what ffmpeg writes.
constexpr int film_descriptor = 3;

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
  if (!program_in_path({"ffmpeg"}).empty()) return;
  throw FileError(film, "cannot be made: films are made by ffmpeg, and it is not on the PATH", "Install it (Debian: ffmpeg), or name a folder for single pictures");
}

struct FilmMaker::Process {
  std::string film;
  OtherProgram program;
  Connection pictures;   // go in at our end
  Descriptor made{nameless_file()}, complaints{nameless_file()};

  explicit Process(const std::string& name) : film(name) {}

  void start(const FilmOptions& options) {
    if (pictures.ours.number() < 0 || pictures.childs.number() < 0 || made.number() < 0 || complaints.number() < 0) fail(fmt::format("no temporary file or connection: {}", std::strerror(errno)));
    const int error = program.start(words_for(film, options), {{pictures.childs.number(), STDIN_FILENO}, {complaints.number(), STDERR_FILENO}, {made.number(), film_descriptor}});
    if (error != 0) fail(fmt::format("ffmpeg does not start: {}", std::strerror(error)));
    pictures.childs.close();
  }

  /// Waits for its end.
  int status(const Progress& progress) {
    int status = 0;
    while (!program.ended(status)) {
      progress.check();
      std::this_thread::sleep_for(std::chrono::milliseconds(patience_ms));
    }
    if (status == -1) fail(fmt::format("ffmpeg's end is not known: {}", std::strerror(errno)));
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
  process_ = std::make_unique<Process>(film);
  process_->start(options);
}

FilmMaker::~FilmMaker() = default;

void FilmMaker::add(const Image& picture, const Progress& progress) {
  const std::uint8_t* from = picture.rgba.data();
  std::size_t left = picture.rgba.size();
  while (left > 0) {
    progress.check();
    pollfd ready{process_->pictures.ours.number(), POLLOUT, 0};
    if (::poll(&ready, 1, patience_ms) <= 0) continue;
    // A connection and not a pipe: a reader that is gone is an error here and not a signal that ends us.
    const ssize_t sent = ::send(process_->pictures.ours.number(), from, left, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent < 0) {
      process_->pictures.ours.close();
      process_->fail_as_ended(process_->status(progress));
    }
    from += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

std::string FilmMaker::finish(const Progress& progress) {
  process_->pictures.ours.close();   // its end: no more pictures
  const int status = process_->status(progress);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) process_->fail_as_ended(status);
  std::string bytes = all_bytes(process_->made.number());
  if (bytes.empty()) process_->fail("ffmpeg wrote nothing");
  return bytes;
}

}  // namespace odontoscope
