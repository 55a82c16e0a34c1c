#pragma once
// What a note draws in the picture: pins and arrows.

#include <string>
#include <vector>

#include "engine/ui/interface.h"
#include "engine/viewer/notes/notes_state.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// From outside; else in that cavity, or around the tooth (null).
struct PinsSeenFrom {
  bool outside = true;
  const FlightSpace* cavity = nullptr;
};

enum class PlaceSeen { plain, behind, hidden };
/// Inside a cavity a wall hides a place, outside it pales behind what is opaque.
PlaceSeen seen_place(const ViewerState& state, const PinsSeenFrom& from, const ViewPane& pane, const glm::dvec3& at);

/// Pins, each with its label.
void draw_pins(const std::vector<LessonPin>& marks, const ViewerState& state, const PinsSeenFrom& from,
               const ViewPane& pane, const Interface& interface, float scale);

/// Arrows, each with its label where it begins. One whose head is hidden is not drawn.
void draw_arrows(const std::vector<LessonArrow>& arrows, const ViewerState& state, const PinsSeenFrom& from,
                 const ViewPane& pane, const Interface& interface, float scale);

/// One of which only the beginning is known, to where the pointer is (in pixels).
void draw_begun_arrow(const ArrowTail& tail, const ViewPane& pane, const glm::dvec2& pointer, float scale);

}  // namespace odontoscope
