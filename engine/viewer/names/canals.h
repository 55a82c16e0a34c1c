#pragma once
// Canals pointed at in a picture: through what is translucent, in a section, or on a small picture of the tooth.

#include <optional>
#include <string>

#include "engine/navigate/canal_pick.h"
#include "engine/navigate/screen.h"
#include "engine/ui/area.h"
#include "engine/viewer/loading.h"

namespace odontoscope {

/// How far beside a canal a pixel still means it.
double canal_slack_mm(const Camera& camera, const Area& area, float scale);

/// From before all of the model: a parallel camera sees what lies behind its own place, too.
SightLine from_before(SightLine sight, const Camera& camera, const Model& model);

/// "mesiobuccal canal", or "pulp chamber" before its orifice.
std::string name_of(const CanalPick& pick, const FlightSpaces& spaces);

/// What fills the cavity, if a structure of the model does; else the cavity itself.
std::string pulp_of(const LoadedModel& shown, std::size_t cavity);

}  // namespace odontoscope
