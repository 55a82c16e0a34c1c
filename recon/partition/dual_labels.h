#pragma once
// In which faces of the two slices the dual point of each tetrahedron of a slab lies.

#include <vector>

#include "recon/delaunay/slab.h"
#include "recon/partition/planar_partition.h"

namespace odontoscope::partition {

struct DualLabels {
  Label lower = void_label, upper = void_label;
};

/// `tetrahedra` from delaunay::bare_slab of the two slices' triangulations. Exact where borders are Gabriel; where they are only Delaunay, a label may
/// be that of the other side of a gap.
std::vector<DualLabels> dual_labels(const std::vector<delaunay::SlabTetrahedron>& tetrahedra, const PartitionSlice& lower,
                                    const PartitionSlice& upper);

/// The labels on both sides of the edge from a to b, seen from +z.
struct EdgeSides {
  Label left = void_label, right = void_label;
  bool border() const { return left != right; }
  bool has(Label label) const { return left == label || right == label; }
};
EdgeSides sides_of(const PartitionSlice& slice, std::uint32_t a, std::uint32_t b);

}  // namespace odontoscope::partition
