#pragma once
// The proof, made anew on every result from nothing but the result itself and the slices.

#include "recon/delaunay/assemble.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope::delaunay {

/// Throws InternalError unless, for slab k: every tetrahedron is positive by exact test and lies between the two
/// planes; no face belongs to more than two, and two meet from opposite sides; what lies in a slice's plane is a
/// corner, a contour or internal edge, or an internal triangle of that slice.
void certify_slab(const SolvedStack& stack, const Numbering& numbering, const AssembledSlab& slab,
                  const TetraMesh& mesh, std::size_t k);

/// Throws InternalError unless slice k's internal triangles fill exactly what its contours bound, and each is a face of
/// a tetrahedron above or below it. With certify_slab of both slabs this proves that the solid cut by the plane is
/// exactly the slice's regions.
void certify_slice(const SolvedStack& stack, const Numbering& numbering, const AssembledSlab* below,
                   const AssembledSlab* above, std::size_t k);

/// Throws InternalError unless slice k, conformed, is `given` with points added on its edges only: every given point is
/// there, in order and bit by bit; added ones lie off their edge by at most the rounding of a coordinate.
void certify_contours(const ConformedSlice& conformed, const Slice& given);

/// Throws InternalError unless the report is that of a closed, oriented manifold whose shells are all closed.
void certify_surface(const SurfaceReport& report, const std::string& structure);

}  // namespace odontoscope::delaunay
