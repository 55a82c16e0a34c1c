#pragma once
// Sections of the panel about what one looks at. They change the state's plain values at once and ask for everything
// else as actions.

#include <glm/vec3.hpp>
#include <optional>

#include "engine/ui/interface.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// The place, in mm, that somebody wants to be led to.
std::optional<glm::dvec3> report_section(const LoadedModel& shown, const Interface& interface);
/// `remembered`: what is changed here is to be so in other models, too.
void structures_section(ViewerState& state, bool remembered, const Interface& interface);
void faces_section(ViewerState& state, const Interface& interface);
void overlays_section(ViewerState& state, const Interface& interface);
void section_section(ViewerState& state, const Interface& interface);
void camera_section(ViewerState& state, const Interface& interface);

}  // namespace odontoscope
