#pragma once
// What is known of a surface, in the viewer's plain words.

#include "engine/app/shown_input.h"
#include "engine/ui/loading.h"

namespace odontoscope::app {

/// Of a reconstruction what it proved of itself; of a mesh what inspecting it finds.
Certificate certificate_of(const Shown& shown, const Progress& progress);

}  // namespace odontoscope::app
