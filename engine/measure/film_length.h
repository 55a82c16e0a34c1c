#pragma once
// How long a line is on an X-ray film, beside how long it is: a film shows what lies square to the rays; what leans
// towards the tube or away from it is shorter, what is nearer to the tube larger.

#include <glm/vec3.hpp>
#include <span>

#include "engine/scene/camera.h"

namespace odontoscope {

/// Of points in mm, as the camera's rays throw them onto a film through `centre`, square to where the camera looks, so
/// that what lies there has its own size. Points behind the eye have no shadow and are left out.
double length_on_film(std::span<const glm::dvec3> points, const Camera& camera, const glm::dvec3& centre);

/// Of the line itself.
double length_of(std::span<const glm::dvec3> points);

}  // namespace odontoscope
