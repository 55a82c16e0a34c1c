#pragma once
// The space between two planar partitions, filled with labelled tetrahedra that meet both exactly.
//
// One Delaunay triangulation of both slices' points. Each tetrahedron gets the label of the faces in which its dual
// point lies, if both slices say the same; else whatever the edges and triangles in the slices claim: a triangle, or an
// edge within a face, claims its tetrahedra for its label, a border admits either of its two. Where claims contradict
// each other, points are *raised*: moved straight off their slice, with the slice's own triangles thickened below them,
// so that the face that lies there is closed over at once and claims nothing above. The triangulation's signs do not
// depend on the slab's height, so it stays positive if all points of a slice are raised; where only some are, exact
// tests tell which others must follow.
//
// What is then singular (VertexLink) is mended by relabelling the fewest tetrahedra, and where that does not settle by
// giving a whole neighbourhood one label, twice as far each time; one label for all is always regular, so this ends.

#include <array>
#include <cstdint>
#include <vector>

#include "recon/core/error.h"
#include "recon/core/progress.h"
#include "recon/partition/planar_partition.h"

namespace odontoscope::partition {

/// Points: the lower slice's, the upper slice's, then `added`.
struct PartitionSlab {
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;  // positive, none of void
  std::vector<Label> labels;
  std::vector<Point3> added;   // raised points
  std::size_t relabelled = 0;  // tetrahedra whose label was changed to mend what was singular
  std::size_t patches = 0;     // neighbourhoods that got one label
  bool cut = false;            // a slice is not conforming: every face ends just off its slice, and between is void
};

/// At both slices each face is met by tetrahedra of its own label only, so what lies beyond the slice does not matter.
/// Throws InputError slices-too-close if points must be raised and no doubles lie between the slices; `place` names the
/// slab.
PartitionSlab solve_partition_slab(const PartitionSlice& lower, const PartitionSlice& upper, const Materials& materials,
                                   const Place& place, const Progress& progress);

}  // namespace odontoscope::partition
