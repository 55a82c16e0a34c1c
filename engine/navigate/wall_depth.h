#pragma once
// How deep each place of a canal's wall lies below the canal's orifice: what rings and colours on the wall tell.

#include <vector>

#include "engine/navigate/flight_spaces.h"
#include "engine/navigate/labels.h"
#include "engine/scene/model.h"

namespace odontoscope {

/// What walls a void in, and the void's lines.
struct LinedWall {
  const std::string* structure = nullptr;
  const CentreLines* lines = nullptr;
};

/// From ring to ring, so that there are at most 25: 1 mm in a tooth of usual size, 5, 10, 50, ... in one that is
/// measured in voxels.
double depth_step_mm(double deepest_mm);

/// Fills in Model::depth_step_mm, and ModelPart::depths_mm of these parts: the length along the nearest centre line
/// from its orifice (of a tube without a chamber, from its beginning) to the place that is nearest to the vertex;
/// `above_orifice` beside the chamber and beside horns. Other parts keep theirs.
void mark_wall_depths(Model& model, const std::vector<LinedWall>& walls);
void mark_wall_depths(Model& model, const FlightSpaces& spaces);

/// "1 mm", "2 mm", ... on the walls of a void's canals, where the rings run. What canals have in common has one label.
std::vector<FlightLabel> depth_labels(const FlightSpace& space, double step_mm);

}  // namespace odontoscope
