#pragma once
// What is seen by somebody who is in a cavity.

#include "engine/navigate/flight_spaces.h"
#include "engine/scene/scene.h"

namespace odontoscope {

/// As `scene`: the cavity's wall and nothing else, whole and opaque, by a lamp at the forehead.
Scene seen_from_inside(const Scene& scene, const Model& model, const FlightSpace& space);

}  // namespace odontoscope
