#pragma once
// How the model stands in the room: where, turned how, enlarged how much. Moves are pure functions.
//
// Everything that looks like moving the person (gliding, turning, being inside) moves the stage instead: the runtime
// owns the head, and nothing may come between.

#include "engine/headset/pose.h"
#include "engine/scene/camera.h"
#include "engine/scene/model.h"

namespace odontoscope {

struct Stage {
  glm::dvec3 place{0};          // of the model's zero point, metres in the room
  glm::dquat turn{1, 0, 0, 0};  // of the model's axes into the room's
  double magnification = 1;     // 1: true size
  friend bool operator==(const Stage&, const Stage&) = default;
};

inline constexpr double usual_magnification = 25;
/// By hand; inside, rooms are larger still.
inline constexpr double least_magnification = 0.5, most_magnification = 400;
/// From the eyes to the model's centre when it is put before a person.
inline constexpr double arms_length = 0.7;

glm::dvec3 to_room(const Stage& stage, const glm::dvec3& point_mm);
glm::dvec3 to_model(const Stage& stage, const glm::dvec3& place);
/// A direction keeps its length.
glm::dvec3 direction_to_model(const Stage& stage, const glm::dvec3& direction);
/// How many millimetres of the model a metre of the room is.
double mm_per_metre(const Stage& stage);

/// Upright before the head, at arm's length and somewhat below the eyes. The side that `facing` (a direction of the
/// model) points to is towards them; from straight above or below it is the buccal one.
Stage before(const Pose& head, const Model& model, double magnification = usual_magnification,
             const glm::dvec3& facing = {0, 1, 0});

/// As the hand went that holds it.
Stage carried(const Stage& stage, const Pose& from, const Pose& to);
/// As two hands went that hold it: what is between them follows their middle, their line and their distance, within the
/// limits of magnification. Hands in one place leave the stage as it is.
Stage carried(const Stage& stage, const glm::dvec3 (&from)[2], const glm::dvec3 (&to)[2]);

/// About the vertical through `axis`; positive is counter-clockwise seen from above.
Stage turned_about(const Stage& stage, const glm::dvec3& axis, double radians);
Stage moved(const Stage& stage, const glm::dvec3& by);
/// With `fixed` (a place in the room) staying where it is.
Stage magnified(const Stage& stage, double magnification, const glm::dvec3& fixed);

/// What the eye sees of the model from `nearest` metres of the room on. Precondition: the field of view is less than
/// half a turn and not empty.
View view_of(const Stage& stage, const EyeView& eye, const Model& model, double nearest = 0.02);

}  // namespace odontoscope
