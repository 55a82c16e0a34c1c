#pragma once
// What is drawn over the picture of the model: where one is, how large things are, and the section's handle.

#include <optional>

#include "engine/navigate/section_handle.h"
#include "engine/ui/interface.h"
#include "engine/ui/viewer_state.h"

namespace odontoscope {

/// From pixels of the picture to the places of navigate/screen.h in the pane, and back.
glm::dvec2 place_in(const Area& area, double x, double y);
glm::dvec2 pixel_of(const Area& area, const glm::dvec2& place);

/// The arrow's length, as screen.h counts.
double handle_reach(const Area& area, float scale);
/// How far from its middle a mark is still hit.
double handle_tolerance(const Area& area, float scale);

/// Which of the compass's six names is at this pixel.
std::optional<Action> compass_hit(const ViewPane& pane, float scale, double x, double y);
/// With the side that one looks from in words; in flight, with where one looks to.
void draw_compass(const ViewPane& pane, const Interface& interface, float scale, std::optional<Action> hovered,
                  bool in_flight);

/// A length of 1, 2 or 5 times a power of ten, in mm or the unit that suits. Length in pixels is at the depth of the
/// camera's target.
struct ScaleBar {
  double pixels = 0;
  std::string words;
};
ScaleBar scale_bar(const ViewPane& pane, double most_pixels);
void draw_scale_bar(const ViewPane& pane, const Interface& interface, float scale);

void draw_section_handle(const ViewPane& pane, const Section& section, float scale, std::optional<SectionGrip> lit);

/// Points, lines and lengths that were measured.
void draw_measured(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale);

/// A ring round a place that one was led to.
void draw_place(const ViewPane& pane, const glm::dvec3& place_mm, float scale);

/// The canal that was clicked from outside: its line over the picture, its name, and how to get in.
void draw_canal(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale);
/// "mesiobuccal canal", or "pulp chamber" before its orifice.
std::string name_of(const CanalPick& pick, const FlightSpaces& spaces);

/// What is under the pointer and where, or what to click next.
void draw_readout(const ViewPane& pane, const ViewerState& state, const Interface& interface, float scale);

}  // namespace odontoscope
