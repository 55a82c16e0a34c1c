#pragma once
// What comes up over the picture and goes away again: work in progress, questions, errors, keys, short notices.

#include "engine/ui/interface.h"
#include "engine/ui/loading.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

/// A dialog in the middle of the viewport, as high as what it holds, until it goes out of scope.
class Dialog {
 public:
  Dialog(const char* id, const Area& viewport, float width);
  ~Dialog();
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;
};

/// `viewport` is the part of the picture that the panel leaves.
void draw_cards(ViewerState& state, const LoadJob* loading, const Interface& interface, const Area& viewport);

/// Begins a dialog to read, in the middle of the viewport's lower edge; ImGui::End() ends it. Lengths are of a screen
/// of usual density.
bool begin_dialog(const char* id, const Area& viewport, float scale, float most_width, float from_bottom);

/// "Cutting the slices into triangles" for "conform".
std::string stage_in_words(std::string_view stage);

}  // namespace odontoscope
