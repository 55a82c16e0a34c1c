#pragma once
// Tetrahedra fit for simulation: the materials of a certified complex meshed anew, in elements of nearly one size and
// of decent angles.
//
// The interfaces are remeshed (remesh_interfaces.h) and filled (fill.h). What holds for every result, and is proven
// each time: all tetrahedra are positive; each face belongs to at most two, of one material or of two that share it;
// the faces between materials, and between them and the void, are exactly the remeshed interfaces; each material's
// surface has the pieces, handles and cavities that it had. So nothing gapes or overlaps. What is given up is the exact
// shape: slices are no longer cut exactly at their contours, and the report tells by how much, as a distance.
//
// Flat ends of a material stay flat, at their height. The same input gives the same bytes, on any number of threads.
//
// Not supported: a bound on the smallest angle. Where interfaces meet at a small angle (enamel's margin), elements have
// it.

#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/mesh/labelled_complex.h"
#include "recon/mesh/surface_distance.h"
#include "recon/mesh/tetra_report.h"

namespace odontoscope::elements {

struct MaterialElements {
  std::string structure;
  TetraReport shape;
  double exact_volume = 0;   // mm^3, of the complex before; shape.volume is that of the elements
  SurfaceDistance distance;  // `a_to_b`: from the remeshed surface to the exact one
};

struct Elements {
  LabelledComplex complex;
  double size = 0;  // of edges, mm, as meshed with: what was asked for, or half or a quarter of it
  std::vector<MaterialElements> materials;  // those that have tetrahedra
};

/// `size`: of edges where materials are thick enough, mm, more than 0. Precondition: `exact` is certified. Stages
/// "remesh" and "fill". UsageError if this library was built without TetGen; InputError no-elements if no size down to
/// a quarter comes to an end or keeps the topology; Cancelled; InternalError if the proof fails.
Elements make_elements(const LabelledComplex& exact, double size, const Progress& progress = {});

/// For who does not want to choose: a twelfth of the diagonal of the smallest material's box, but no more than 1/15 and
/// no less than 1/60 of that of all.
double suggested_size(const LabelledComplex& exact);

}  // namespace odontoscope::elements
