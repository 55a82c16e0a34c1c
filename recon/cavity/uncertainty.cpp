#include "recon/cavity/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "recon/cavity/canal_measures.h"
#include "recon/cavity/degrees.h"
#include "recon/cavity/limits.h"
#include "recon/core/portable_math.h"

namespace odontoscope::cavity {
namespace {

/// Of so many sorted values the one that far on.
double part_of(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double median(std::vector<double> values) { return part_of(std::move(values), 0.5); }

std::vector<double> edge_lengths(const SurfaceMesh& wall) {
  std::vector<double> lengths;
  for (const Triangle& t : wall.triangles)
    for (std::size_t k = 0; k < 3; ++k) lengths.push_back(length(wall.points[t[(k + 1) % 3]] - wall.points[t[k]]));
  return lengths;
}

/// Of contours: edges within a plane of constant z that `counts`.
template <class Counts>
double side_length(const SurfaceMesh& wall, double share, const Counts& counts) {
  std::vector<double> lengths;
  for (const Triangle& t : wall.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &a = wall.points[t[k]], &b = wall.points[t[(k + 1) % 3]];
      if (a.z == b.z && counts(a)) lengths.push_back(length(b - a));
    }
  return part_of(std::move(lengths), share);
}

/// A ball touches a polygon's longest sides, and a wall is thinnest beside one: nineteen in twenty are shorter.
constexpr double long_ones = 0.95;

/// Of the contours about a canal. The chamber's are longer.
double side_beside(const SurfaceMesh& wall, const CentreLine& line) {
  constexpr double reach = 2;  // balls: as far as an oval canal's wall
  return side_length(wall, long_ones, [&](const Point3& p) {
    const CentrePoint* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const CentrePoint& one : line.points) {
      const Direction off = p - one.at;
      const double square = dot(off, off);
      if (square >= least) continue;
      least = square;
      nearest = &one;
    }
    const CentrePoint& orifice = line.points[line.orifice];
    return nearest != nullptr && nearest->along >= orifice.along + (line.orifice > 0 ? orifice.ball : 0) &&
           least < reach * reach * nearest->ball * nearest->ball;
  });
}

struct Slope {
  double width = 0;  // change of the width over the way
  double lean = 0;   // sine square of the angle between the line and z
};

Slope slope_at(const CentreLine& line, std::size_t i, double reach) {
  std::size_t first = i, last = i;
  while (first > 0 && line.points[i].along - line.points[first].along < reach) --first;
  while (last + 1 < line.points.size() && line.points[last].along - line.points[i].along < reach) ++last;
  const CentrePoint &a = line.points[first], &b = line.points[last];
  const double way = b.along - a.along;
  if (!(way > 0)) return {};
  const Direction chord = b.at - a.at;
  const double across = portable::hypot(chord.x, chord.y), whole = length(chord);
  return {2 * std::abs(b.ball - a.ball) / way, whole > 0 ? across * across / (whole * whole) : 0};
}

std::size_t point_at(const CentreLine& line, const Point3& at) {
  const auto nearer = [&](const CentrePoint& a, const CentrePoint& b) { return length(a.at - at) < length(b.at - at); };
  return static_cast<std::size_t>(std::min_element(line.points.begin(), line.points.end(), nearer) -
                                  line.points.begin());
}

/// Of many widths that are each a little off the narrowest is so downwards: by as much as it is less than the usual one
/// within a width of it.
double stands_out(const CentreLine& line, const MeasuredPlace& narrowest) {
  std::vector<double> widths;
  for (std::size_t i = line.orifice; i < line.points.size(); ++i)
    if (length(line.points[i].at - narrowest.at) <= narrowest.width) widths.push_back(2 * line.points[i].ball);
  return std::max(median(std::move(widths)) - narrowest.width, 0.0);
}

/// How much the angle changes where the orifice lies so far up or down the line, and the line so far aside.
double off_schneider(const MeasuredCanal& canal, const CentreLine& line, double along, double aside) {
  double most = 0;
  const double at = line.points[line.orifice].along;
  std::size_t up = line.orifice, down = line.orifice;
  while (up > 1 && at - line.points[up].along < along) --up;
  while (line.orifice > 0 && down + 5 < line.points.size() && line.points[down].along - at < along) ++down;
  for (const std::size_t orifice : {up, line.orifice, down})
    for (const double slack : {-aside, 0.0, aside})
      most = std::max(most, std::abs(schneider_of(line, orifice, slack) - canal.schneider_deg));
  return most + degrees_per_radian * portable::atan2(2 * aside, canal.length / 3);
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

SliceKnowledge slice_knowledge(const SurfaceMesh& outside, double spacing, double chamber_radius,
                               const std::vector<Cavity::Mouth>& mouths) {
  return {spacing, side_length(outside, long_ones, [](const Point3&) { return true; }), chamber_radius, mouths};
}

CanalUncertainty uncertainty_of(const MeasuredCanal& canal, const CanalShape& shape, const CentreLine& line,
                                const SurfaceMesh& wall, const SliceKnowledge& known) {
  const double spacing = known.spacing, side = side_beside(wall, line);
  const auto of_width = [&](std::size_t i) {
    const double ball = line.points[i].ball;
    const Slope slope = slope_at(line, i, std::max(spacing, ball));
    return spacing / 2 * (slope.width + slope.lean) + side * side / std::max(4 * ball, side) +
           2 * limits::ball_fineness * ball;
  };
  CanalUncertainty made;
  const double step = line.points.size() > 1 ? line.points[1].along : 0;
  made.length = spacing + step;
  for (const Cavity::Mouth& mouth : known.mouths) {
    const double radius = std::sqrt(mouth.area / std::numbers::pi);
    if (length(mouth.at - canal.end) < radius) made.length += 2 * radius;
  }
  const auto [first, last] = between_ends(line);
  for (std::size_t i = first; i < last; ++i) made.mean_width += of_width(i) / static_cast<double>(last - first);
  if (first == last) made.mean_width = of_width(line.orifice);
  if (canal.narrowest)
    made.narrowest = of_width(point_at(line, canal.narrowest->at)) + stands_out(line, *canal.narrowest);
  made.schneider_deg = off_schneider(canal, line, made.length, made.mean_width);
  if (std::isfinite(canal.smallest_bend)) made.smallest_bend = canal.bend_fit;
  if (canal.thinnest_wall) {
    const std::size_t i = point_at(line, canal.thinnest_wall->at);
    const double out = canal.thinnest_wall->width + line.points[i].ball, polygon = known.outer_side;
    made.thinnest_wall = of_width(i) + polygon * polygon / std::max(8 * out, polygon);
  }
  for (std::size_t third = 0; third < 3; ++third) {
    const double ends = made.length / canal.length, width = made.mean_width / canal.mean_width;
    made.volume[third] = (ends + 2 * width) * shape.thirds[third].volume;
    made.area[third] = (ends + width) * shape.thirds[third].area;
  }
  // The chamber's wall flares about the orifice: as much of it may be counted as lies within that length of it.
  if (line.orifice > 0) made.area[0] += 2 * std::numbers::pi * known.chamber * made.length / 2;
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
