#pragma once
// Models to visit, and a person who visits them by script.

#include "engine/headset/visit.h"

namespace odontoscope::testing_support {

/// A ball in a ball: a "pulp" of radius 2 in a translucent "dentine" of radius 5, both round (1, 2, 30), in mm.
struct BallWorld {
  BallWorld();
  static const BallWorld& once();
  Model model;
  Pickable pickable;
  Scene scene;
  std::vector<FlightSpace> cavities;
  VisitWorld world() const { return {model, pickable, scene, cavities}; }
};

/// A coarse molar with its canals. Made once: finding its centre lines takes a second.
struct MolarWorld {
  static const MolarWorld& once();
  const Model& model;
  Pickable pickable;
  Scene scene;
  std::vector<FlightSpace> cavities;
  VisitWorld world() const { return {model, pickable, scene, cavities}; }
};

/// A person who stands and looks along -z, whose hands are there, with the system's focus.
HeadsetInput person();

/// A hand that points at a place of the room.
HandInput pointing_at(const glm::dvec3& place, const glm::dvec3& from);

/// An eye's field of view as headsets have it: wider towards the temple.
FieldOfView lopsided(bool left);

/// Both eyes of a head, so far apart.
std::vector<EyeView> eyes_of(const Pose& head, double apart = 0.064);

}  // namespace odontoscope::testing_support
