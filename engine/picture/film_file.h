#pragma once
// Pictures to a film, by the program ffmpeg where it is installed. POSIX.
//
// ffmpeg is started without a shell, gets the pictures through its standard input, and writes into a nameless file that
// goes with this process: nothing is left behind however it ends. It is killed when the work is stopped.

#include <memory>
#include <string>
#include <vector>

#include "engine/picture/image.h"
#include "recon/core/progress.h"

namespace odontoscope {

/// ".mp4" (H.264) and ".webm" (VP9): what browsers play.
const std::vector<std::string>& film_endings();

/// Whether the PATH has an ffmpeg. FileError that names `film` and says what to install, if not.
void need_ffmpeg(const std::string& film);

struct FilmOptions {
  int width = 0, height = 0;  // even: colour is stored for two by two pixels
  double pictures_per_second = 30;
};

class FilmMaker {
 public:
  /// Starts ffmpeg. `film` tells the format by its ending, and messages by its name; it is not touched. FileError if
  /// ffmpeg does not start. Preconditions: an ending of film_endings(), even sizes.
  FilmMaker(const std::string& film, const FilmOptions& options);
  /// Kills ffmpeg if it still runs.
  ~FilmMaker();

  /// The next picture; its alpha is dropped. FileError if ffmpeg ended. Cancelled.
  void add(const Image& picture, const Progress& progress);
  /// The film's bytes, once ffmpeg is done. FileError with what it complained of. Cancelled.
  std::string finish(const Progress& progress);

 private:
  struct Process;
  std::unique_ptr<Process> process_;
};

}  // namespace odontoscope
