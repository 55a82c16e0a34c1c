#pragma once
// Names for what one flies past: canals at their orifices, their ends, and from outside the structures. They hide
// behind walls.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/navigate/flight_spaces.h"
#include "engine/scene/camera.h"

namespace odontoscope {

/// What a number on the wall tells.
enum class WallNumber { none, depth, thickness };

struct FlightLabel {
  glm::dvec3 at{0};
  std::string words;
  std::optional<std::size_t> line;       // of rideable(): a click begins the ride
  WallNumber number = WallNumber::none;  // else no name, but how deep or thick the wall is there
};

std::vector<FlightLabel> labels_inside(const FlightSpace& space);
/// For each structure with an outer surface that can be seen: a place on it near its widest, towards the cheek.
std::vector<FlightLabel> labels_outside(const Model& model, const FlightSpaces& spaces);

struct SeenLabel {
  std::size_t label = 0;
  glm::dvec2 place{0};  // in the picture, as screen.h counts
  double distance = 0;
};
/// Those in the picture that no wall hides, nearest first. `slack` mm before a label's place a wall does not count:
/// labels may lie on walls.
std::vector<SeenLabel> seen_labels(const std::vector<FlightLabel>& labels, const Camera& camera, double aspect,
                                   const Walls& walls, double slack);

}  // namespace odontoscope
