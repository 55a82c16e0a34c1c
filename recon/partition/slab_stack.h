#pragma once
// A run of neighbouring slabs as one mesh.

#include <cstdint>
#include <span>
#include <vector>

#include "recon/mesh/meshes.h"
#include "recon/partition/partition_slab.h"

namespace odontoscope::partition {

struct SlabStack {
  TetraMesh mesh;                       // points slice by slice, then what each slab added
  std::vector<std::size_t> tetrahedra;  // those of slab k: [tetrahedra[k], tetrahedra[k + 1])
  std::vector<std::uint32_t> points;    // those of slice k: [points[k], points[k + 1])
};

/// `slabs[k]` lies between slices k and k + 1. Throws InternalError for more points than 32-bit numbers can count.
SlabStack stacked(std::span<const PartitionSlice* const> slices, std::span<const PartitionSlab* const> slabs);

}  // namespace odontoscope::partition
