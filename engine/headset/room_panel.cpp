#include "engine/headset/room_panel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace odontoscope {

RoomPanel place_panel(const Pose& head, double side, double distance) {
  constexpr double aside_deg = 35, below_deg = 14;  // the tooth stays in sight beside it
  const double far = std::clamp(distance, least_panel_distance, panel_distance);
  const double aside = glm::radians(aside_deg) * (side < 0 ? 1 : -1), below = glm::radians(-below_deg);
  const glm::dquat towards = glm::normalize(heading_of(head) * glm::angleAxis(aside, glm::dvec3(0, 1, 0)) *
                                            glm::angleAxis(below, glm::dvec3(1, 0, 0)));
  RoomPanel panel;
  panel.pose = {head.position + towards * glm::dvec3(0, 0, -far), towards};  // its +z points back to the eyes
  panel.size *= far / panel_distance;
  return panel;
}

std::optional<PanelPlace> aimed_at(const RoomPanel& panel, const Pose& aim) {
  const glm::dquat to_panel = glm::conjugate(panel.pose.turn);
  const glm::dvec3 from = to_panel * (aim.position - panel.pose.position), along = to_panel * aim.ahead();
  constexpr double least_slope = 1e-3;
  if (from.z <= 0 || along.z > -least_slope) return std::nullopt;
  const double distance = from.z / -along.z;
  const glm::dvec3 place = from + distance * along;
  return PanelPlace{{place.x / panel.size.x + 0.5, 0.5 - place.y / panel.size.y}, distance};
}

glm::dvec3 place_of(const RoomPanel& panel, const glm::dvec2& at) {
  return panel.pose.position +
         panel.pose.turn * glm::dvec3((at.x - 0.5) * panel.size.x, (0.5 - at.y) * panel.size.y, 0);
}

bool within_sight(const RoomPanel& panel, const Pose& head) {
  constexpr double farthest = 1.3, widest_deg = 60;
  const glm::dvec3 way = panel.pose.position - head.position;
  const double distance = glm::length(way);
  if (!(distance > 0) || distance > farthest) return false;
  const bool faces = glm::dot(panel.pose.turn * glm::dvec3(0, 0, 1), way) < 0;
  return faces && glm::dot(way / distance, head.ahead()) > std::cos(glm::radians(widest_deg));
}

RoomPanel carried(const RoomPanel& panel, const Pose& from, const Pose& to) {
  const glm::dquat turn = to.turn * glm::conjugate(from.turn);
  RoomPanel after = panel;
  after.pose = {to.position + turn * (panel.pose.position - from.position), glm::normalize(turn * panel.pose.turn)};
  return after;
}

}  // namespace odontoscope
