#pragma once
// A closed surface sliced by planes of constant z: its pieces between two planes, and the closed sections that they
// meet in.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/mesh/half_edges.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::cavity {

/// Where a plane crosses the edges of the surface, in order.
struct Section {
  std::size_t level = 0;
  std::vector<HalfEdge> edges;       // closed: each is crossed from its triangle into its mate's
  std::size_t below = 0, above = 0;  // pieces
  bool hole = false;                 // material lies around it: it is clockwise seen from +z
  bool island = false;               // material that lies in a hole
};

struct HeightPieces {
  std::vector<double> levels;            // ascending; no vertex lies in one
  std::vector<std::size_t> first_piece;  // of each triangle, and one more: triangle t has a part of
                                         // `piece_of[first_piece[t] + i]` between levels
  std::vector<std::size_t> piece_of;     // lowest_slab[t] + i - 1 and lowest_slab[t] + i
  std::vector<std::size_t> lowest_slab;  // of each triangle: how many levels lie below all of it
  std::size_t pieces = 0;
  std::vector<Section> sections;
};

/// Near `wanted` (ascending) levels, but off all vertices; those that cannot be had, or lie beyond the surface, are
/// left out. Precondition: a closed oriented manifold without self-intersections.
HeightPieces height_pieces(const SurfaceMesh& surface, const EdgeMates& edges, const std::vector<double>& wanted);

}  // namespace odontoscope::cavity
