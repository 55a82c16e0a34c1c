#pragma once
// The rides down a model's canals as cameras that a file can carry.

#include <vector>

#include "engine/app/command.h"
#include "recon/output/camera_path.h"
#include "recon/output/write_glb.h"
#include "recon/output/written_model.h"

namespace odontoscope::app {

/// One for each canal of the largest void, longest first, as `render --tour` films it. UsageError if there is no void, or it has no canal.
std::vector<CameraPath> tour_cameras(const WrittenModel& model, Session& session);

/// Places of the largest void with names: its chamber, and of each canal orifice and tip. UsageError if there is no void.
std::vector<GlbHotspot> hotspots_of(const WrittenModel& model, Session& session);

}  // namespace odontoscope::app
