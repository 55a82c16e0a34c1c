#pragma once
// Digital topology of a voxel's neighbourhood: material joined by faces (6), void by faces, edges and corners (26).
// Inner part of joined.h.
//
// G. Bertrand, "Simple points, topological numbers and geodesic neighborhoods in cubic grids", Pattern Recognition
// Letters 15 (1994): a voxel may change sides without changing the topology just if both numbers are 1.

#include <array>
#include <cstdint>

namespace odontoscope::between {

/// Which of a voxel's neighbours are material: bit (dx + 1) + 3 (dy + 1) + 9 (dz + 1). The voxel's own bit says
/// nothing.
using Neighbourhood = std::uint32_t;

struct LocalPieces {
  /// Pieces of material that touch the voxel with a face, joined within its neighbours by faces and edges.
  int material = 0;
  /// Pieces of void among its 26 neighbours.
  int voids = 0;
  /// The first of each as bits; only those that touch it with a face for material.
  std::array<Neighbourhood, 4> material_bits{}, void_bits{};

  bool simple() const { return material == 1 && voids == 1; }
};

LocalPieces local_pieces(Neighbourhood material);

/// Would two void voxels of these, the voxel itself counted as it is in `material`, meet in a corner alone, with
/// nothing but material around that corner? Contours traced from layers cannot join those.
bool corner_contact(Neighbourhood material);

}  // namespace odontoscope::between
