#pragma once
// What is drawn over the picture of the model: where one is, how large things are, and the section's handle.

#include <optional>
#include <string>

#include "engine/navigate/section_handle.h"
#include "engine/ui/interface.h"
#include "engine/viewer/pointing.h"

namespace odontoscope {

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

/// A ring round a place that one was led to.
void draw_place(const ViewPane& pane, const glm::dvec3& place_mm, float scale);

/// What is under the pointer and where; and if a click is for something, `hint` says for what.
void draw_readout(const ViewPane& pane, const Pointing& pointing, const ViewerState& state, const std::string& hint,
                  const Interface& interface, float scale);

}  // namespace odontoscope
