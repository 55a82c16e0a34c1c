#pragma once
// What is drawn over the picture while one flies: the fade, the vignette, and where one is.

#include <optional>
#include <string>

#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

/// Slower and faster than usual, at most.
inline constexpr double least_speed_factor = 0.2, most_speed_factor = 8;

/// Names, and where one is: over the picture. Precondition: one flies.
void draw_flight(const ViewerState& state, const ViewPane& pane, const Interface& interface, float scale);

/// The line whose name was clicked.
std::optional<std::size_t> label_hit(const ViewerState& state, const ViewPane& pane, const Interface& interface,
                                     float scale, double x, double y);

/// Where the tooth is shown small, and how; an empty area where the picture is too small for it.
Area where_area(const ViewPane& pane, float scale);
Camera where_camera(const Model& model, NamedView from, const Area& area);

/// "Sample molar › pulp chamber › canal 1".
std::string where_in_words(const ViewerState& state);
/// "3.2 mm past the orifice, 0.64 mm wide here, 7.1 mm to the apex"; empty outdoors.
std::string measured_in_words(const ViewerState& state);
/// The same of any place in a cavity; `place` empty: in a cavity without lines.
std::string where_in_words(const std::string& title, const FlightSpace& space, const std::optional<CanalPlace>& place);
std::string measured_in_words(const FlightSpace& space, const CanalPlace& place);

/// Darkens the picture for passages, and its rim while it turns if that is wanted.
void draw_fade(const ViewerState& state, const Area& viewport);

}  // namespace odontoscope
