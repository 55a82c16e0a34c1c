#pragma once
// What `contours` and `reconstruct` have in common: how a volume becomes contours.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "recon/input/contour_stack.h"
#include "recon/volume/volume_contours.h"

namespace odontoscope::app {

/// As typed; not yet understood.
struct VolumeWords {
  std::vector<std::string> isos;     // "T" or "T=NAME"
  std::vector<std::string> labels;   // "N" or "N=NAME"
  std::string spacing;               // "X,Y,Z" or empty
  std::optional<double> min_area;    // mm^2
  std::optional<double> simplify;    // mm
  std::optional<double> smooth;      // mm

  bool any_level() const { return !isos.empty() || !labels.empty(); }
};

void add_volume_options(CLI::App& parser, VolumeWords& words);

/// Throws UsageError for anything that is no number, name or triple, and for two structures of one name.
VolumeContourOptions understood(const VolumeWords& words);

/// The volume's contours, and tells what it found. `volume`, if not null, is given the volume itself.
ContourStack contours_told(const std::string& file, const VolumeContourOptions& options, Session& session, Volume* volume = nullptr);

/// A valid stack with fewer points, and tells how many.
ContourStack simplify_told(const ContourStack& stack, const SimplifyContoursOptions& options, Session& session);

/// From a volume if `words` say where its surface lies, otherwise from a contour stack, simplified if they ask for it. Throws as the
/// readers do.
ContourStack contours_of_input(const std::string& file, const VolumeWords& words, Session& session);

/// UsageError for a volume, or words about one, without a word on where its surface lies.
void refuse_volume_without_level(const std::string& file, const VolumeWords& words);

/// Does the name look like a volume's: a folder, or an ending that read_volume knows?
bool named_like_a_volume(const std::string& file);

}  // namespace odontoscope::app
