#pragma once
// How high the faces that end in a slab rise, where they end along their length: enamel's margin runs out beside the
// dentine in one slice here and in the next one there. Inner part of partition_slab.h.
//
// Where both meet the void is the margin's place in a slice, so in the slab it leads from such a point of one slice to
// the next one of the other. What ends between the two rises on its outside by its share of that way, and on its inside
// as little as usual: the margin slopes, and is a knife's edge and no step a slab high.

#include <vector>

#include "recon/delaunay/predicates.h"
#include "recon/delaunay/slab.h"
#include "recon/partition/planar_partition.h"

namespace odontoscope::partition {

/// A triangle of a slice whose face ends in the slab.
struct EndingTriangle {
  delaunay::Side slice = delaunay::Side::lower;
  delaunay::TriangleIndex triangle;
};

/// Of a slab's point (the lower slice's first), how far it is to be raised off its slice, over the slab's height (0: as
/// usual), and what its face ends beside.
struct RaisedShare {
  delaunay::SlabPoint point;
  double share = 0;
  Label beside = void_label;
};

/// For corners of ending triangles of what the structure beside it wins over, each once, ascending; none of faces that
/// end in another way. Shares lie in [0, limits::ramp_most].
std::vector<RaisedShare> margin_ramp(const PartitionSlice& lower, const PartitionSlice& upper,
                                     const Materials& materials, const std::vector<EndingTriangle>& ending);

}  // namespace odontoscope::partition
