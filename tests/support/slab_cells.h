#pragma once
// The tetrahedra of a solid between two neighbouring slices, counted; a part of the oracle's topological certificate.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::test {

struct SlabCells {
  using Place = std::array<double, 3>;
  std::size_t pieces = 0;  // by shared faces
  long handles = 0, bubbles = 0;
  bool manifold =
      true;  // every boundary edge of a piece in two faces, every boundary vertex with one fan; no two pieces meet
  /// Corners of the pieces' faces in the two slices' planes, with the piece; sorted, no pair twice.
  std::vector<std::pair<Place, std::size_t>> piece_at;
  /// Points in the two planes of the walls (boundary faces that lie in no plane, joined by shared edges), with the
  /// wall; likewise.
  std::vector<std::pair<Place, std::size_t>> wall_at;
};

/// One for each slab. `sorted`: slices by ascending z; no tetrahedron crosses one.
std::vector<SlabCells> cells_by_slab(const TetraMesh& mesh, const ContourStack& sorted);

}  // namespace odontoscope::test
