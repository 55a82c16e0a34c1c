#include "engine/navigate/thickness_colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "engine/scene/glm_vector.h"
#include "recon/core/parallel.h"
#include "recon/mesh/surface_tree.h"

namespace odontoscope {

namespace {

constexpr std::string_view thickness_stage = "wall thickness";
/// Places that one thread measures in a row, each beginning with what it knows from the place before.
constexpr std::size_t together = 2048;
/// Of a cavity's box: a body that reaches no farther beyond fills it.
constexpr double box_slack = 0.01;
constexpr int ways_round = 36;  // in which the thinnest wall is looked for

Box box_of(const ModelPart& part) {
  Box box{glm::dvec3(part.positions.front()), glm::dvec3(part.positions.front())};
  for (const glm::vec3& position : part.positions) {
    box.low = glm::min(box.low, glm::dvec3(position));
    box.high = glm::max(box.high, glm::dvec3(position));
  }
  return box;
}

double diagonal(const Box& box) { return glm::length(box.high - box.low); }

bool within(const Box& inner, const Box& outer) {
  const glm::dvec3 slack(box_slack * diagonal(outer));
  return glm::all(glm::greaterThanEqual(inner.low, outer.low - slack)) &&
         glm::all(glm::lessThanEqual(inner.high, outer.high + slack));
}

/// The solid whose outside the part's places are measured to; none: it walls no void in.
std::optional<std::string> solid_around(const Model& model, const ModelPart& part) {
  if (part.positions.empty()) return std::nullopt;
  if (part.cavity) return part.solid;
  const Box own = box_of(part);
  std::optional<std::string> solid;
  double least = std::numeric_limits<double>::infinity();
  for (const ModelPart& cavity : model.parts) {
    if (!cavity.cavity || cavity.solid == part.solid || cavity.positions.empty()) continue;
    const Box box = box_of(cavity);
    if (!within(own, box) || diagonal(box) >= least) continue;
    least = diagonal(box);
    solid = cavity.solid;
  }
  return solid;
}

/// Of all outer surfaces of a solid; metres, relative to the model's origin. Empty: it has none.
SurfaceTree outside_of(const Model& model, const std::string& solid) {
  std::vector<Corners> corners;
  for (const ModelPart& part : model.parts) {
    if (part.cavity || part.solid != solid) continue;
    const auto corner = [&](std::size_t i) {
      const glm::vec3& at = part.positions[part.indices[i]];
      return Point3{static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)};
    };
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3)
      corners.push_back({corner(i), corner(i + 1), corner(i + 2)});
  }
  return corners.empty() ? SurfaceTree{} : SurfaceTree(corners);
}

/// The trees of the solids that were asked for.
class Outsides {
 public:
  explicit Outsides(const Model& model) : model_(&model) {}
  const SurfaceTree& of(const std::string& solid) {
    const auto known = trees_.find(solid);
    return known != trees_.end() ? known->second : trees_.emplace(solid, outside_of(*model_, solid)).first->second;
  }

 private:
  const Model* model_;
  std::map<std::string, SurfaceTree> trees_;
};

std::vector<float> thicknesses(const ModelPart& part, const SurfaceTree& outside, const Progress& progress) {
  std::vector<float> mm(part.positions.size());
  for_each((mm.size() + together - 1) / together, thickness_stage, {}, progress, [&](std::size_t block) {
    double before = std::numeric_limits<double>::infinity();
    for (std::size_t i = block * together; i < std::min((block + 1) * together, mm.size()); ++i) {
      const glm::dvec3 at(part.positions[i]);
      // Nothing nearer than from the place before, and the way from there, can be the farthest off.
      constexpr double rounding = 1 + 1e-9;
      const double reach =
          std::isfinite(before) ? rounding * (before + glm::length(at - glm::dvec3(part.positions[i - 1]))) : before;
      SurfaceTree::Nearest nearest = outside.nearest(point(at), reach * reach);
      if (!nearest.found()) nearest = outside.nearest(point(at));
      before = std::sqrt(nearest.square);
      mm[i] = static_cast<float>(before / metres_per_mm);
    }
  });
  return mm;
}

void mark_parts(Model& model, Outsides& outsides, const Progress& progress) {
  for (ModelPart& part : model.parts) {
    const auto solid = solid_around(model, part);
    if (!solid) continue;
    progress.check();
    const SurfaceTree& outside = outsides.of(*solid);
    if (!outside.empty()) part.thicknesses_mm = thicknesses(part, outside, progress);
  }
}

/// Round a place on a centre line; none: the wall is nowhere near.
std::optional<ThinPlace> thinnest_round(const FlightSpace& space, const glm::dvec3& middle, const glm::dvec3& ahead,
                                        const SurfaceTree& outside, const glm::dvec3& origin_mm) {
  const glm::dvec3 side = glm::normalize(
                       glm::cross(ahead, std::abs(ahead.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0))),
                   other = glm::cross(ahead, side);
  std::optional<ThinPlace> thinnest;
  for (int way = 0; way < ways_round; ++way) {
    const double angle = 2 * std::numbers::pi * way / ways_round;
    const glm::dvec3 towards = std::cos(angle) * side + std::sin(angle) * other;
    const double room = space.walls.free_distance(middle, towards);
    if (!std::isfinite(room)) continue;
    const glm::dvec3 at = middle + room * towards;
    const double mm = std::sqrt(outside.nearest(point(metres_per_mm * (at - origin_mm))).square) / metres_per_mm;
    if (!thinnest || mm < thinnest->mm) thinnest = ThinPlace{at, mm};
  }
  return thinnest;
}

std::vector<ThinPlace> thin_places(const FlightSpace& space, const SurfaceTree& outside, const Model& model) {
  const double apart = 0.4 * model.depth_step_mm;  // what canals have in common is told once
  std::vector<ThinPlace> places;
  for (const CentreLine& canal : space.lines.canals) {
    double next = canal.points[canal.orifice].along;
    for (std::size_t i = std::max<std::size_t>(canal.orifice, 1); i + 1 < canal.points.size(); ++i) {
      if (canal.points[i].along < next) continue;
      next += model.depth_step_mm;
      const glm::dvec3 ahead = glm::normalize(vec(canal.points[i + 1].at) - vec(canal.points[i - 1].at));
      const auto found = thinnest_round(space, vec(canal.points[i].at), ahead, outside, model.origin_mm);
      const auto near = [&](const ThinPlace& known) { return glm::length(known.at - found->at) < apart; };
      if (found && std::none_of(places.begin(), places.end(), near)) places.push_back(*found);
    }
  }
  return places;
}

}  // namespace

void mark_wall_thicknesses(Model& model, const Progress& progress) {
  Outsides outsides(model);
  mark_parts(model, outsides, progress);
}

void mark_wall_thicknesses(Model& model, FlightSpaces& spaces, const Progress& progress) {
  Outsides outsides(model);
  mark_parts(model, outsides, progress);
  for (FlightSpace& space : spaces.cavities) {
    // A body that fills its void is walled in by the solid round it.
    for (const ModelPart& part : model.parts) {
      const bool wall = part.structure == space.structure || (part.cavity && part.solid == space.structure);
      if (!wall || part.thicknesses_mm.empty()) continue;
      progress.check();
      space.thin_places = thin_places(space, outsides.of(*solid_around(model, part)), model);
    }
  }
}

bool tells_thickness(const Model& model) {
  return std::any_of(model.parts.begin(), model.parts.end(),
                     [](const ModelPart& part) { return !part.thicknesses_mm.empty(); });
}

std::vector<FlightLabel> thickness_labels(const FlightSpace& space) {
  std::vector<FlightLabel> labels;
  for (const ThinPlace& place : space.thin_places)
    labels.push_back(
        {.at = place.at, .words = fmt::format("{:.2f} mm", place.mm), .line = {}, .number = WallNumber::thickness});
  return labels;
}

}  // namespace odontoscope
