#include "engine/headset/section_frame.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/navigate/section_handle.h"

namespace odontoscope {

namespace {

/// Places along each edge that are tried.
constexpr int places = 32;

}  // namespace

SectionFrame section_frame(const Section& section, const Stage& stage, const Model& model) {
  constexpr double margin = 0.06;  // of the model's radius
  const Section centred = with_offset(section, offset_of(section, model), model);
  const glm::dvec3 upright(0, 0, 1), buccal(0, 1, 0);
  const glm::dvec3 other = std::abs(centred.normal.z) < 0.95 ? upright : buccal;
  const glm::dvec3 across = glm::normalize(glm::cross(other, centred.normal)),
                   along = glm::cross(centred.normal, across);
  const glm::dvec3 half = 0.5 * (model.bounds_mm.high - model.bounds_mm.low);
  const auto reach = [&](const glm::dvec3& axis) { return glm::dot(half, glm::abs(axis)) + margin * model.radius_mm; };
  const glm::dvec3 right = reach(across) * across, up = reach(along) * along;
  SectionFrame frame;
  std::size_t i = 0;
  for (const glm::dvec3& corner : {right + up, up - right, -right - up, right - up})
    frame[i++] = to_room(stage, centred.point_mm + corner);
  return frame;
}

std::optional<glm::dvec3> meant(const SectionFrame& frame, const Pose& grip, const Pose& aim) {
  constexpr double finger = 0.025, slope = 0.03, in_reach = 0.07;  // metres, metres a metre, metres
  std::optional<glm::dvec3> best;
  double least = 1;  // of what is allowed
  for (std::size_t edge = 0; edge < frame.size(); ++edge) {
    for (int k = 0; k < places; ++k) {
      const glm::dvec3 place = glm::mix(frame[edge], frame[(edge + 1) % frame.size()], static_cast<double>(k) / places);
      const glm::dvec3 way = place - aim.position;
      const double ahead = glm::dot(way, aim.ahead()), off = glm::length(way - ahead * aim.ahead());
      const double by_ray = ahead > 0 ? off / (finger + slope * ahead) : least,
                   by_hand = glm::length(place - grip.position) / in_reach;
      if (std::min(by_ray, by_hand) >= least) continue;
      least = std::min(by_ray, by_hand);
      best = place;
    }
  }
  return best;
}

Section carried(const Section& section, const Stage& stage, const Pose& from, const Pose& to, const Model& model) {
  const glm::dquat turn = to.turn * glm::conjugate(from.turn);
  const glm::dvec3 place = to.position + turn * (to_room(stage, section.point_mm) - from.position);
  const Section moved{to_model(stage, place),
                      direction_to_model(stage, turn * (stage.turn * glm::normalize(section.normal)))};
  return with_offset(moved, offset_of(moved, model), model);
}

}  // namespace odontoscope
