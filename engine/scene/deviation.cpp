#include "engine/scene/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace odontoscope {

namespace {

constexpr double steps_a_voxel =
    4;  // that are looked at along a line, so that two crossings within one are seldom missed
constexpr int halvings = 30, most_turns = 4;

glm::dvec3 to_place_mm(const Model& model, const glm::vec3& position) {
  return model.origin_mm + glm::dvec3(position) / metres_per_mm;
}

/// All that a search for crossings from one place needs.
struct Search {
  const ValueGrid& grid;
  double iso;
  glm::dvec3 from;
  bool below;  // is the value there
  double stride, best;
  std::optional<glm::dvec3> foot = {};

  bool crossed(const glm::dvec3& direction, double way) const {
    return (value_at(grid, from + way * direction) < iso) != below;
  }

  /// The first crossing along a direction of unit length, if it is nearer than the best. True if it was.
  bool look(const glm::dvec3& direction) {
    double near = 0;
    while (near < best) {
      double far = std::min(near + stride, best);
      if (!crossed(direction, far)) {
        near = far;
        continue;
      }
      for (int i = 0; i < halvings; ++i) (crossed(direction, 0.5 * (near + far)) ? far : near) = 0.5 * (near + far);
      foot = from + far * direction;
      best = far;
      return true;
    }
    return false;
  }
  void look_both_ways(const glm::dvec3& way) {
    const double length = glm::length(way);
    if (!(length > 0)) return;
    look(way / length);
    look(-way / length);
  }
};

constexpr std::array<glm::dvec3, 7> all_around{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}}};

void part_into_four(ModelPart& part) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(part.positions.size()));
    if (is_new) {
      part.positions.push_back(0.5f * (part.positions[a] + part.positions[b]));
      const glm::vec3 normal = part.normals[a] + part.normals[b];
      part.normals.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : part.normals[a]);
    }
    return found->second;
  };
  std::vector<std::uint32_t> indices;
  indices.reserve(4 * part.indices.size());
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const std::uint32_t a = part.indices[i], b = part.indices[i + 1], c = part.indices[i + 2], ab = middle(a, b),
                        bc = middle(b, c), ca = middle(c, a);
    for (const std::uint32_t corner : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) indices.push_back(corner);
  }
  part.indices = std::move(indices);
  part.depths_mm.clear();
}

double median_like(std::vector<double>& values, double part) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

double value_at(const ValueGrid& grid, const glm::dvec3& place_mm) {
  std::array<std::size_t, 3> low{}, high{};
  glm::dvec3 part(0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<std::size_t>(axis);
    const double last = static_cast<double>(grid.size[n] - 1),
                 at = std::clamp((place_mm[axis] - grid.first_mm[axis]) / grid.step_mm[axis], 0.0, last);
    low[n] = static_cast<std::size_t>(at);
    high[n] = std::min(low[n] + 1, grid.size[n] - 1);
    part[axis] = at - static_cast<double>(low[n]);
  }
  const auto value = [&](std::size_t x, std::size_t y, std::size_t z) {
    return static_cast<double>(grid.values[(z * grid.size[1] + y) * grid.size[0] + x]);
  };
  const auto along_x = [&](std::size_t y, std::size_t z) {
    return glm::mix(value(low[0], y, z), value(high[0], y, z), part.x);
  };
  const auto along_y = [&](std::size_t z) { return glm::mix(along_x(low[1], z), along_x(high[1], z), part.y); };
  return glm::mix(along_y(low[2]), along_y(high[2]), part.z);
}

glm::dvec3 slope_at(const ValueGrid& grid, const glm::dvec3& place_mm) {
  glm::dvec3 slope(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 half(0);
    half[axis] = 0.5 * grid.step_mm[axis];
    slope[axis] = (value_at(grid, place_mm + half) - value_at(grid, place_mm - half)) / grid.step_mm[axis];
  }
  return slope;
}

std::optional<double> deviation_at(const ValueGrid& grid, double iso, const glm::dvec3& place_mm,
                                   const glm::dvec3& normal) {
  const double finest = std::min({grid.step_mm.x, grid.step_mm.y, grid.step_mm.z}),
               coarsest = std::max({grid.step_mm.x, grid.step_mm.y, grid.step_mm.z});
  Search search{
      grid, iso, place_mm, value_at(grid, place_mm) < iso, finest / steps_a_voxel, deviation_reach_steps * coarsest};
  search.look_both_ways(normal);
  search.look_both_ways(slope_at(grid, place_mm));
  for (const glm::dvec3& way : all_around) search.look_both_ways(way);
  // From the nearest crossing the shortest way back runs along the slope that the values have there.
  for (int turn = 0; turn < most_turns && search.foot; ++turn) {
    const glm::dvec3 slope = slope_at(grid, *search.foot);
    const double steep = glm::length(slope), side = glm::dot(slope, *search.foot - place_mm);
    if (!(steep > 0) || !search.look((side < 0 ? -1.0 : 1.0) / steep * slope)) break;
  }
  if (!search.foot) return std::nullopt;
  return search.below ? search.best : -search.best;
}

void mark_deviations(Model& model, const ValueGrid& grid, const std::vector<IsoOf>& isos) {
  for (ModelPart& part : model.parts) {
    const auto own =
        std::find_if(isos.begin(), isos.end(), [&](const IsoOf& each) { return each.solid == part.solid; });
    part.deviations.clear();
    if (own == isos.end()) continue;
    part_into_four(part);
    part.deviations.reserve(part.positions.size());
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
      const glm::dvec3 place = to_place_mm(model, part.positions[i]);
      const auto off = deviation_at(grid, own->iso, place, glm::dvec3(part.normals[i]));
      part.deviations.push_back(
          {static_cast<float>(off.value_or(no_deviation)), static_cast<float>(glm::length(slope_at(grid, place)))});
    }
  }
}

std::optional<DeviationSummary> deviations_in(const Model& model) {
  DeviationSummary summary;
  std::vector<double> distances, slopes;
  for (const ModelPart& part : model.parts)
    for (std::size_t i = 0; i < part.deviations.size(); ++i) {
      slopes.push_back(static_cast<double>(part.deviations[i].y));
      const double distance = std::abs(static_cast<double>(part.deviations[i].x));
      if (distance >= static_cast<double>(no_deviation)) {
        ++summary.without;
        continue;
      }
      if (distances.empty() || distance > summary.most_mm) {
        summary.most_mm = distance;
        summary.most_at_mm = to_place_mm(model, part.positions[i]);
      }
      distances.push_back(distance);
    }
  if (slopes.empty()) return std::nullopt;
  constexpr double half = 0.5, nineteen_of_twenty = 0.95;
  summary.positions = distances.size();
  summary.usual_slope = median_like(slopes, half);
  summary.steep_slope = median_like(slopes, nineteen_of_twenty);
  if (distances.empty()) return summary;
  summary.median_mm = median_like(distances, half);
  summary.nineteen_of_twenty_mm = median_like(distances, nineteen_of_twenty);
  return summary;
}

DataColours usual_data_colours(DataColours::Of of, const DeviationSummary& found, const ValueGrid& grid) {
  if (of == DataColours::Of::slope) return {of, found.steep_slope > 0 ? found.steep_slope : 1};
  return {of, std::max({grid.step_mm.x, grid.step_mm.y, grid.step_mm.z})};
}

}  // namespace odontoscope
