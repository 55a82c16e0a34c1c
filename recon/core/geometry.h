#pragma once
// Plain coordinates. In `recon` they are millimetres in double precision; z runs along the tooth, right-handed.

namespace odontoscope {

struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

struct Point3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace odontoscope
