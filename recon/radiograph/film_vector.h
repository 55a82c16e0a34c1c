#pragma once
// Reckoning with points as vectors. Inner part of the room.

#include <cmath>

#include "recon/core/geometry.h"

namespace odontoscope::radiograph {

inline Point3 plus(const Point3& a, const Point3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point3 times(double factor, const Point3& a) { return {factor * a.x, factor * a.y, factor * a.z}; }
inline double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Point3& a) { return std::sqrt(dot(a, a)); }

}  // namespace odontoscope::radiograph
