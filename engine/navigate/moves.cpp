#include "engine/navigate/moves.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/navigate/screen.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

/// In radii of the model.
constexpr double nearest = 0.01, farthest = 40;

glm::dvec3 turned(const glm::dvec3& v, double degrees, const glm::dvec3& axis) {
  return glm::dvec3(glm::rotate(glm::dmat4(1), glm::radians(degrees), axis) * glm::dvec4(v, 0));
}

Camera turned(const Camera& camera, double degrees, const glm::dvec3& axis, const glm::dvec3& pivot) {
  Camera result = camera;
  result.position = pivot + turned(camera.position - pivot, degrees, axis);
  result.target = pivot + turned(camera.target - pivot, degrees, axis);
  result.up = glm::normalize(turned(camera.up, degrees, axis));
  return result;
}

/// How far the eye stands above the plane at right angles to `axis`; beyond 90 it hangs upside down. Exact at the
/// poles, too.
double elevation_deg(const CameraAxes& axes, const glm::dvec3& axis) {
  return glm::degrees(portable::atan2(glm::dot(axes.towards_eye, axis), glm::dot(axes.up, axis)));
}

}  // namespace

Camera orbit(const Camera& camera, const Orbit& orbit) {
  Camera result = camera;
  result.up = axes_of(camera).up;  // at right angles, so that it stays sound over the pole
  const double now = elevation_deg(axes_of(camera), orbit.axis);
  constexpr double slack_deg = 1e-3;
  const bool upright = std::abs(now) <= 90 + slack_deg;
  const double tilt = upright ? std::clamp(now + orbit.tilt_deg, -90.0, 90.0) - now : orbit.tilt_deg;
  result = turned(result, -tilt, axes_of(result).right, orbit.pivot);
  return turned(result, upright ? -orbit.turn_deg : orbit.turn_deg, orbit.axis, orbit.pivot);
}

Camera pan(const Camera& camera, const glm::dvec2& from, const glm::dvec2& to, const glm::dvec3& anchor) {
  const glm::dvec3 shift = point_at_depth_of(camera, from, anchor) - point_at_depth_of(camera, to, anchor);
  Camera result = camera;
  result.position += shift;
  result.target += shift;
  return result;
}

Camera zoom(const Camera& camera, double factor, const glm::dvec3& anchor) {
  Camera result = camera;
  result.position = anchor + (camera.position - anchor) / factor;
  result.target = anchor + (camera.target - anchor) / factor;
  result.height_mm = camera.height_mm / factor;
  return result;
}

Camera within_reach(const Camera& camera, const Model& model) {
  Camera result = camera;
  const glm::dvec3 offset = camera.position - camera.target;
  const double distance = glm::length(offset);
  const double allowed = std::clamp(distance, nearest * model.radius_mm, farthest * model.radius_mm);
  result.position = result.target + offset * (allowed / distance);
  result.height_mm = std::clamp(camera.height_mm, nearest * model.radius_mm, farthest * model.radius_mm);
  // The target may not stray: everything would be gone from the picture, and no way back be seen.
  const glm::dvec3 stray = result.target - model.bounds_mm.centre();
  const double longest = 3 * model.radius_mm;
  if (glm::length(stray) > longest) {
    const glm::dvec3 back = stray * (1 - longest / glm::length(stray));
    result.target -= back;
    result.position -= back;
  }
  return result;
}

Camera with_projection(const Camera& camera, Camera::Projection projection) {
  Camera result = camera;
  if (camera.projection == projection) return result;
  const double slope = portable::tan(glm::radians(camera.field_of_view_deg) / 2);
  result.projection = projection;
  const glm::dvec3 offset = camera.position - camera.target;
  if (projection == Camera::Projection::parallel)
    result.height_mm = 2 * slope * glm::length(offset);
  else
    result.position = camera.target + glm::normalize(offset) * (0.5 * camera.height_mm / slope);
  return result;
}

Camera centred_on(const Camera& camera, const glm::dvec3& pivot) {
  Camera result = camera;
  const CameraAxes axes = axes_of(camera);
  const glm::dvec3 offset = pivot - camera.target;
  const glm::dvec3 sideways = offset - glm::dot(offset, axes.towards_eye) * axes.towards_eye;
  result.position += sideways;
  result.target = pivot;
  if (glm::dot(result.position - pivot, axes.towards_eye) <= 0)
    result.position = pivot + axes.towards_eye * glm::length(camera.position - camera.target);
  return result;
}

}  // namespace odontoscope
