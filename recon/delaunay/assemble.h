#pragma once
// Step 7: slabs meet in the regions' own triangles, so their pieces form one conforming mesh; its boundary is the
// surface.

#include <vector>

#include "recon/delaunay/solve_slab.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::delaunay {

/// One structure's stack in parts. slab k lies between slices k and k+1.
struct SolvedStack {
  std::vector<ConformedSlice> slices;
  std::vector<std::vector<SlabSolid>> slabs;
};

/// Where the points of slices and slabs stand in the assembled mesh: slice by slice, then what each slab added.
struct Numbering {
  std::vector<std::uint32_t> slice_begin;  // slices + 1 entries
  std::vector<std::uint32_t> added_begin;  // slabs + 1 entries

  explicit Numbering(const SolvedStack& stack);
  std::uint32_t points() const { return added_begin.back(); }
};

struct AssembledSlab {
  std::vector<Tetrahedron> tetrahedra;  // in the assembled numbering
  std::vector<Triangle> sides, floor,
      ceiling;  // faces with one tetrahedron: all others; those in the lower slice; in the upper
};

/// Of the slab's pieces, one after the other, in the assembled numbering.
std::vector<Tetrahedron> assembled_tetrahedra(const SolvedStack& stack, const Numbering& numbering, std::size_t slab);

AssembledSlab assemble_slab(const SolvedStack& stack, const Numbering& numbering, std::size_t slab);

struct Assembly {
  TetraMesh tetrahedra;
  SurfaceMesh surface;
};

/// `slabs[k]` from assemble_slab. All tetrahedra get `label`.
Assembly assemble(const SolvedStack& stack, const Numbering& numbering, const std::vector<AssembledSlab>& slabs,
                  Label label);

}  // namespace odontoscope::delaunay
