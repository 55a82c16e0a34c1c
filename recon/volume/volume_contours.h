#pragma once
// From a volume file to a contour stack in one call: what `odontoscope contours` does, and `reconstruct` with --iso.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recon/contours/simplify_contours.h"
#include "recon/core/progress.h"
#include "recon/volume/contour_levels.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/label_contours.h"
#include "recon/volume/volume.h"

namespace odontoscope {

struct VolumeContourOptions {
  /// At least one of the two; contours come in this order, isos first.
  std::vector<IsoLevel> isos;
  std::vector<LabelLevel> labels;
  TraceOptions trace;
  /// Smooth the labels' borders.
  std::optional<SmoothLabelsOptions> smooth;
  /// Simplify the contours with this tolerance.
  std::optional<SimplifyContoursOptions> simplify;
  /// Spacing instead of the header's, see ReadVolumeOptions.
  std::optional<std::array<double, 3>> spacing;
};

/// What a report or a log says of the volume.
struct VolumeSummary {
  std::array<std::size_t, 3> size{};
  std::array<double, 3> spacing{};
  Point3 origin;
  ValueRange range;
  double tilt_degrees = 0;
  /// What the contours' coordinates are multiples of halves of, and how far a voxel lies from where the file has it,
  /// at most; mm. See lattice.h.
  double lattice_step = 0, lattice_shift = 0;
};

struct VolumeContours {
  ContourStack stack;
  VolumeSummary volume;
  /// Counts before simplification.
  std::vector<LevelReport> levels;
  struct Simplification {
    std::size_t points_before = 0, points_after = 0;
    double largest_deviation = 0;
  };
  std::optional<Simplification> simplification;
  /// How far smoothing moved a point at most, mm; if it was asked for.
  std::optional<double> smoothing_shift;
};

/// Throws what read_volume, iso_contours, label_contours and simplify_contours throw. The stack passes `validate`.
VolumeContours contours_from_volume(const std::string& path, const VolumeContourOptions& options,
                                    const Progress& progress = {});

/// The same of a volume that was read before and passes validate_volume; options.spacing has had its say by then.
VolumeContours contours_of_volume(const Volume& volume, const VolumeContourOptions& options,
                                  const Progress& progress = {});

/// "120" or "120=dentine". Without a name the structure is "tooth". Throws UsageError.
IsoLevel parse_iso_level(std::string_view text);
/// "3" or "3=pulp". Without a name the structure is "label-3". Throws UsageError.
LabelLevel parse_label_level(std::string_view text);
/// "0.12,0.12,0.5": three positive numbers, mm. Throws UsageError.
std::array<double, 3> parse_spacing(std::string_view text);

}  // namespace odontoscope
