#pragma once
// What comes up over the picture and goes away again.

#include "engine/ui/area.h"
#include "engine/ui/interface.h"

namespace odontoscope {

/// A dialog in the middle of the viewport, as high as what it holds, until it goes out of scope.
class Dialog {
 public:
  Dialog(const char* id, const Area& viewport, float width);
  ~Dialog();
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;
};

void dialog_title(const Interface& interface, const char* words);

/// Begins a dialog to read, in the middle of the viewport's lower edge; ImGui::End() ends it. Lengths are of a screen
/// of usual density.
bool begin_dialog(const char* id, const Area& viewport, float scale, float most_width, float from_bottom);

}  // namespace odontoscope
