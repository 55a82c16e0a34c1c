#pragma once
// Interfaces of a complex with triangles fit for elements: of nearly the size and the angles that are asked for.
//
// Edges are split, collapsed and flipped, and vertices move within their surface or junction line (after M. Botsch and
// L. Kobbelt, "A remeshing approach to multiresolution modeling", 2004), here for several materials at once: lines
// where three meet stay lines and their ends stay ends (interface_web.h), and no step is taken that would turn a
// triangle over, lead it off the surface, or let it cut or touch another, by exact predicates. So every piece, handle
// and cavity of every material stays, and neighbours share their faces to the bit.

#include "recon/core/progress.h"
#include "recon/mesh/interface_web.h"

namespace odontoscope::elements {

/// `size`: of edges, mm. Precondition: the faces are the interfaces of a certified complex. Stage "remesh". One thread;
/// deterministic. Throws Cancelled.
void remesh_interfaces(InterfaceWeb& web, double size, const Progress& progress);

}  // namespace odontoscope::elements
