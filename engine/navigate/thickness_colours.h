#pragma once
// How thick the wall is at each place of it: what colours, lines and numbers on the wall tell.
//
// From the void's wall to the nearest place on the outside of the solid that it runs in: of dentine to its outside,
// under enamel too, as `anatomy` measures thinnest walls and the page its colours.

#include <vector>

#include "engine/navigate/flight_spaces.h"
#include "engine/navigate/labels.h"
#include "engine/scene/model.h"
#include "recon/core/progress.h"

namespace odontoscope {

/// Fills in ModelPart::thicknesses_mm of cavities' walls, and of bodies that fill one (the pulp in its dentine: their
/// box lies in that of the cavity, to 1 %; of several cavities in the smallest). Other parts keep none; so do a body
/// without a solid round it, and a canal that is open at its end, whose wall is the outside. In parallel, the same on
/// any number of threads. Stage "wall thickness". Throws Cancelled.
void mark_wall_thicknesses(Model& model, const Progress& progress = {});
/// Besides, FlightSpace::thin_places: round each canal, where the wall is thinnest at every step of depth.
void mark_wall_thicknesses(Model& model, FlightSpaces& spaces, const Progress& progress = {});

bool tells_thickness(const Model& model);

/// "0.84 mm", ... where the wall is thinnest round a void's canals.
std::vector<FlightLabel> thickness_labels(const FlightSpace& space);

}  // namespace odontoscope
