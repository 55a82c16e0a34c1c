#include "engine/navigate/transition.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/navigate/moves.h"
#include "engine/navigate/screen.h"
#include "engine/navigate/section_handle.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

glm::dquat turn_of(const Camera& camera) {
  const CameraAxes axes = axes_of(camera);
  return glm::quat_cast(glm::dmat3(axes.right, axes.up, axes.towards_eye));
}

/// Starts and ends without a jerk.
double gently(double t) { return t * t * (3 - 2 * t); }

double by_factors(double from, double to, double share) { return from * portable::pow(to / from, share); }

}  // namespace

Camera between(const Camera& start, const Camera& to, double share) {
  const Camera from = with_projection(start, to.projection);
  if (share <= 0) return from;
  if (share >= 1) return to;
  Camera camera = to;
  const glm::dmat3 axes = glm::mat3_cast(glm::slerp(turn_of(from), turn_of(to), share));
  const double distance =
      by_factors(glm::length(from.position - from.target), glm::length(to.position - to.target), share);
  camera.target = glm::mix(from.target, to.target, share);
  camera.position = camera.target + distance * axes[2];
  camera.up = axes[1];
  camera.height_mm = by_factors(from.height_mm, to.height_mm, share);
  camera.field_of_view_deg = glm::mix(from.field_of_view_deg, to.field_of_view_deg, share);
  return camera;
}

Camera Transition::advance(double seconds) {
  elapsed_ = std::min(elapsed_ + std::max(seconds, 0.0), seconds_);
  return between(from_, to_, gently(elapsed_ / seconds_));
}

Scene looks_between(const Scene& from, const Scene& to, double share, const Model& model) {
  if (share >= 1) return to;
  const auto part = static_cast<float>(std::max(share, 0.0));
  const auto mixed = [part](float a, float b) { return a + part * (b - a); };
  Scene scene = to;
  for (Look& look : scene.looks) {
    const Look* before = from.look_of(look.structure);
    if (!before) continue;
    const float goes = before->visible ? before->opacity : 0, comes = look.visible ? look.opacity : 0;
    look.visible = before->visible || look.visible;
    look.opacity = mixed(goes, comes);
    look.colour = {mixed(before->colour.red, look.colour.red), mixed(before->colour.green, look.colour.green),
                   mixed(before->colour.blue, look.colour.blue)};
  }
  if (!from.section && !to.section) return scene;
  const auto beyond = [&](const Section& section) { return with_offset(section, model.radius_mm, model); };
  const Section start = from.section ? *from.section : beyond(*to.section),
                goal = to.section ? *to.section : beyond(*from.section);
  const glm::dvec3 before = glm::normalize(start.normal), after = glm::normalize(goal.normal);
  const glm::dvec3 normal = glm::mix(before, after, share);
  constexpr double opposite = 1e-3;  // there is no way between that is better than another
  const double offset = glm::mix(offset_of(start, model), offset_of(goal, model), share);
  scene.section =
      glm::length(normal) < opposite ? goal : with_offset({goal.point_mm, glm::normalize(normal)}, offset, model);
  return scene;
}

Scene LookTransition::advance(double seconds, const Camera& camera, const Model& model) {
  elapsed_ = std::min(elapsed_ + std::max(seconds, 0.0), seconds_);
  Scene scene = looks_between(from_, to_, gently(elapsed_ / seconds_), model);
  scene.camera = camera;
  return scene;
}

}  // namespace odontoscope
