#include "engine/navigate/section_handle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

constexpr int outline_points = 48;
constexpr double disc_share = 0.62;  // of the arrow's length

/// mm that are `reach` long in the picture, at the plane's point.
double length_there(const Section& section, const Camera& camera, double reach) {
  return reach * half_height_at(camera, depth_of(camera, section.point_mm));
}

/// The point of the ball around `centre` under the place, on its near half, or the outline's nearest.
glm::dvec3 on_ball(const Camera& camera, const glm::dvec2& place, const glm::dvec3& centre, double radius,
                   bool near_half) {
  const SightLine line = sight_line(camera, place);
  const double along = glm::dot(centre - line.origin, line.direction);
  const glm::dvec3 nearest = line.origin + along * line.direction;
  const double gap = glm::length(nearest - centre);
  if (gap >= radius) return glm::normalize(nearest - centre);
  const double half_chord = std::sqrt(radius * radius - gap * gap);
  return glm::normalize(nearest + (near_half ? -half_chord : half_chord) * line.direction - centre);
}

}  // namespace

double offset_of(const Section& section, const Model& model) {
  return glm::dot(glm::normalize(section.normal), section.point_mm - model.bounds_mm.centre());
}

Section with_offset(const Section& section, double offset_mm, const Model& model) {
  const glm::dvec3 normal = glm::normalize(section.normal);
  const double most = 0.98 * model.radius_mm;
  return {model.bounds_mm.centre() + std::clamp(offset_mm, -most, most) * normal, normal};
}

std::optional<SectionHandle> section_handle(const Section& section, const Camera& camera, double reach) {
  const auto knob = place_of(camera, section.point_mm);
  if (!knob) return std::nullopt;
  const double length = length_there(section, camera, reach);
  const glm::dvec3 normal = glm::normalize(section.normal);
  const auto tip = place_of(camera, section.point_mm + length * normal);
  if (!tip) return std::nullopt;
  SectionHandle handle{*knob, *tip, {}, glm::dot(normal, axes_of(camera).towards_eye) >= 0};
  const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(other, normal)), along = glm::cross(normal, across);
  for (int i = 0; i < outline_points; ++i) {
    const double angle = glm::two_pi<double>() * i / outline_points;
    const auto place =
        place_of(camera, section.point_mm +
                             disc_share * length * (portable::cos(angle) * across + portable::sin(angle) * along));
    if (place) handle.outline.push_back(*place);
  }
  return handle;
}

std::optional<SectionGrip> grip_at(const SectionHandle& handle, const glm::dvec2& place, double tolerance) {
  if (glm::distance(place, handle.tip) <= tolerance) return SectionGrip::turn;
  if (glm::distance(place, handle.knob) <= tolerance) return SectionGrip::slide;
  return std::nullopt;
}

Section dragged(const Section& section, SectionGrip grip, const Camera& camera, double reach, const glm::dvec2& from,
                const glm::dvec2& to, const Model& model) {
  const glm::dvec3 normal = glm::normalize(section.normal);
  const double length = length_there(section, camera, reach);
  if (grip == SectionGrip::turn) {
    const bool near_half = glm::dot(normal, axes_of(camera).towards_eye) >= 0;
    Section turned = section;
    turned.normal = on_ball(camera, to, section.point_mm, length, near_half);
    return turned;
  }
  const auto foot = place_of(camera, section.point_mm), head = place_of(camera, section.point_mm + length * normal);
  if (!foot || !head) return section;
  const glm::dvec2 arrow = *head - *foot;
  // Seen along the normal the arrow has no length in the picture: then up and down slide it.
  const double foreshortened = glm::length(arrow);
  const glm::dvec2 direction = foreshortened > 0.15 * reach ? arrow / foreshortened : glm::dvec2(0, 1);
  const double scale = length / std::max(foreshortened, 0.15 * reach);
  const double offset = offset_of(section, model) + scale * glm::dot(to - from, direction);
  return with_offset(section, offset, model);
}

void toggle_section(std::optional<Section>& section, std::optional<Section>& put_away, const Section& fresh) {
  if (section)
    put_away = std::exchange(section, std::nullopt);
  else
    section = put_away.value_or(fresh);
}

SectionAngles angles_of(const Section& section, const AnatomicalFrame& frame) {
  const glm::dvec3 normal = glm::normalize(section.normal);
  const double up = glm::degrees(portable::asin(std::clamp(glm::dot(normal, frame.occlusal), -1.0, 1.0)));
  const double buccal = glm::dot(normal, frame.buccal), mesial = glm::dot(normal, frame.mesial);
  const bool upright = portable::hypot(buccal, mesial) < 1e-9;
  return {upright ? 0 : glm::degrees(portable::atan2(mesial, buccal)), up};
}

glm::dvec3 normal_of(const SectionAngles& angles, const AnatomicalFrame& frame) {
  const double round = glm::radians(angles.round_deg), up = glm::radians(angles.up_deg);
  return glm::normalize(portable::cos(up) *
                            (portable::cos(round) * frame.buccal + portable::sin(round) * frame.mesial) +
                        portable::sin(up) * frame.occlusal);
}

}  // namespace odontoscope
