#pragma once
// A sample tooth as implicit functions: negative inside, near the surface about the distance in mm.

#include <vector>

#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {

/// What depends on x and y alone, so that a stack of slices computes it once for each grid point.
struct OcclusalHeights {
  double enamel = 0;   // z of the outer surface, fissures engraved
  double dentine = 0;  // z of the enamel-dentine junction
};

OcclusalHeights occlusal_heights(const ToothShape& shape, Point2 at);

/// Outer surface of the tooth, its crown with enamel; of the dentine, equal to it below the cervical line; and the
/// height below which there is no enamel.
struct HardTissue {
  double tooth = 0, dentine = 0;
  double below_margin = 0;  // mm along z, positive below the enamel's margin
};

/// The tooth in one plane z = const; what depends on z alone is worked out once. `shape` must outlive it.
class ToothSection {
 public:
  ToothSection(const ToothShape& shape, double z);

  /// `heights` as occlusal_heights gives them for `at`.
  HardTissue hard_tissue(const OcclusalHeights& heights, Point2 at) const;
  double pulp(Point2 at) const;

 private:
  struct Ellipse {
    Point2 centre;
    double a = 0, b = 0, exponent = 2;
    double lobe_offset = 0;
    double groove = 0, groove_width = 1, wider_buccally = 0;
  };
  struct Groove {
    Side side = Side::buccal;
    double place = 0, width = 0, depth = 0;
  };

  static double root(const Ellipse& section, Point2 at);
  double crown(Point2 at) const;
  double side(Point2 at) const;
  double chamber(Point2 at) const;

  const ToothShape& shape_;
  double z_ = 0;
  double crown_share_ = 0;  // 0 among the roots, 1 in the crown
  Point2 crown_middle_, crown_half_;
  std::vector<Groove> grooves_;
  std::vector<Ellipse> roots_, canals_;
  Ellipse chamber_;
};

/// Where the cervical line lies in the direction of `at` from the tooth's axis.
double cervical_height(const ToothShape& shape, Point2 at);

/// Centre of a canal at height z.
Point3 canal_centre(const ToothShape& shape, const Canal& canal, double z);

}  // namespace odontoscope::sample
