#pragma once
// How a camera is led round a model. Each move is a pure function of camera and gesture; places in the picture are
// those of screen.h.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/scene/camera.h"

namespace odontoscope {

/// A turntable and a tilt, in degrees: `turn` leads the eye round `axis` (the model seems to turn the same way as the
/// hand that moves to the right), `tilt` lifts it. Turning never tips the model over: the eye stops above the pole.
struct Orbit {
  double turn_deg = 0, tilt_deg = 0;
  glm::dvec3 pivot{0};       // stays where it is in the picture
  glm::dvec3 axis{0, 0, 1};  // the tooth's, unit length
};
Camera orbit(const Camera& camera, const Orbit& orbit);

/// What was at `from` and as deep as `anchor` is then at `to`.
Camera pan(const Camera& camera, const glm::dvec2& from, const glm::dvec2& to, const glm::dvec3& anchor);

/// `factor` times nearer, with `anchor` staying where it is in the picture; both projections.
Camera zoom(const Camera& camera, double factor, const glm::dvec3& anchor);

/// No nearer to its target, and no farther from the model, than is of any use; wanted after every zoom.
Camera within_reach(const Camera& camera, const Model& model);

/// The other projection, with the target as large in the picture as before.
Camera with_projection(const Camera& camera, Camera::Projection projection);

/// Looks at `pivot` from where the eye is: the eye moves sideways, so that the direction of sight stays.
Camera centred_on(const Camera& camera, const glm::dvec3& pivot);

}  // namespace odontoscope
