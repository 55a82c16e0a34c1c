#pragma once
// The viewer without hands: what a person would do, as words, and pictures of what they would see. docs/viewer.md has
// the list for users.
//
// Time is the script's own: an animation takes as long as it would by the clock, in fewer frames, however long the
// machine takes for one. So the same script gives the same pictures.

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/viewer/viewer.h"
#include "recon/core/atomic_file.h"
#include "recon/core/progress.h"

namespace odontoscope::app {

/// Events of one moment after the other, a frame after each.
struct ScriptEvents {
  std::vector<std::vector<Event>> moments;
};
struct ScriptWait {
  double seconds = 0;
};
/// Keys held down meanwhile.
struct ScriptHold {
  std::string places;  // small letters
  double seconds = 0;
};
struct ScriptSave {
  enum class What { window, picture, scene } what = What::window;
  std::string file;
};
/// Of pictures from then on.
struct ScriptFormat {
  PictureSettings settings;
};
using ScriptStep = std::variant<ScriptEvents, ScriptWait, ScriptHold, ScriptFormat, ScriptSave>;

/// A script in words; "@FILE" stands for a file's lines, of which those that begin with # say nothing. Throws
/// UsageError for a word that is none, FileError for the file.
std::vector<ScriptStep> script_steps(const std::string& text);

/// The files that it writes, in order.
std::vector<std::string> files_of(const std::vector<ScriptStep>& steps);

/// Runs it, and gives what it saves. Precondition: something is loaded, or being loaded. Throws what loading threw,
/// Cancelled.
std::vector<FileContent> run_script(const std::vector<ScriptStep>& steps, Viewer& viewer, const Gl& gl, PixelSize size,
                                    const Progress& progress);

}  // namespace odontoscope::app
