#pragma once
// The certificate of a partition, from its plain arrays and the slices alone.

#include <cstdint>
#include <span>
#include <vector>

#include "recon/mesh/labelled_complex.h"
#include "recon/partition/planar_partition.h"

namespace odontoscope::partition {

/// Tetrahedra of slab k: [tetrahedra[k], tetrahedra[k+1]); points of slice k: [points[k], points[k+1]).
struct ComplexRanges {
  std::vector<std::size_t> tetrahedra;
  std::vector<std::uint32_t> points;
};

/// Every tetrahedron of slab k is positive and lies between its slices; what lies in a slice's plane is a corner, an
/// edge or a triangle of that slice that has the tetrahedron's label; each triangle of a material has its tetrahedron.
/// Throws InternalError.
void certify_slab(std::span<const PartitionSlice* const> slices, const ComplexRanges& ranges, const TetraMesh& mesh,
                  std::size_t k);

}  // namespace odontoscope::partition
