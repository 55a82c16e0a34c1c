#pragma once
// Fewer triangles for the interfaces of a labelled complex: what two materials share is simplified once and stays
// shared.
//
// Edges are collapsed in order of their error in volume without memory of the original (collapse_quadric.h); edges of
// junction lines (where three materials meet, one of them void maybe) along the line only. A collapse is refused that
// would change the topology of any material or of their neighbourhood (interface_web.h), turn a triangle over, go
// astray, or make a triangle that cuts or touches any other, by exact predicates. So neighbours share their faces to
// the bit, nothing gapes or overlaps, and every piece, handle and cavity stays.

#include "recon/core/progress.h"
#include "recon/mesh/labelled_complex.h"
#include "recon/mesh/simplify_surface.h"

namespace odontoscope {

struct SimplifiedInterfaces {
  LabelledComplex complex;    // points and interfaces; no tetrahedra
  std::size_t triangles = 0;  // of the surfaces of all materials: what two share counts twice
  bool reached = true;
  SimplifiedSurfaces::Obstacles obstacles;  // if not reached
  /// Times that the work began anew, since a thin piece had been turned inside out, and points that were kept in place
  /// for it.
  std::size_t restarts = 0, kept_vertices = 0;
};

/// At most `triangles` in the surfaces of all materials, or as few as the refusals above allow. Precondition:
/// `interfaces` are those of a complex that was certified. One thread; deterministic. Stage "simplify". Throws
/// Cancelled; InternalError if two faces of the result meet where they should not.
SimplifiedInterfaces simplify_interfaces(const LabelledComplex& complex, std::size_t triangles,
                                         const Progress& progress = {});

}  // namespace odontoscope
