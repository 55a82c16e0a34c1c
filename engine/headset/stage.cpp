#include "engine/headset/stage.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace odontoscope {

namespace {

constexpr glm::dvec3 vertical{0, 1, 0};

/// Occlusal up, buccal towards a person who looks along -z.
glm::dquat standing() {
  return glm::quat_cast(glm::dmat3(glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0)));
}

/// The shortest turn from one direction to another; any of them if they are opposite.
glm::dquat shortest_turn(const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  constexpr double opposite = -1 + 1e-12;
  if (cosine > opposite) return glm::normalize(glm::dquat(1 + cosine, glm::cross(from, to)));
  const glm::dvec3 other = std::abs(from.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::dquat(0, glm::normalize(glm::cross(from, other)));
}

/// The stage after a similarity of the room that takes `from` to `to`.
Stage taken(const Stage& stage, const glm::dvec3& from, const glm::dvec3& to, const glm::dquat& turn, double factor) {
  return {to + factor * (turn * (stage.place - from)), glm::normalize(turn * stage.turn), factor * stage.magnification};
}

}  // namespace

glm::dquat heading_of(const Pose& pose) {
  glm::dvec3 level = pose.ahead();
  constexpr double steep = 0.99;
  if (std::abs(level.y) > steep) level = level.y > 0 ? -pose.up() : pose.up();
  return glm::angleAxis(std::atan2(-level.x, -level.z), vertical);
}

glm::dvec3 to_room(const Stage& stage, const glm::dvec3& point_mm) {
  return stage.place + metres_per_mm * stage.magnification * (stage.turn * point_mm);
}

glm::dvec3 to_model(const Stage& stage, const glm::dvec3& place) {
  return mm_per_metre(stage) * (glm::conjugate(stage.turn) * (place - stage.place));
}

glm::dvec3 direction_to_model(const Stage& stage, const glm::dvec3& direction) {
  return glm::conjugate(stage.turn) * direction;
}

double mm_per_metre(const Stage& stage) { return 1 / (metres_per_mm * stage.magnification); }

Stage before(const Pose& head, const Model& model, double magnification, const glm::dvec3& facing) {
  constexpr double below_eyes = 0.1;
  const glm::dquat heading = heading_of(head);
  // About the tooth's axis, from buccal to `facing`.
  constexpr double steep = 1e-3;
  const double round = std::hypot(facing.x, facing.y) > steep * std::abs(facing.z) ? std::atan2(facing.x, facing.y) : 0;
  Stage stage{{}, glm::normalize(heading * standing() * glm::angleAxis(round, glm::dvec3(0, 0, 1))), magnification};
  const glm::dvec3 centre = head.position + heading * glm::dvec3(0, -below_eyes, -arms_length);
  stage.place = centre - (to_room(stage, model.bounds_mm.centre()) - stage.place);
  return stage;
}

Stage carried(const Stage& stage, const Pose& from, const Pose& to) {
  return taken(stage, from.position, to.position, to.turn * glm::conjugate(from.turn), 1);
}

Stage carried(const Stage& stage, const glm::dvec3 (&from)[2], const glm::dvec3 (&to)[2]) {
  const glm::dvec3 before = from[1] - from[0], after = to[1] - to[0];
  const double apart_before = glm::length(before), apart_after = glm::length(after);
  constexpr double least_apart = 0.01;  // metres; nearer, the trackers' noise would decide
  if (apart_before < least_apart || apart_after < least_apart) return stage;
  const double wanted =
      std::clamp(stage.magnification * apart_after / apart_before, least_magnification, most_magnification);
  return taken(stage, 0.5 * (from[0] + from[1]), 0.5 * (to[0] + to[1]),
               shortest_turn(before / apart_before, after / apart_after), wanted / stage.magnification);
}

Stage turned_about(const Stage& stage, const glm::dvec3& axis, double radians) {
  return taken(stage, axis, axis, glm::angleAxis(radians, vertical), 1);
}

Stage moved(const Stage& stage, const glm::dvec3& by) {
  Stage after = stage;
  after.place += by;
  return after;
}

Stage magnified(const Stage& stage, double magnification, const glm::dvec3& fixed) {
  return taken(stage, fixed, fixed, glm::dquat(1, 0, 0, 0), magnification / stage.magnification);
}

View view_of(const Stage& stage, const EyeView& eye, const Model& model, double nearest) {
  // The eyes are brought to the model rather than the model to the room: surfaces, lights and depths stay those of any
  // other picture.
  const glm::dvec3 place = metres_per_mm * (to_model(stage, eye.pose.position) - model.origin_mm);
  const glm::dmat3 to_eye = glm::mat3_cast(glm::normalize(glm::conjugate(eye.pose.turn) * stage.turn));
  View view;
  glm::dmat4 world_to_eye(to_eye);
  world_to_eye[3] = glm::dvec4(to_eye * -place, 1);
  view.world_to_eye = glm::mat4(world_to_eye);
  const double radius = 1.01 * metres_per_mm * model.radius_mm;
  const double far_off = glm::length(metres_per_mm * (model.bounds_mm.centre() - model.origin_mm) - place);
  const double near_plane = nearest / stage.magnification, far_plane = std::max(far_off + radius, 4 * near_plane);
  const FieldOfView& field = eye.field;
  view.eye_to_clip = glm::mat4(glm::frustum(near_plane * std::tan(field.left), near_plane * std::tan(field.right),
                                            near_plane * std::tan(field.down), near_plane * std::tan(field.up),
                                            near_plane, far_plane));
  return view;
}

}  // namespace odontoscope
