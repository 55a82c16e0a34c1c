#pragma once
// Where in a slab's solid a piece, handle or bubble is that its contours and links do not imply. About where: a person
// is to look there.

#include <string>
#include <vector>

#include "recon/core/polygon.h"
#include "recon/delaunay/attention.h"
#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::delaunay {

struct SlabShape {
  const std::vector<Point3>& points;
  const std::vector<Tetrahedron>& tetrahedra;  // of the slab
  const std::vector<Triangle>& boundary;       // of these
  std::vector<Polygon> holes;                  // contours of the holes of both slices
};

/// The middle of, in this order: a void that is shut in; the smallest piece, if there are too many; the shortest loop
/// round a tunnel that is no hole of either slice, if there are too many handles (a tree and cotree of the boundary
/// give the loops: Erickson and Whittlesey 2005); else the smallest hole, or of all. Precondition: found differs from
/// implied; the boundary is closed and manifold.
Point3 place_of_difference(const SlabShape& slab, const Topology& implied, const Topology& found);

/// Contours of a structure's holes in the two slices of a slab. Precondition: the stack is ordered.
std::vector<Polygon> holes_beside(const ContourStack& stack, std::size_t slab, const std::string& structure);

/// Volume and centre of mass.
struct Mass {
  double volume = 0;
  Point3 centre;
};
Mass mass_of(const std::vector<Point3>& points, const std::vector<Tetrahedron>& tetrahedra);

}  // namespace odontoscope::delaunay
