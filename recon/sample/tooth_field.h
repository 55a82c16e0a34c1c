#pragma once
// A sample tooth as implicit functions: negative inside, near the surface about the distance in mm.

#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {

/// What depends on x and y alone, so that a stack of slices computes it once for each grid point.
struct OcclusalHeights {
  double enamel = 0;    // z of the outer surface, fissures engraved
  double dentine = 0;   // z of the enamel-dentine junction
};

OcclusalHeights occlusal_heights(const ToothShape& shape, Point2 at);

/// Outer surface of the tooth, its crown with enamel; and of the dentine, equal to it below the cervical line.
struct HardTissue {
  double tooth = 0, dentine = 0;
};
HardTissue hard_tissue(const ToothShape& shape, const OcclusalHeights& heights, const Point3& at);

double pulp(const ToothShape& shape, const Point3& at);

/// Where the cervical line lies in the direction of `at` from the crown's middle.
double cervical_height(const ToothShape& shape, Point2 at);

/// Centre of a canal at height z.
Point3 canal_centre(const ToothShape& shape, const Canal& canal, double z);

/// Factor by which the section of a rounded end has shrunk `above` mm above its tip: 0 to 1 over `length`.
double blunt_end(double above, double length);

}  // namespace odontoscope::sample
