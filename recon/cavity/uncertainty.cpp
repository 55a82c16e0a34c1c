#include "recon/cavity/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "recon/cavity/canal_measures.h"

namespace odontoscope::cavity {
namespace {

constexpr double degrees = 57.29577951308232;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> edge_lengths(const SurfaceMesh& wall) {
  std::vector<double> lengths;
  for (const Triangle& t : wall.triangles)
    for (std::size_t k = 0; k < 3; ++k) lengths.push_back(length(wall.points[t[(k + 1) % 3]] - wall.points[t[k]]));
  return lengths;
}

/// Of contours: edges within a plane of constant z.
double side_length(const SurfaceMesh& wall) {
  std::vector<double> lengths;
  for (const Triangle& t : wall.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &a = wall.points[t[k]], &b = wall.points[t[(k + 1) % 3]];
      if (a.z == b.z) lengths.push_back(length(b - a));
    }
  return median(lengths);
}

struct Slope {
  double width = 0;   // change of the width over the way
  double lean = 0;    // sine square of the angle between the line and z
};

Slope slope_at(const CentreLine& line, std::size_t i, double reach) {
  std::size_t first = i, last = i;
  while (first > 0 && line.points[i].along - line.points[first].along < reach) --first;
  while (last + 1 < line.points.size() && line.points[last].along - line.points[i].along < reach) ++last;
  const CentrePoint &a = line.points[first], &b = line.points[last];
  const double way = b.along - a.along;
  if (!(way > 0)) return {};
  const Direction chord = b.at - a.at;
  const double across = std::hypot(chord.x, chord.y), whole = length(chord);
  return {2 * std::abs(b.ball - a.ball) / way, whole > 0 ? across * across / (whole * whole) : 0};
}

std::size_t point_at(const CentreLine& line, const Point3& at) {
  const auto nearer = [&](const CentrePoint& a, const CentrePoint& b) { return length(a.at - at) < length(b.at - at); };
  return static_cast<std::size_t>(std::min_element(line.points.begin(), line.points.end(), nearer) - line.points.begin());
}

}  // namespace

double slice_spacing_of(const SurfaceMesh& wall) {
  std::vector<double> heights, gaps;
  for (const Point3& p : wall.points) heights.push_back(p.z);
  std::sort(heights.begin(), heights.end());
  if (heights.empty()) return 0;
  const double same = 1e-6 * (heights.back() - heights.front());
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (heights[i] - heights[i - 1] > same) gaps.push_back(heights[i] - heights[i - 1]);
  constexpr std::size_t points_of_a_slice = 4;
  if (gaps.empty() || gaps.size() * points_of_a_slice > heights.size()) return median(edge_lengths(wall));
  return median(gaps);
}

CanalUncertainty uncertainty_of(const MeasuredCanal& canal, const CanalShape& shape, const CentreLine& line, const SurfaceMesh& wall, double spacing) {
  const double side = side_length(wall);
  const auto of_width = [&](std::size_t i) {
    const Slope slope = slope_at(line, i, std::max(spacing, line.points[i].ball));
    return spacing / 2 * (slope.width + slope.lean) + side * side / std::max(4 * line.points[i].ball, side);
  };
  CanalUncertainty made;
  made.length = spacing;
  const auto [first, last] = between_ends(line);
  for (std::size_t i = first; i < last; ++i) made.mean_width += of_width(i) / static_cast<double>(last - first);
  if (first == last) made.mean_width = of_width(line.orifice);
  if (canal.narrowest) made.narrowest = of_width(point_at(line, canal.narrowest->at));
  made.schneider_deg = degrees * std::atan2(2 * made.mean_width, canal.length / 3);
  if (std::isfinite(canal.smallest_bend)) made.smallest_bend = canal.bend_fit;
  if (canal.thinnest_wall) made.thinnest_wall = of_width(point_at(line, canal.thinnest_wall->at));
  made.area = made.length / canal.length + made.mean_width / canal.mean_width;
  made.volume = made.length / canal.length + 2 * made.mean_width / canal.mean_width;
  for (const ApicalSection& section : shape.apical) {
    const double along = line.points.back().along + length(line.end - line.points.back().at) - section.from_apex;
    const std::size_t i = point_at(line, place_along(line, along));
    const double width = of_width(i) + spacing * slope_at(line, i, spacing).width;
    made.apical_width.push_back(width);
    made.apical_area.push_back(2 * width / section.width * section.area);
  }
  return made;
}

}  // namespace odontoscope::cavity
