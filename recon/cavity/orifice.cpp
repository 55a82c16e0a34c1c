#include "recon/cavity/orifice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/cavity/limits.h"
#include "recon/core/portable_math.h"

namespace odontoscope::cavity {
namespace {

/// How far one can go before the wall is as near as `close`, and no farther than `most`.
double free_way(const Point3& from, const Direction& way, double close, double most, const WallTree& tree) {
  double gone = 0;
  while (gone < most) {
    const double clear = tree.clearance({from.x + gone * way.x, from.y + gone * way.y, from.z + gone * way.z});
    if (clear < close) break;
    gone += clear;
  }
  return std::min(gone, most);
}

/// Of what can be seen from the point across the line, but no farther than `most`.
double section_area(const CentreLine& line, std::size_t i, double most, const WallTree& tree) {
  constexpr int rays = 12;
  constexpr double close = 0.1;  // of the radius
  const CentrePoint& p = line.points[i];
  const Direction along = line.points[std::min(i + 1, line.points.size() - 1)].at - line.points[i > 0 ? i - 1 : 0].at;
  const Direction other = std::abs(along.z) < std::abs(along.x) ? Direction{0, 0, 1} : Direction{1, 0, 0};
  const Direction side = cross(along, other);
  const Direction u = (1 / length(side)) * side, w = cross(along, u), v = (1 / length(w)) * w;
  double squares = 0;
  for (int k = 0; k < rays; ++k) {
    const double angle = 2 * std::numbers::pi * k / rays;
    const double far =
        free_way(p.at, portable::cos(angle) * u + portable::sin(angle) * v, close * p.radius, most, tree);
    squares += far * far;
  }
  return std::numbers::pi * squares / rays;
}

}  // namespace

std::size_t orifice_of(const CentreLine& line, double chamber_radius, const WallTree& tree) {
  const double most = limits::section_reach * chamber_radius, end = limits::orifice_part * line.points.back().along;
  std::vector<double> areas;
  for (std::size_t i = 0; i < line.points.size() && line.points[i].along <= end; ++i)
    areas.push_back(section_area(line, i, most, tree));
  // Within one radius from each point on: how much smaller does the section get, and where.
  std::vector<double> drops;
  std::vector<std::size_t> below;
  for (std::size_t i = 0, j = 0; i < areas.size(); ++i) {
    while (j + 1 < areas.size() && line.points[j].along < line.points[i].along + line.points[i].radius) ++j;
    drops.push_back(portable::log(areas[i] / areas[j]));
    below.push_back(j);
  }
  // Where the line bends within the chamber, sections change, too: the last great drop counts, and there the greatest
  // step.
  const double best = drops.empty() ? 0 : *std::max_element(drops.begin(), drops.end());
  const double least_drop = std::max(portable::log(limits::orifice_drop), limits::orifice_great * best);
  std::size_t upper = 0, lower = 0;
  for (std::size_t i = 0; i < drops.size(); ++i) {
    if (drops[i] < least_drop) continue;
    upper = i;
    lower = below[i];
  }
  std::size_t place = upper;
  for (std::size_t i = upper; i < lower; ++i)
    if (place == upper || areas[i] / areas[i + 1] > areas[place - 1] / areas[place]) place = i + 1;
  if (lower > 0) return place;
  while (place + 1 < line.points.size() && length(line.points[place].at - line.points[0].at) < chamber_radius) ++place;
  return place;
}

}  // namespace odontoscope::cavity
