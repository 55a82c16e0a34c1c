#pragma once
// Label maps without their staircase: where between two voxels the border of a label runs, guessed from its
// surroundings.
//
// Each label gets a height for every voxel near its border: at first the signed distance to the faces of voxels that
// part it from others (positive inside), then bent as little as possible: a few steps down the gradient of its squared
// Laplacian, over all three axes, never farther than half a voxel from that distance and never across zero. Whitaker,
// "Reducing aliasing artifacts in iso-surfaces of binary volumes" (2000); Lempitsky, "Surface extraction from binary
// volumes with higher-order smoothness" (2010). A thin plate does not shrink what it smooths, as blurring does: a canal
// of three voxels keeps its width. Only few steps are taken, since after many it would.
//
// A contour of label a then crosses the grid line to a voxel of label b where the difference of their heights is zero.
// That is strictly between the two voxels' centres, so the contours' topology is that of the unsmoothed map whatever
// the heights are: nothing is lost, joined or parted, and no pixel changes sides (trace.h). Seen from b it is the same
// difference, so both have the same point to the bit. Where three labels meet in a cell, its points stay in the middle
// between voxels.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/contours/trace.h"
#include "recon/core/progress.h"
#include "recon/volume/lattice_crossing.h"
#include "recon/volume/volume.h"

namespace odontoscope {

struct SmoothLabelsOptions {
  /// How far a point may move along its grid line, mm; never more than half a voxel less limits::grid_vertex_margin of
  /// it.
  double distance = 0;
};

class SmoothLabels {
 public:
  /// All labels that are contoured together; whatever else is in the volume counts as one. Precondition:
  /// validate_volume passed; the volume outlives this. Memory: 4 bytes a voxel while it is made, some 100 a voxel of
  /// border. Runs in the caller's TBB arena; the result does not depend on the number of threads. Throws UsageError for
  /// a distance that is negative or not a number. Stage: "smooth".
  SmoothLabels(const Volume& volume, const std::vector<float>& labels, const SmoothLabelsOptions& options,
               const Progress& progress = {});

  /// What part of the way from the grid vertex `low` to its next along the axis (0 or 1) their border lies, in slice k.
  /// Precondition: both are pixels of different labels of which at least one was named.
  double crossing(std::size_t k, trace::Vertex low, int axis) const;

  /// Of the points between named labels and others, mm.
  double largest_shift() const { return largest_shift_; }

 private:
  /// Voxels near the border of one label, ascending, and their heights.
  struct Band {
    float label = 0;
    std::vector<std::size_t> voxels;
    std::vector<float> heights;
  };
  const Band* band_of(float value) const;
  bool three_meet(std::size_t k, trace::Vertex low, int axis) const;
  double find_largest_shift() const;

  const Volume& volume_;
  double distance_ = 0, largest_shift_ = 0;
  std::vector<Band> bands_;
};

}  // namespace odontoscope
