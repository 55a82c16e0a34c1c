#pragma once
// What the subcommands that read volumes have in common: how a volume becomes contours.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/reshape_volume.h"
#include "engine/app/structure_files.h"
#include "recon/input/validate.h"
#include "recon/output/report_json.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/volume_contours.h"

namespace odontoscope::app {

/// As typed; not yet understood.
struct VolumeWords {
  std::vector<std::string> isos;    // "T", "T=NAME", "auto", "auto:CLASSES/NUMBER=NAME"
  std::vector<std::string> labels;  // "N", "N=NAME", or the name of a segment of the file
  std::string label_names;          // file of ITK-SNAP
  std::string spacing;              // "X,Y,Z" or empty
  std::string series;               // of DICOM
  std::string min_area;             // "4" voxels, or "0.5mm2"
  bool allow_outside = false;
  std::optional<double> simplify;  // mm
  std::optional<double> smooth;    // mm
  ReshapeWords reshape;
  bool voxels = false;  // grey values themselves are shown, not only what surfaces are made of them

  bool any_level() const { return !isos.empty() || !labels.empty(); }
};

/// A level at one of Otsu's thresholds.
struct AutoLevel {
  std::size_t classes = 2, number = 1;  // its number among the classes - 1 thresholds, from 1 on
  std::string structure = "tooth";
};

/// Understood as far as that goes without the volume.
struct VolumeRequest {
  ReadVolumeOptions read;
  struct Level {
    std::optional<IsoLevel> iso;
    std::optional<AutoLevel> automatic;
    std::optional<LabelLevel> label;
    bool label_is_named = false;            // by the user
    std::optional<std::string> label_name;  // of the file, instead of a number
  };
  std::vector<Level> levels;
  double min_area = 0;
  bool min_area_in_mm2 = false;  // else in pixels of a slice
  std::optional<SmoothLabelsOptions> smooth;
  std::optional<double> simplify;
  std::vector<VolumeLabel> label_names;
  ReshapeRequest reshape;
};

void add_volume_options(CLI::App& parser, VolumeWords& words);

/// Throws UsageError for anything that is no number, name or triple, and for two structures of one name; FileError and
/// InputError for a file of label names.
VolumeRequest understood(const VolumeWords& words);

/// What the levels are in this volume: numbers for what depended on it, and tells the thresholds.
VolumeContourOptions levels_told(const Volume& volume, const VolumeRequest& request, Session& session);

/// The contours of these levels in a volume that is cropped, resampled and turned as it shall be, and tells of them.
/// `facts`, if not null, is given what a report says of the volume; `upright` is its turn, if there was one.
ContourStack traced_told(const Volume& volume, VolumeContourOptions levels, const VolumeRequest& request,
                         const std::optional<RigidMotion>& upright, Session& session,
                         std::optional<ReportVolume>* facts = nullptr);

/// The volume's contours, and tells what it found, assumed and left out. `volume`, if not null, is given the volume
/// itself, `facts` what a report says of it, `whence` its grid and the patient that it lies in.
ContourStack contours_told(const std::string& file, const VolumeRequest& request, Session& session,
                           Volume* volume = nullptr, std::optional<ReportVolume>* facts = nullptr,
                           Whence* whence = nullptr);

/// Tells the volume's size and values with a bar each, and the thresholds that --iso auto would take.
void tell_histogram(const std::string& file, const VolumeRequest& request, Session& session);

/// A valid stack with fewer points, and tells how many.
ContourStack simplify_told(const ValidStack& stack, const SimplifyContoursOptions& options, Session& session);

/// From a volume if `words` say where its surface lies, otherwise from a contour stack, simplified if they ask for it.
/// Throws as the readers do.
ValidStack contours_of_input(const std::string& file, const VolumeWords& words, Session& session,
                             std::optional<ReportVolume>* facts = nullptr, Whence* whence = nullptr);

/// UsageError for a volume, or words about one, without a word on where its surface lies.
void refuse_volume_without_level(const std::string& file, const VolumeWords& words);

/// A folder, a name that ends like a volume's, or a beginning like one's (DICOM seldom has an ending)? Pipes are left
/// alone.
bool looks_like_a_volume(const std::string& file);

}  // namespace odontoscope::app
