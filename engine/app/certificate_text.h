#pragma once
// What is known of a surface, in the viewer's plain words.

#include <string>
#include <vector>

#include "engine/app/proven.h"
#include "engine/scene/model.h"
#include "engine/viewer/certificate.h"

namespace odontoscope::app {

/// Of surfaces that were made by a reconstruction which proved them.
Certificate certificate_of(const Proven& facts);

/// Of surfaces by what inspecting them found, one report a structure.
Certificate certificate_of(const std::vector<std::string>& structures, const std::vector<SurfaceReport>& reports);

/// Of surfaces that nobody proved: each is inspected.
Certificate certificate_of(const std::vector<NamedSurface>& surfaces, const Progress& progress);

}  // namespace odontoscope::app
