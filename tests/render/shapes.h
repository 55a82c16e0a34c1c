#pragma once
// Closed, outward oriented surfaces whose every pixel can be foretold. Millimetres.

#include "engine/scene/model.h"
#include "engine/scene/overlay.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::testing_support {

struct Ball {
  Point3 centre;
  double radius = 1;
  int rings = 24;  // from pole to pole; twice as many around
};
SurfaceMesh ball(const Ball& ball);

/// A ring around the z axis.
struct Ring {
  double radius = 4;  // of the circle in the middle of the tube
  double tube = 1.5;
  int around = 48, across = 24;
};
SurfaceMesh ring(const Ring& ring);

/// The twelve triangles of a box, its edges sharp.
SurfaceMesh box(const Point3& low, const Point3& high);

/// An icosahedron with each triangle in four: 80 triangles, each large in a picture.
SurfaceMesh coarse_ball(double radius);

/// Outside in: what a cavity's wall looks like.
SurfaceMesh reversed(SurfaceMesh mesh);

/// A ball with a ball-shaped void, as one solid of two parts.
Model hollow_ball_model();

/// The sample molar, coarse enough to be made in a moment. Made once, then remembered.
const Model& small_molar();
const std::vector<NamedSurface>& small_molar_surfaces();
const OverlaySource& small_molar_overlays();

/// A ring that lacks a triangle (3 boundary edges), has one the wrong way round (3 misoriented edges), and a fin on one
/// of its edges (1 non-manifold edge, 2 boundary edges).
SurfaceMesh faulty_ring();

}  // namespace odontoscope::testing_support
