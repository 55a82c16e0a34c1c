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

class SlabLabels {
 public:
  SlabLabels(const std::vector<delaunay::SlabTetrahedron>& tetrahedra, const PartitionSlice& lower,
             const PartitionSlice& upper, const Materials& materials);

  /// Triangles whose face the point above or below them knows nothing of. Such a face ends here: their corners are to
  /// be raised before anything is labelled.
  const std::vector<EndingTriangle>& ending() const { return ending_; }
  /// How far some of their corners rise.
  const std::vector<RaisedShare>& ramp() const { return ramp_; }

  /// The label of tetrahedron t. Where two edges contradict each other, the loser's ends are added to `losers`.
  Label label(std::uint32_t t, const std::vector<bool>& raised, std::vector<std::uint32_t>& losers) const;

 private:
  std::vector<EndingTriangle> ending_triangles() const;
  bool gives_way(std::uint32_t margin, Label label) const;
  Label beside_margin(std::uint32_t t) const;
  bool knows(std::uint32_t v, Label label) const;
  Label by_rule(std::uint32_t t, const std::vector<bool>& raised, std::vector<std::uint32_t>& losers) const;
  Label of_triangle(std::uint32_t t, const std::vector<bool>& raised) const;
  Label of_edges(std::uint32_t t, const std::vector<bool>& raised, std::vector<std::uint32_t>& losers) const;
  bool linked(std::uint32_t lower_triangle, std::uint32_t upper_triangle) const;
  bool knows_below(std::uint32_t point, std::uint32_t upper_triangle) const;
  bool knows_above(std::uint32_t point, std::uint32_t lower_triangle) const;

  const std::vector<delaunay::SlabTetrahedron>& tets_;
  const PartitionSlice& lower_;
  const PartitionSlice& upper_;
  const Materials& materials_;
  std::uint32_t offset_;
  std::vector<DualTriangles> duals_;
  std::vector<std::uint32_t> lower_faces_, upper_faces_;        // of each triangle
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links_;  // faces of one label that continue each other, sorted
  std::vector<EndingTriangle> ending_;
  std::vector<RaisedShare> ramp_;
  std::vector<Label> beside_;  // of each point of a ramp
};

}  // namespace odontoscope::partition
