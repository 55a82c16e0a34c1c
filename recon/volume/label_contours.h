#pragma once
// Contours of the labels of a label map (a segmentation: each pixel's value names what it is).
//
// A pixel is inside a label where its value equals it. Contours cross grid edges at their midpoints, so a label's
// outline runs through pixel edges' middles with its corners cut at 45 degrees, and the wall between two labels is one
// and the same line in both: they coincide there exactly. Where three or four labels meet in a cell their walls meet,
// too (label_meetings.h). Pixels of one label that meet only across a corner are not joined, so different labels never
// overlap. At the image's border the contour runs half a pixel outside the outermost centres. All points lie on the
// volume's lattice (lattice.h), as exactly as if voxels measured 2 x 2.
//
// All contours of a label are closed, simple and pairwise disjoint. The zigzag of pixels stays, unless points are moved
// along their grid edges by SmoothLabels, which changes nothing of the above but the midpoints.

#include <cstdint>
#include <memory>

#include "recon/volume/contour_levels.h"
#include "recon/volume/smooth_labels.h"

namespace odontoscope {

struct LabelLevel {
  /// Up to limits::largest_label in size: beyond that a float cannot tell neighbouring numbers apart.
  std::int64_t label = 1;
  std::string structure = "tooth";
};

/// Where labels overlap (Volume::overlaps), a pixel is inside each of them, and their contours may cross; walls then do
/// not meet where three labels do.
/// Throws InputError label-not-found, naming labels that are there, and what validate_volume and trace_levels throw;
/// UsageError for a label beyond limits::largest_label. A label that fills the whole volume is contoured along the
/// border.
TracedContours label_contours(const Volume& volume, const std::vector<LabelLevel>& labels,
                              const TraceOptions& options = {}, const Progress& progress = {});

/// The labels' smoothed borders, for label_tracers. Throws as label_contours and SmoothLabels do; UsageError for labels
/// that overlap others.
std::shared_ptr<const SmoothLabels> smoothed(const Volume& volume, const std::vector<LabelLevel>& labels,
                                             const SmoothLabelsOptions& options, const Progress& progress = {});

/// The same labels as tracers, for a stack that mixes them with iso values. The volume must outlive them.
/// `smooth` may be null.
std::vector<LevelTracer> label_tracers(const Volume& volume, const std::vector<LabelLevel>& labels,
                                       const std::shared_ptr<const SmoothLabels>& smooth = {});

}  // namespace odontoscope
