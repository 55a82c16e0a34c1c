#pragma once
// The few vector operations that measuring needs.

#include <cmath>

#include "recon/core/geometry.h"

namespace odontoscope {

struct Vector3 {
  double x = 0, y = 0, z = 0;
};

inline Vector3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3 operator+(const Vector3& u, const Vector3& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
inline Vector3 operator*(double s, const Vector3& v) { return {s * v.x, s * v.y, s * v.z}; }
inline double dot(const Vector3& u, const Vector3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
inline double length(const Vector3& v) { return std::sqrt(dot(v, v)); }
inline Vector3 cross(const Vector3& u, const Vector3& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

}  // namespace odontoscope
