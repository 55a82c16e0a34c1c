#pragma once
// What is known of a surface, in the viewer's plain words.

#include <string>
#include <vector>

#include "engine/app/shown_input.h"
#include "engine/ui/certificate.h"

namespace odontoscope::app {

/// Of surfaces that were made by a reconstruction which proved them.
Certificate certificate_of(const Shown::Proven& facts);

/// Of surfaces by what inspecting them found, one report a structure.
Certificate certificate_of(const std::vector<std::string>& structures, const std::vector<SurfaceReport>& reports);

/// Of a reconstruction what it proved of itself; of a mesh what inspecting it finds.
Certificate certificate_of(const Shown& shown, const Progress& progress);

}  // namespace odontoscope::app
