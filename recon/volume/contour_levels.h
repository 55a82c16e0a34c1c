#pragma once
// What iso_contours and label_contours have in common: options, report, and the run over all slices.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"
#include "recon/volume/small_contours.h"
#include "recon/volume/volume.h"

namespace odontoscope {

struct TraceOptions {
  /// Contours that enclose less than this are dropped, mm^2: an outer contour with all that lies inside it, and holes
  /// too. The area is that within the contour itself, its holes not taken off.
  double min_area = 0;
};

/// What became of one level or label.
struct LevelReport {
  std::string structure;
  std::size_t contours = 0;
  std::size_t points = 0;
  /// Contours below min_area.
  std::size_t dropped = 0;
  DroppedCounts small;
  /// Kept contours that hang together by corners only, see count_pieces.
  std::size_t pieces = 0;
};

struct TracedContours {
  /// Slices of the volume by ascending z, from the first that has a contour to the last; those without any in between
  /// stay, empty. In a slice: by level in the order given, then by lowest point. Outer contours counter-clockwise seen
  /// from +z, holes clockwise.
  ContourStack stack;
  std::vector<LevelReport> levels;
};

/// One level, ready to be traced: `trace(slice number, take)` hands every contour to `take` until that returns false.
struct LevelTracer {
  using Take = std::function<bool(std::vector<Point2>&&)>;
  std::string structure;
  std::function<void(std::size_t, const Take&)> trace;
  /// "iso value 120", for messages.
  std::string in_words;
};

/// Traces all levels in all slices, in parallel; the result does not depend on the number of threads. Stage "contours".
/// Throws UsageError for a min_area that is negative or not finite, for two levels with one structure name and for none
/// at all; InputError min-area-drops-all, single-slice (all contours lie in one slice), too-many-contours,
/// too-many-points. Precondition: validate_volume passed and every tracer yields at least one contour.
TracedContours trace_levels(const Volume& volume, const std::vector<LevelTracer>& tracers, const TraceOptions& options,
                            const Progress& progress);

}  // namespace odontoscope
