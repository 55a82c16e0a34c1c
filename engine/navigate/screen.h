#pragma once
// Where things in the model appear in the picture, and what lies under a place of it.
//
// Places in the picture are relative: x from -aspect at the left to aspect at the right, y from -1 at the bottom to 1
// at the top, so that equal lengths are equal in both directions. Lengths in the model are the user's millimetres.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "engine/scene/camera.h"

namespace odontoscope {

/// The camera's axes, unit vectors at right angles: x to the right, y up, z towards the eye.
struct CameraAxes {
  glm::dvec3 right, up, towards_eye;
};
CameraAxes axes_of(const Camera& camera);

/// A half line from the eye (perspective) or from the plane through it (parallel). `direction` is a unit vector.
struct SightLine {
  glm::dvec3 origin{0}, direction{0, 0, -1};
};
SightLine sight_line(const Camera& camera, const glm::dvec2& place);

/// Empty for what lies behind the eye.
std::optional<glm::dvec2> place_of(const Camera& camera, const glm::dvec3& point);

/// How far `point` is from the eye along the line of sight; negative behind it.
double depth_of(const Camera& camera, const glm::dvec3& point);

/// How many mm at that depth the picture spans from its middle to its top. Precondition: depth positive if perspective.
double half_height_at(const Camera& camera, double depth);

/// Where the sight line meets the plane through `point` that faces the camera.
glm::dvec3 point_at_depth_of(const Camera& camera, const glm::dvec2& place, const glm::dvec3& point);

}  // namespace odontoscope
