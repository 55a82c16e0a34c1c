#pragma once
// What is drawn over the picture while one flies: names, where one is, and a dark rim.

#include <optional>
#include <string>

#include "engine/ui/interface.h"
#include "engine/viewer/fly/fly_state.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// Names, and where one is: over the picture. Precondition: one flies.
void draw_flight(const FlyState& fly, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                 float scale);

/// The line whose name was clicked.
std::optional<std::size_t> label_hit(const FlyState& fly, const ViewerState& state, const ViewPane& pane,
                                     const Interface& interface, float scale, double x, double y);

/// "Sample molar › pulp chamber › canal 1".
std::string where_in_words(const FlyState& fly, const ViewerState& state);
/// "3.2 mm past the orifice, 0.64 mm wide here, 7.1 mm to the apex"; empty outdoors.
std::string measured_in_words(const FlyState& fly, const ViewerState& state);
/// The same of any place in a cavity; `place` empty: in a cavity without lines.
std::string where_in_words(const std::string& title, const FlightSpace& space, const std::optional<CanalPlace>& place);
std::string measured_in_words(const FlightSpace& space, const CanalPlace& place);

/// Clear in the middle, dark at the edges, by `strength` of [0, 1]: while the picture turns.
void draw_vignette(const Area& viewport, double strength);

}  // namespace odontoscope
