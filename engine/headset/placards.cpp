#include "engine/headset/placards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/measure/wall_thickness.h"

namespace odontoscope {

namespace {

constexpr double letters_deg = 2.1;   // a placard's height, of which capital letters take half

/// A little above the place, and nearer to the eyes than it.
glm::dvec3 beside(const glm::dvec3& place, const Pose& head) {
  constexpr double nearer = 0.96, lift_deg = 0.9;
  const glm::dvec3 way = place - head.position;
  return head.position + nearer * way + glm::dvec3(0, std::tan(glm::radians(lift_deg)) * glm::length(way), 0);
}

}  // namespace

std::vector<Placard> placards(const Visit& visit, const HeadsetInput& input, const VisitWorld&) {
  std::vector<Placard> all;
  const auto add = [&](const std::string& words, const glm::dvec3& place_mm) {
    const glm::dvec3 place = to_room(visit.stage, place_mm);
    all.push_back({words, beside(place, input.head), place});
  };
  if (visit.named) add(visit.named->structure, visit.named->point_mm);
  if (visit.ends.size() == 2) add(fmt::format("{:.2f} mm", distance_between_mm(visit.ends[0], visit.ends[1])), 0.5 * (visit.ends[0].point_mm + visit.ends[1].point_mm));
  return all;
}

PlacardShape shape_of(const Placard& placard, const Pose& head, double aspect) {
  const glm::dvec3 to_head = head.position - placard.at;
  const double distance = std::max(glm::length(to_head), 1e-3), height = 2 * distance * std::tan(glm::radians(letters_deg) / 2);
  const double heading = std::atan2(to_head.x, to_head.z), rise = std::atan2(to_head.y, std::hypot(to_head.x, to_head.z));
  const glm::dquat turn = glm::angleAxis(heading, glm::dvec3(0, 1, 0)) * glm::angleAxis(-rise, glm::dvec3(1, 0, 0));
  return {{placard.at + turn * glm::dvec3(0, 0.5 * height, 0), turn}, {aspect * height, height}};
}

std::vector<glm::dvec3> room_marks(const Visit& visit, const HeadsetInput& input) {
  constexpr double ray = 1.5;   // metres
  std::vector<glm::dvec3> lines;
  const auto line = [&](const glm::dvec3& from, const glm::dvec3& to) { lines.insert(lines.end(), {from, to}); };
  for (std::size_t i = 0; i < input.hands.size(); ++i) {
    const HandInput& hand = input.hands[i];
    if (!hand.tracked || visit.on_panel[i]) continue;
    const std::optional<Hit>& hit = visit.pointed[i];
    const glm::dvec3 end = hit ? to_room(visit.stage, hit->point_mm) : hand.aim.position + ray * hand.aim.ahead();
    line(hand.aim.position, end);
    if (hit) line(end, end);
  }
  for (const Hit& hit : visit.ends) line(to_room(visit.stage, hit.point_mm), to_room(visit.stage, hit.point_mm));
  if (visit.ends.size() == 2) line(to_room(visit.stage, visit.ends[0].point_mm), to_room(visit.stage, visit.ends[1].point_mm));
  if (visit.named) line(to_room(visit.stage, visit.named->point_mm), to_room(visit.stage, visit.named->point_mm));
  return lines;
}

}  // namespace odontoscope
