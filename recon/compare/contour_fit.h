#pragma once
// How well a surface gives back the contours that it was made from: the paper's resampling, measured.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/compare/section.h"
#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_distance.h"

namespace odontoscope {

/// What one contour bounds, up to the next contours within: the widest place of it.
struct ContourPassage {
  std::size_t slice = 0, contour = 0;
  bool hole = false;  // void within material: a canal, if it is narrow; otherwise material
  Point2 middle;      // of the largest circle that fits in (to a hundredth of the contour's size)
  double width = 0;   // of that circle, mm
};

/// One for each contour of the structure, in order. `ordered_stack` as `ordered` gives it.
std::vector<ContourPassage> passages(const ContourStack& ordered_stack, const std::string& structure);

struct PassageCounts {
  std::size_t all = 0, lost = 0;  // lost: at that middle, in that slice, the model has void for material or the reverse
  double thinnest_kept = 0;       // mm; 0 if none
  double widest_lost = 0;         // mm; 0 if none
};

struct ContourFit {
  OneWayDistance contours_to_surface;  // from places spread evenly along the contours, in space
  OneWayDistance section_to_contours;  // from places along the model's section at each slice, below and above it, in
                                       // that plane, to the slice's contours
  PassageCounts holes, solids;         // by ContourPassage::hole
  std::size_t worst_slice = 0;         // where section_to_contours is largest
};

/// Of one structure. `surface` may have any defect. Runs in the caller's TBB arena; does not depend on the number of
/// threads. An empty surface has lost everything, and distances of 0. `options.samples` are spread along the contours,
/// and as many along the sections.
ContourFit contour_fit(const ContourStack& ordered_stack, const std::string& structure, const SurfaceMesh& surface,
                       const DistanceOptions& options = {}, const Progress& progress = {});

/// Both taken together: means weighted by `weight`, the length of the contours.
struct WeightedFit {
  ContourFit fit;
  double weight = 0;
};
ContourFit joined(const std::vector<WeightedFit>& fits);

/// Length of a structure's contours, mm.
double contour_length(const ContourStack& stack, const std::string& structure);

}  // namespace odontoscope
