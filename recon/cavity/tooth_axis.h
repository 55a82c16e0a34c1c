#pragma once
// Which way does a tooth stand?

#include <vector>

#include "recon/cavity/cavity.h"
#include "recon/cavity/centre_lines.h"

namespace odontoscope {

struct ToothAxis {
  Direction along{0, 0, 1};  // unit, z not negative
  double tilt_deg = 0;       // from z
  bool own = false;          // not z, but the tooth's own
};

/// The principal axis of all solids of the model, of uniform density: the direction that their mass is spread most
/// along. It is taken where the model is long for its width (limits::axis_ratio) and leans enough that z would be wrong
/// (limits::axis_tilt_deg); else z, by which the tooth was cut, serves as well and keeps what is measured in its planes
/// exact. Open shells have no part in it.
ToothAxis tooth_axis(const std::vector<StructureSurface>& model);

/// A turn that takes `axis` to z, about the origin.
class Upright {
 public:
  explicit Upright(const Direction& axis);
  Point3 turned(const Point3& p) const;
  Point3 back(const Point3& p) const;
  SurfaceMesh turned(const SurfaceMesh& surface) const;
  CentreLines turned(const CentreLines& lines) const;

 private:
  Direction u_, v_, w_;
};

}  // namespace odontoscope
