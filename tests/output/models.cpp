#include "tests/output/models.h"

#include "tests/mesh/shapes.h"

namespace odontoscope::models {

Solid solid(const std::string& structure, const SurfaceMesh& surface) {
  Solid made;
  made.structure = structure;
  made.surface = surface;
  made.report = inspect(surface);
  for (Shell& shell : made.report.shells) shell.structure = structure;
  made.tetrahedra = shapes::cube_of_five();
  return made;
}

Reconstruction tooth_and_enamel() {
  Reconstruction made;
  made.solids.push_back(
      solid("tooth", shapes::together(shapes::sphere(10, 4), shapes::inside_out(shapes::sphere(3, 3)))));
  made.solids.push_back(solid("enamel", shapes::moved(shapes::torus(8, 2, 40, 20), 0.1, 0.2, 20)));
  made.counts.slices = 4;
  made.counts.contours = 9;
  made.counts.points = 812;
  made.counts.steiner_points = 17;
  made.counts.kept = 10;
  made.links = {{{"tooth", 0, 0, 1, true}, LinkCriterion::medial}, {{"enamel", 2, 3, 4, true}, LinkCriterion::user}};
  made.seconds = {{"validate", 0.5}, {"triangulate", 0.25}, {"validate", 0.5}};
  made.threads = 2;
  made.slices_checked = 4;
  made.certified = true;
  return made;
}

}  // namespace odontoscope::models
