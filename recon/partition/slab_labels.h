#pragma once
// Which label each tetrahedron of a slab gets, given which points are raised. Inner part of partition_slab.h.

#include <cstdint>
#include <utility>
#include <vector>

#include "recon/delaunay/slab.h"
#include "recon/partition/dual_labels.h"
#include "recon/partition/margin_ramp.h"
#include "recon/partition/planar_partition.h"

namespace odontoscope::partition {

/// Of each point of a slab: whether it is raised off its slice.
using Raised = Table<delaunay::SlabPoint, bool>;

class SlabLabels {
 public:
  SlabLabels(const delaunay::SlabTetrahedra& tetrahedra, const PartitionSlice& lower, const PartitionSlice& upper,
             const Materials& materials);

  /// Triangles whose face the point above or below them knows nothing of. Such a face ends here: their corners are to
  /// be raised before anything is labelled.
  const std::vector<EndingTriangle>& ending() const { return ending_; }
  /// How far some of their corners rise.
  const std::vector<RaisedShare>& ramp() const { return ramp_; }

  /// The label of tetrahedron t. Where two edges contradict each other, the loser's ends are added to `losers`.
  Label label(delaunay::TetIndex t, const Raised& raised, std::vector<delaunay::SlabPoint>& losers) const;

 private:
  std::vector<EndingTriangle> ending_triangles() const;
  bool gives_way(delaunay::SlabPoint margin, Label label) const;
  Label beside_margin(delaunay::TetIndex t) const;
  Label by_rule(delaunay::TetIndex t, const Raised& raised, std::vector<delaunay::SlabPoint>& losers) const;
  Label of_triangle(delaunay::TetIndex t, const Raised& raised) const;
  Label of_edges(delaunay::TetIndex t, const Raised& raised, std::vector<delaunay::SlabPoint>& losers) const;
  bool linked(delaunay::TriangleIndex lower_triangle, delaunay::TriangleIndex upper_triangle) const;
  bool knows(delaunay::SlabPoint v, Label label) const;
  bool knows_below(delaunay::SlabPoint v, delaunay::TriangleIndex upper_triangle) const;
  bool knows_above(delaunay::SlabPoint v, delaunay::TriangleIndex lower_triangle) const;

  const delaunay::SlabTetrahedra& tets_;
  const PartitionSlice& lower_;
  const PartitionSlice& upper_;
  const Materials& materials_;
  delaunay::SlabNumbers numbers_;
  Table<delaunay::TetIndex, DualTriangles> duals_;
  Table<delaunay::TriangleIndex, std::uint32_t> lower_faces_, upper_faces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links_;  // faces of one label that continue each other, sorted
  std::vector<EndingTriangle> ending_;
  std::vector<RaisedShare> ramp_;
  Table<delaunay::SlabPoint, Label> beside_;  // of each point of a ramp
};

}  // namespace odontoscope::partition
