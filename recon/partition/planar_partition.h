#pragma once
// A slice as a planar partition: every face has one label, and neighbours share their border to the bit.
//
// Where structures overlap the one of higher priority keeps the place. Where contours of two structures cross, the
// crossing becomes a point of both, rounded to doubles; borders that coincide become one. What lies in no structure is
// void, label 0. Void that is narrower than a stated gap between two structures is given to the one of higher priority.
//
// All borders are made Gabriel, as far as doubles allow (recon/delaunay/conform.h says why), by points added on them.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/delaunay/planar.h"
#include "recon/partition/contour_overlay.h"

namespace odontoscope::partition {

struct PartitionSlice {
  double z = 0;
  /// `region` of a triangle is its label, `none` for void. There are no contours: next, previous and region_of are none
  /// throughout. An edge is `contour` where labels differ.
  delaunay::Planar planar;
  std::size_t steiner_points = 0;
  bool conforming = true;  // false: some border is no Delaunay edge; no slab beside it can be triangulated

  Label label(delaunay::TriangleIndex triangle) const {
    if (triangle == delaunay::none || planar.triangles[triangle].region == delaunay::none) return void_label;
    return static_cast<Label>(planar.triangles[triangle].region);
  }
  bool empty() const { return planar.points.empty(); }
};

/// Throws InternalError if faces of one label meet in a point.
PartitionSlice planar_partition(const Borders& borders, double z, const Progress& progress);

}  // namespace odontoscope::partition
