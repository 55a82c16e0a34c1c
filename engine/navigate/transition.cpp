#include "engine/navigate/transition.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/navigate/moves.h"
#include "engine/navigate/screen.h"

namespace odontoscope {

namespace {

glm::dquat turn_of(const Camera& camera) {
  const CameraAxes axes = axes_of(camera);
  return glm::quat_cast(glm::dmat3(axes.right, axes.up, axes.towards_eye));
}

double by_factors(double from, double to, double share) { return from * std::pow(to / from, share); }

}  // namespace

Camera between(const Camera& start, const Camera& to, double share) {
  const Camera from = with_projection(start, to.projection);
  if (share <= 0) return from;
  if (share >= 1) return to;
  Camera camera = to;
  const glm::dmat3 axes = glm::mat3_cast(glm::slerp(turn_of(from), turn_of(to), share));
  const double distance = by_factors(glm::length(from.position - from.target), glm::length(to.position - to.target), share);
  camera.target = glm::mix(from.target, to.target, share);
  camera.position = camera.target + distance * axes[2];
  camera.up = axes[1];
  camera.height_mm = by_factors(from.height_mm, to.height_mm, share);
  camera.field_of_view_deg = glm::mix(from.field_of_view_deg, to.field_of_view_deg, share);
  return camera;
}

Camera Transition::advance(double seconds) {
  elapsed_ = std::min(elapsed_ + std::max(seconds, 0.0), transition_seconds);
  const double t = elapsed_ / transition_seconds;
  return between(from_, to_, t * t * (3 - 2 * t));
}

}  // namespace odontoscope
