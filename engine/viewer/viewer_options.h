#pragma once
// What a viewer is made with.

#include <filesystem>
#include <functional>
#include <vector>

#include "engine/language/language.h"
#include "engine/ui/interface.h"
#include "engine/viewer/loading.h"
#include "engine/viewer/modes.h"
#include "engine/viewer/settings.h"

namespace odontoscope {

struct ViewerOptions {
  Loader load = {};
  /// Must a person say first where its surface lies? By what the request says and the file's name; must be quick.
  std::function<bool(const LoadRequest&)> wants_level = [](const LoadRequest&) { return false; };
  /// Empty: such a question is asked without a picture.
  Previewer preview = {};
  Settings settings = {};
  /// That it speaks, until another is chosen in its panel.
  Language language = {};
  /// Where pictures and scenes are saved; empty: the current folder.
  std::filesystem::path folder = {};
  Clipboard clipboard = {};
  /// That shows the desktop's dialogs, see desktop_dialog.h; empty: the viewer asks by a list of its own.
  std::string dialog_program = {};
  /// Samples a pixel along one axis for a picture that stands still. While it moves, one, if this machine is too slow
  /// for more and `coarse_when_slow`; without that, pictures depend on nothing but the state.
  int side = 2;
  bool coarse_when_slow = true;
  /// Show what the loader has meanwhile, where nothing else is to be seen. What comes then depends on how fast the
  /// machine is.
  bool with_drafts = false;
  std::vector<ModeMaker> modes = standard_modes();
};

}  // namespace odontoscope
