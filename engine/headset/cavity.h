#pragma once
// The voids of a model that a person can be in.

#include <string>
#include <vector>

#include "engine/navigate/walls.h"
#include "engine/scene/scene.h"

namespace odontoscope {

struct VisitedCavity {
  std::string structure;       // whose part is the wall
  bool filled = false;         // the part is the body that fills the void; its wall is seen when it is turned inside out
  Walls walls;
  glm::dvec3 middle{0};        // its roomiest place, mm
  double room_mm = 0;          // from there to the nearest wall
};

/// Walls that face a void, and structures whose box lies within that of another, such as a pulp. Largest room first. Takes about a second for 100,000
/// triangles: not for a frame's thread.
std::vector<VisitedCavity> cavities_of(const Model& model);

/// As `scene`, seen from inside the cavity: its wall and nothing else, whole and opaque.
Scene seen_from_inside(const Scene& scene, const Model& model, const VisitedCavity& cavity);

}  // namespace odontoscope
