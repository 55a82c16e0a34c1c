#pragma once
// What `contours` and `reconstruct` have in common: how a volume becomes contours.

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "recon/input/contour_stack.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/label_contours.h"

namespace odontoscope::app {

/// As typed; not yet understood.
struct VolumeOptions {
  std::vector<std::string> iso;      // "T" or "T=NAME"
  std::vector<std::string> label;    // "N" or "N=NAME"
  std::string spacing;               // "X,Y,Z" or empty
  std::optional<double> min_area;    // mm^2
  std::optional<double> simplify;    // mm

  bool any_level() const { return !iso.empty() || !label.empty(); }
};

void add_volume_options(CLI::App& parser, VolumeOptions& options);

/// What is understood of it. Throws UsageError for anything that is no number, name or triple.
struct VolumeRequest {
  std::vector<IsoLevel> iso;
  std::vector<LabelLevel> labels;
  std::optional<std::array<double, 3>> spacing;
};
VolumeRequest understood(const VolumeOptions& options);

/// Reads the volume and contours it, simplification included; says what was dropped. Throws what read_volume, trace_levels and
/// simplify_contours throw. Precondition: options.any_level().
ContourStack contours_of_volume(const std::string& file, const VolumeOptions& options, Session& session);

/// `stack` with fewer points if --simplify was given; says how many. Precondition: `stack` is valid.
ContourStack simplified(ContourStack stack, const VolumeOptions& options, Session& session);

/// Does the name look like a volume's: a folder, or an ending that read_volume knows?
bool named_like_a_volume(const std::string& file);

}  // namespace odontoscope::app
