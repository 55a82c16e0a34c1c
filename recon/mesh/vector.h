#pragma once
// The few vector operations that measuring needs.

#include <cmath>

#include "recon/core/geometry.h"

namespace odontoscope {

struct Direction {
  double x = 0, y = 0, z = 0;
};

inline Direction operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Direction operator+(const Direction& u, const Direction& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
inline Direction operator*(double s, const Direction& v) { return {s * v.x, s * v.y, s * v.z}; }
inline double dot(const Direction& u, const Direction& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
inline double length(const Direction& v) { return std::sqrt(dot(v, v)); }
inline Direction cross(const Direction& u, const Direction& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

}  // namespace odontoscope
