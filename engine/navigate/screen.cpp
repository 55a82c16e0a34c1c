#include "engine/navigate/screen.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "recon/core/portable_math.h"

namespace odontoscope {

CameraAxes axes_of(const Camera& camera) {
  const glm::dvec3 towards_eye = glm::normalize(camera.position - camera.target);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, towards_eye));
  return {right, glm::cross(towards_eye, right), towards_eye};
}

double depth_of(const Camera& camera, const glm::dvec3& point) {
  return glm::dot(camera.position - point, axes_of(camera).towards_eye);
}

double half_height_at(const Camera& camera, double depth) {
  if (camera.projection == Camera::Projection::parallel) return 0.5 * camera.height_mm;
  return depth * portable::tan(glm::radians(camera.field_of_view_deg) / 2);
}

SightLine sight_line(const Camera& camera, const glm::dvec2& place) {
  const CameraAxes axes = axes_of(camera);
  if (camera.projection == Camera::Projection::parallel) {
    const double half = half_height_at(camera, 1);
    return {camera.position + half * (place.x * axes.right + place.y * axes.up), -axes.towards_eye};
  }
  const double half = half_height_at(camera, 1);
  return {camera.position, glm::normalize(half * (place.x * axes.right + place.y * axes.up) - axes.towards_eye)};
}

std::optional<glm::dvec2> place_of(const Camera& camera, const glm::dvec3& point) {
  const double depth = depth_of(camera, point);
  if (depth <= 0) return std::nullopt;
  const CameraAxes axes = axes_of(camera);
  const glm::dvec3 offset = point - camera.position;
  return glm::dvec2(glm::dot(offset, axes.right), glm::dot(offset, axes.up)) / half_height_at(camera, depth);
}

glm::dvec3 point_at_depth_of(const Camera& camera, const glm::dvec2& place, const glm::dvec3& point) {
  const SightLine line = sight_line(camera, place);
  const double along = -glm::dot(line.direction, axes_of(camera).towards_eye);
  return line.origin + (depth_of(camera, point) / along) * line.direction;
}

}  // namespace odontoscope
