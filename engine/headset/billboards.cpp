#include "engine/headset/billboards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/headset/section_frame.h"
#include "engine/measure/wall_thickness.h"
#include "engine/navigate/labels.h"
#include "engine/navigate/thickness_colours.h"
#include "engine/navigate/wall_depth.h"

namespace odontoscope {

namespace {

constexpr double letters_deg = 2.1;  // a billboard's height, of which capital letters take half

/// A little above the place, and nearer to the eyes than it.
glm::dvec3 beside(const glm::dvec3& place, const Pose& head) {
  constexpr double nearer = 0.96, lift_deg = 0.9;
  const glm::dvec3 way = place - head.position;
  return head.position + nearer * way + glm::dvec3(0, std::tan(glm::radians(lift_deg)) * glm::length(way), 0);
}

/// Those of the canals that can be seen from here.
std::vector<const FlightLabel*> seen_names(const Visit& visit, const std::vector<FlightLabel>& labels,
                                           const Walls& walls) {
  constexpr double nearest = 0.25, slack = 0.3, least_apart_deg = 5;  // metres, metres: names may lie on walls
  const double mm = mm_per_metre(visit.stage);
  std::vector<std::pair<double, const FlightLabel*>> by_distance;
  for (const FlightLabel& label : labels) by_distance.emplace_back(glm::length(label.at - visit.eye_mm), &label);
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const FlightLabel*> seen;
  for (const auto& [distance, label] : by_distance) {
    if (distance < nearest * mm) continue;  // one is there
    const glm::dvec3 way = (label->at - visit.eye_mm) / distance;
    if (walls.free_distance(visit.eye_mm, way, distance) < distance - slack * mm) continue;
    const bool over = std::any_of(seen.begin(), seen.end(), [&](const FlightLabel* other) {
      return glm::dot(glm::normalize(other->at - visit.eye_mm), way) > std::cos(glm::radians(least_apart_deg));
    });
    if (!over) seen.push_back(label);
  }
  return seen;
}

}  // namespace

std::vector<Billboard> billboards(const Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  std::vector<Billboard> all;
  const auto add = [&](const std::string& words, const glm::dvec3& place_mm) {
    const glm::dvec3 place = to_room(visit.stage, place_mm);
    all.push_back({words, beside(place, input.head), place});
  };
  if (visit.marks.named) add(visit.marks.named->structure, visit.marks.named->point_mm);
  if (visit.marks.ends.size() == 2)
    add(fmt::format("{:.2f} mm", distance_between_mm(visit.marks.ends[0], visit.marks.ends[1])),
        0.5 * (visit.marks.ends[0].point_mm + visit.marks.ends[1].point_mm));
  if (visit.cavity && visit.chosen.labels) {
    const FlightSpace& cavity = world.cavities[*visit.cavity];
    const std::vector<FlightLabel> labels = labels_inside(cavity);
    for (const FlightLabel* label : seen_names(visit, labels, cavity.walls)) add(label->words, label->at);
  }
  if (visit.cavity && visit.chosen.on_wall != WallNumber::none) {
    const FlightSpace& cavity = world.cavities[*visit.cavity];
    const std::vector<FlightLabel> numbers = visit.chosen.on_wall == WallNumber::depth
                                                 ? depth_labels(cavity, world.model.depth_step_mm)
                                                 : thickness_labels(cavity);
    for (const FlightLabel* label : seen_names(visit, numbers, cavity.walls)) add(label->words, label->at);
  }
  return all;
}

BillboardShape shape_of(const Billboard& billboard, const Pose& head, double aspect) {
  const glm::dvec3 to_head = head.position - billboard.at;
  const double distance = std::max(glm::length(to_head), 1e-3),
               height = 2 * distance * std::tan(glm::radians(letters_deg) / 2);
  const double heading = std::atan2(to_head.x, to_head.z),
               rise = std::atan2(to_head.y, std::hypot(to_head.x, to_head.z));
  const glm::dquat turn = glm::angleAxis(heading, glm::dvec3(0, 1, 0)) * glm::angleAxis(-rise, glm::dvec3(1, 0, 0));
  return {{billboard.at + turn * glm::dvec3(0, 0.5 * height, 0), turn}, {aspect * height, height}};
}

std::vector<glm::dvec3> room_marks(const Visit& visit, const HeadsetInput& input, const VisitWorld& world) {
  constexpr double ray = 1.5;  // metres
  std::vector<glm::dvec3> lines;
  const auto line = [&](const glm::dvec3& from, const glm::dvec3& to) { lines.insert(lines.end(), {from, to}); };
  for (std::size_t i = 0; i < input.hands.size(); ++i) {
    const HandInput& hand = input.hands[i];
    if (!hand.tracked || visit.hands.on_panel[i]) continue;
    const std::optional<Hit>& hit = visit.hands.pointed[i];
    const bool meets = hit || visit.hands.on_frame[i];
    const glm::dvec3 end = visit.hands.on_frame[i] ? *visit.hands.on_frame[i]
                           : hit                   ? to_room(visit.stage, hit->point_mm)
                                                   : hand.aim.position + ray * hand.aim.ahead();
    if (visit.hands.leap_mm[i]) {  // a star where the trigger leads, when it is let go
      constexpr double arm = 0.06;
      const glm::dvec3 there = to_room(visit.stage, *visit.hands.leap_mm[i]);
      line(hand.aim.position, there);
      for (const glm::dvec3& axis : {glm::dvec3(arm, 0, 0), glm::dvec3(0, arm, 0), glm::dvec3(0, 0, arm)})
        line(there - axis, there + axis);
      continue;
    }
    line(hand.aim.position, end);
    if (meets) line(end, end);
  }
  for (const Billboard& billboard : billboards(visit, input, world)) line(billboard.of, billboard.of);
  for (const Hit& hit : visit.marks.ends) line(to_room(visit.stage, hit.point_mm), to_room(visit.stage, hit.point_mm));
  if (visit.marks.ends.size() == 2)
    line(to_room(visit.stage, visit.marks.ends[0].point_mm), to_room(visit.stage, visit.marks.ends[1].point_mm));
  if (visit.scene.section && !visit.cavity) {
    const SectionFrame frame = section_frame(*visit.scene.section, visit.stage, world.model);
    for (std::size_t i = 0; i < frame.size(); ++i) line(frame[i], frame[(i + 1) % frame.size()]);
  }
  return lines;
}

}  // namespace odontoscope
