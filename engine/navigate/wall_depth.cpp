#include "engine/navigate/wall_depth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/scene/glm_vector.h"

namespace odontoscope {

namespace {

/// A piece of a centre line, its ends with their depths. Sorted by the lower end's height.
struct Piece {
  glm::dvec3 from, to;
  float depth_from, depth_to;
  double low, high;  // heights
};

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Where depth is counted from, along the line; NaN: nowhere.
double zero_of(const CentreLines& lines, const CentreLine& line) {
  if (line.orifice > 0) return line.points[line.orifice].along;
  return lines.has_chamber ? unknown : 0;
}

void add_pieces(const CentreLine& line, double zero, std::vector<Piece>& pieces) {
  const auto add = [&](const Point3& a, const Point3& b, double along_a, double along_b) {
    const auto depth = [&](double along) {
      return std::isnan(zero) ? above_orifice : static_cast<float>(along - zero);
    };
    pieces.push_back({vec(a), vec(b), depth(along_a), depth(along_b), std::min(a.z, b.z), std::max(a.z, b.z)});
  };
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    add(line.points[i].at, line.points[i + 1].at, line.points[i].along, line.points[i + 1].along);
  const CentrePoint& last = line.points.back();
  add(last.at, line.end, last.along, last.along + glm::length(vec(line.end) - vec(last.at)));
}

std::vector<Piece> pieces_of(const std::vector<const CentreLines*>& several) {
  std::vector<Piece> pieces;
  for (const CentreLines* lines : several) {
    for (const CentreLine& canal : lines->canals) add_pieces(canal, zero_of(*lines, canal), pieces);
    for (const CentreLine& other : lines->others)
      if (other.orifice > 0) add_pieces(other, zero_of(*lines, other), pieces);
    for (const CentreLine& horn : lines->horns) add_pieces(horn, unknown, pieces);
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.low < b.low; });
  return pieces;
}

class NearestDepth {
 public:
  explicit NearestDepth(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
    for (const Piece& piece : pieces_) longest_ = std::max(longest_, piece.high - piece.low);
  }

  float at(const glm::dvec3& place) const {
    double best = std::numeric_limits<double>::infinity();
    float depth = above_orifice;
    const auto look_at = [&](const Piece& piece) {
      const glm::dvec3 way = piece.to - piece.from;
      const double squared = glm::dot(way, way);
      const double part = squared > 0 ? std::clamp(glm::dot(place - piece.from, way) / squared, 0.0, 1.0) : 0;
      const glm::dvec3 off = place - (piece.from + part * way);
      if (const double distance = glm::dot(off, off); distance < best) {
        best = distance;
        depth = piece.depth_from + static_cast<float>(part) * (piece.depth_to - piece.depth_from);
      }
    };
    // Up and down from the vertex's height, for as long as a piece could be nearer.
    const auto middle = std::lower_bound(pieces_.begin(), pieces_.end(), place.z,
                                         [](const Piece& piece, double z) { return piece.low < z; });
    auto up = middle, down = middle;
    const auto beyond = [&](double gap) { return gap > 0 && gap * gap >= best; };
    while (up != pieces_.end() || down != pieces_.begin()) {
      if (up != pieces_.end()) {
        if (beyond(up->low - place.z))
          up = pieces_.end();
        else
          look_at(*up++);
      }
      if (down != pieces_.begin()) {
        const Piece& below = *(down - 1);
        if (beyond(place.z - below.low - longest_))
          down = pieces_.begin();
        else
          look_at(below), --down;
      }
    }
    return std::max(depth, above_orifice);
  }

 private:
  std::vector<Piece> pieces_;
  double longest_ = 0;  // along z
};

}  // namespace

double depth_step_mm(double deepest_mm) {
  constexpr double most_rings = 25, largest = 1e6;
  double step = 1;
  for (bool five = true; deepest_mm > most_rings * step && step < largest; five = !five) step *= five ? 5 : 2;
  return step;
}

void mark_wall_depths(Model& model, const std::vector<LinedWall>& walls) {
  float deepest = 0;
  for (ModelPart& part : model.parts) {
    std::vector<const CentreLines*> several;
    for (const LinedWall& wall : walls)
      if (*wall.structure == part.structure) several.push_back(wall.lines);
    std::vector<Piece> pieces = pieces_of(several);
    if (pieces.empty()) continue;
    const NearestDepth nearest(std::move(pieces));
    part.depths_mm.resize(part.positions.size());
    std::transform(
        part.positions.begin(), part.positions.end(), part.depths_mm.begin(),
        [&](const glm::vec3& position) { return nearest.at(model.origin_mm + glm::dvec3(position) / metres_per_mm); });
    for (const float depth : part.depths_mm) deepest = std::max(deepest, depth);
  }
  model.depth_step_mm = depth_step_mm(deepest);
}

void mark_wall_depths(Model& model, const FlightSpaces& spaces) {
  std::vector<LinedWall> walls;
  for (const FlightSpace& space : spaces.cavities) walls.push_back({&space.structure, &space.lines});
  mark_wall_depths(model, walls);
}

std::vector<FlightLabel> depth_labels(const FlightSpace& space, double step_mm) {
  const double apart = 0.4 * step_mm;  // nearer ones of the same depth are one
  std::vector<FlightLabel> labels;
  for (const CentreLine& canal : space.lines.canals) {
    const double zero = zero_of(space.lines, canal);
    if (std::isnan(zero)) continue;
    double next = step_mm;
    for (std::size_t i = 1; i + 1 < canal.points.size(); ++i) {
      if (canal.points[i].along - zero < next) continue;
      const glm::dvec3 middle = vec(canal.points[i].at),
                       ahead = glm::normalize(vec(canal.points[i + 1].at) - vec(canal.points[i - 1].at));
      const glm::dvec3 aside = glm::cross(ahead, std::abs(ahead.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0));
      const double room = space.walls.free_distance(middle, glm::normalize(aside));
      const glm::dvec3 at = middle + (std::isfinite(room) ? room : canal.points[i].radius) * glm::normalize(aside);
      const std::string words = fmt::format("{:.0f} mm", next);
      const auto same = [&](const FlightLabel& other) {
        return other.words == words && glm::length(other.at - at) < apart;
      };
      if (std::none_of(labels.begin(), labels.end(), same))
        labels.push_back({.at = at, .words = words, .line = {}, .number = WallNumber::depth});
      next += step_mm;
    }
  }
  return labels;
}

}  // namespace odontoscope
