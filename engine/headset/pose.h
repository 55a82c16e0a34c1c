#pragma once
// Places and turns in the room in which a headset is worn: metres, right-handed, y up; an eye or a hand looks along -z,
// as OpenXR has it.

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace odontoscope {

struct Pose {
  glm::dvec3 position{0};
  glm::dquat turn{1, 0, 0, 0};  // unit length

  glm::dvec3 ahead() const { return turn * glm::dvec3(0, 0, -1); }
  glm::dvec3 up() const { return turn * glm::dvec3(0, 1, 0); }
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// From the line of sight to the picture's edges in radians; `left` and `down` are usually negative, and `left` need
/// not be -`right`.
struct FieldOfView {
  double left = -0.8, right = 0.8, down = -0.8, up = 0.8;
};

struct EyeView {
  Pose pose;
  FieldOfView field;
};

/// The turn about the room's vertical that looks the same way; looking straight up or down it is the one of `pose`'s
/// upper side.
glm::dquat heading_of(const Pose& pose);

}  // namespace odontoscope
