#pragma once
// --crop, --resample and --upright: a volume on another grid before contours are taken.

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

#include "engine/app/command.h"
#include "recon/core/rigid_motion.h"
#include "recon/volume/regrid.h"
#include "recon/volume/volume_contours.h"

namespace odontoscope::app {

/// As typed.
struct ReshapeWords {
  std::string crop;                // "X0,X1,Y0,Y1,Z0,Z1" or empty
  std::optional<double> resample;  // mm
  bool upright = false;

  bool any() const { return !crop.empty() || resample || upright; }
};

struct ReshapeRequest {
  std::optional<VolumeBox> crop;
  std::optional<double> resample;
  bool upright = false;
};

void add_reshape_options(CLI::App& parser, ReshapeWords& words);

/// UsageError for what is no box, or no size of a voxel.
ReshapeRequest understood(const ReshapeWords& words);

/// Crops as asked, and tells it.
void crop_told(Volume& volume, const ReshapeRequest& request, Console& console);

/// Resamples and turns as asked, and tells it. Upright stands what belongs to any level. Returns the turn, if there was
/// one.
std::optional<RigidMotion> reshape_told(Volume& volume, const ReshapeRequest& request,
                                        const VolumeContourOptions& levels, Session& session);

}  // namespace odontoscope::app
