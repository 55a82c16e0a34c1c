#pragma once
// A point of recon as a vector of the engine; both are millimetres.

#include <glm/vec3.hpp>

#include "recon/core/geometry.h"

namespace odontoscope {

inline glm::dvec3 vec(const Point3& p) { return {p.x, p.y, p.z}; }

}  // namespace odontoscope
