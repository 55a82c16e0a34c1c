#pragma once
// What the solid between two slices must be like as far as contours and links say, and what it is like.
//
// Regions of material and of void of both slices, joined by links, are two graphs. The simplest solid that joins what
// is linked, once, and nothing else, has as many pieces as the graph of material has components, no bubbles, and as
// many handles as
//     holes of its regions + independent cycles of the graph of material - components of the graph of void that do not
//     reach the outside.
// (Alexander duality; a ring over a ring, holes linked: 2 + 0 - 1 = 1, a solid torus. A hole that ends blind: 1 + 0 - 1
// = 0.)

#include <cstdint>
#include <utility>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::delaunay {

/// How the regions and the voids of a slice lie in each other. Void 0 is the outside.
struct Nesting {
  std::vector<std::uint32_t> around;  // of each region: the void that it lies in
  std::vector<std::uint32_t> owner;   // of each void: the region whose hole it is; none for the outside
};

using RegionPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // (lower, upper)

struct SlabLinks {
  RegionPairs material, voids;                     // each linked pair once
  std::vector<bool> lower_in, upper_in;            // of each region: does it carry a piece that its links make?
  std::size_t lower_plates = 0, upper_plates = 0;  // regions that are linked to nothing and carry a plate here ...
  std::size_t plate_holes = 0;                     // ... and the holes of these
};

/// By the formula above. Regions that carry nothing do not part the void; a plate never closes over its holes.
Topology implied_topology(const Nesting& lower, const Nesting& upper, const SlabLinks& links);

/// Numbers of a slab's points in an assembled mesh: those of its two slices, and those that it added.
struct PointRanges {
  std::uint32_t first = 0, end = 0, first_added = 0, end_added = 0;
};

/// Of a solid by its tetrahedra and its boundary, counted. Precondition: a manifold with boundary.
Topology counted_topology(const std::vector<Tetrahedron>& tetrahedra, const std::vector<Triangle>& boundary,
                          const PointRanges& points);

/// The same of any set of tetrahedra, slower: what is left of a slab that was trimmed may meet itself in a point or an
/// edge. Pieces are joined by faces, each counted for itself (V - E + F - T); a piece's boundary by its edges.
/// `boundary`: the faces with one tetrahedron.
Topology counted_topology_of_pinched(const std::vector<Tetrahedron>& tetrahedra, const std::vector<Triangle>& boundary);

}  // namespace odontoscope::delaunay
