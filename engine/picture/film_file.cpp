#include "engine/picture/film_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "engine/picture/other_program.h"
#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/core/system_processes.h"

namespace odontoscope {
namespace {

/// How often a request to stop is looked for while ffmpeg is slow.
constexpr int timeout_ms = 50;
/// In the child: where pictures come in, what it complains, what it makes.
constexpr int ffmpeg_reads = 0, ffmpeg_complains = 2, ffmpeg_writes = 3;

std::string ending_of(const std::string& film) { return lower_case(std::filesystem::path(film).extension().string()); }

std::vector<std::string> words_for(const std::string& film, const FilmOptions& options) {
  std::vector<std::string> words = {"ffmpeg",
                                    "-hide_banner",
                                    "-loglevel",
                                    "error",
                                    "-y",
                                    "-f",
                                    "rawvideo",
                                    "-pix_fmt",
                                    "rgba",
                                    "-s",
                                    fmt::format("{}x{}", options.width, options.height),
                                    "-r",
                                    fmt::format("{:g}", options.pictures_per_second),
                                    "-i",
                                    "pipe:0",
                                    "-an",
                                    "-map_metadata",
                                    "-1",
                                    "-fflags",
                                    "+bitexact",  // the same pictures give the same bytes
                                    "-vf",
                                    "scale=out_color_matrix=bt709:out_range=tv",
                                    "-pix_fmt",
                                    "yuv420p",
                                    "-color_range",
                                    "tv",
                                    "-colorspace",
                                    "bt709",
                                    "-color_primaries",
                                    "bt709",
                                    "-color_trc",
                                    "bt709"};
  const std::vector<std::string> mp4 = {"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"};
  const std::vector<std::string> webm = {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-f", "webm"};
  const std::vector<std::string>& format = ending_of(film) == ".webm" ? webm : mp4;
  words.insert(words.end(), format.begin(), format.end());
  words.push_back(system::file_of_descriptor(ffmpeg_writes));
  return words;
}

}  // namespace

const std::vector<std::string>& film_endings() {
  static const std::vector<std::string> endings{".mp4", ".webm"};
  return endings;
}

void need_ffmpeg(const std::string& film) {
  if (!program_in_path({"ffmpeg"}).empty()) return;
  throw FileError(film, "cannot be made: films are made by ffmpeg, and it is not on the PATH",
                  "Install it (Debian: ffmpeg), or name a folder for single pictures");
}

struct FilmMaker::Process {
  std::string film;
  system::Connection pictures = system::connect();  // go in at our end
  system::Descriptor made = system::nameless_file(), complaints = system::nameless_file();
  system::Process program;

  explicit Process(const std::string& name) : film(name) {}

  void start(const FilmOptions& options) {
    if (!pictures.childs.is_open() || !made.is_open() || !complaints.is_open())
      fail(fmt::format("no temporary file or connection: {}", std::strerror(errno)));
    if (!program.start(words_for(film, options),
                       {{&pictures.childs, ffmpeg_reads}, {&complaints, ffmpeg_complains}, {&made, ffmpeg_writes}}))
      fail(fmt::format("ffmpeg does not start: {}", std::strerror(errno)));
    pictures.childs.close();
  }

  system::Ending ending(const Progress& progress) {
    for (;;) {
      if (const auto ended = program.ended()) return *ended;
      progress.check();
      std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
    }
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw FileError(film, fmt::format("cannot be made: {}", why), "Name a folder instead, for single pictures");
  }

  [[noreturn]] void fail_as(const system::Ending& ending) const {
    const std::string words = last_line(system::all_bytes(complaints));
    fail(fmt::format("ffmpeg {}{}{}", ending.in_words(), words.empty() ? "" : ": ", words));
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
    const std::ptrdiff_t sent =
        system::send_within(process_->pictures.ours, reinterpret_cast<const char*>(from), left, timeout_ms);
    if (sent == system::nothing_yet) continue;
    if (sent < 0) {
      process_->pictures.ours.close();
      process_->fail_as(process_->ending(progress));
    }
    from += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

std::string FilmMaker::finish(const Progress& progress) {
  process_->pictures.ours.close();  // its end: no more pictures
  const system::Ending ending = process_->ending(progress);
  if (ending.exit_code != 0) process_->fail_as(ending);
  std::string bytes = system::all_bytes(process_->made);
  if (bytes.empty()) process_->fail("ffmpeg wrote nothing");
  return bytes;
}

}  // namespace odontoscope
