#pragma once
// The rides down a model's canals as cameras that a file can carry.

#include <string_view>
#include <vector>

#include "engine/app/command.h"
#include "recon/cavity/centre_lines.h"
#include "recon/formats/camera_path.h"
#include "recon/formats/write_glb.h"
#include "recon/formats/written_model.h"

namespace odontoscope::app {

/// The lines of the largest void. UsageError that names `option` if there is no void.
CentreLines lines_inside(const WrittenModel& model, std::string_view option, Session& session);

/// One for each canal, longest first, as `render --tour` films it. UsageError if there is none.
std::vector<CameraPath> tour_cameras(const WrittenModel& model, const CentreLines& lines);

/// Places with names: the chamber, and of each canal orifice and tip.
std::vector<GlbHotspot> hotspots_of(const CentreLines& lines);

}  // namespace odontoscope::app
