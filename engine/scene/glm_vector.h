#pragma once
// A point of recon as a vector of the engine, and back; both are millimetres.

#include <glm/vec3.hpp>

#include "recon/mesh/vector.h"

namespace odontoscope {

inline glm::dvec3 vec(const Point3& p) { return {p.x, p.y, p.z}; }
inline Point3 point(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
inline Direction direction(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace odontoscope
