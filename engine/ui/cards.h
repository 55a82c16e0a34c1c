#pragma once
// What comes up over the picture and goes away again: work in progress, questions, errors, keys, short notices.

#include "engine/ui/interface.h"
#include "engine/ui/loading.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

/// `viewport` is the part of the picture that the panel leaves.
void draw_cards(ViewerState& state, const LoadJob* loading, const Interface& interface, const Area& viewport);

/// "Cutting the slices into triangles" for "conform".
std::string stage_in_words(std::string_view stage);

}  // namespace odontoscope
