#pragma once
// A panel that stands in the room, never on the head: where it is put, and what a hand's ray meets of it. Lengths are
// metres of the room.

#include <glm/vec2.hpp>
#include <optional>

#include "engine/headset/pose.h"

namespace odontoscope {

struct RoomPanel {
  Pose pose;  // of its middle; it is read from where its +z points to, with +x to the right
  glm::dvec2 size{0.44, 0.46};
  friend bool operator==(const RoomPanel&, const RoomPanel&) = default;
};

/// From the eyes, where nothing is in the way; nearer, it is smaller in proportion, but never so near that the eyes
/// would have to squint.
inline constexpr double panel_distance = 0.62, least_panel_distance = 0.42;

/// At the head's left (`side` -1) or right (1), beside what stands before the person, somewhat below the eyes and
/// tilted towards them.
RoomPanel place_panel(const Pose& head, double side, double distance = panel_distance);

/// Where a ray meets the panel's plane: from the upper left corner, 0 to 1 on the panel and beyond that beside it.
/// Empty from behind, or along it.
struct PanelPlace {
  glm::dvec2 at{0};
  double distance = 0;
  bool on_it() const { return at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1; }
};
std::optional<PanelPlace> aimed_at(const RoomPanel& panel, const Pose& aim);

/// The place of the room at `at`.
glm::dvec3 place_of(const RoomPanel& panel, const glm::dvec2& at);

/// Could the person read it without turning much or walking?
bool within_sight(const RoomPanel& panel, const Pose& head);

/// As the hand went that holds it.
RoomPanel carried(const RoomPanel& panel, const Pose& from, const Pose& to);

}  // namespace odontoscope
