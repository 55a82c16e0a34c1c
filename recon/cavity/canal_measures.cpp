#include "recon/cavity/canal_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "recon/cavity/bend.h"
#include "recon/cavity/degrees.h"

namespace odontoscope::cavity {
namespace {

/// Twice the median of the widest balls.
double usual_width(const CentreLine& line) {
  std::vector<double> balls;
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) balls.push_back(line.points[i].ball);
  std::nth_element(balls.begin(), balls.begin() + static_cast<std::ptrdiff_t>(balls.size() / 2), balls.end());
  return 2 * balls[balls.size() / 2];
}

/// How far a ball may move to that side or the other and still be as wide, but for a hundredth: 0.01 of the radius in a round canal.
double room_aside(const Point3& at, const Direction& side, const WallTree& wall) {
  constexpr double as_wide = 0.99;
  const double radius = wall.clearance(at);
  double most = 0;
  for (const double sign : {1.0, -1.0}) {
    double near = 0, far = 4 * radius;
    for (int i = 0; i < 12; ++i) {
      const double middle = (near + far) / 2;
      const Point3 there{at.x + sign * middle * side.x, at.y + sign * middle * side.y, at.z + sign * middle * side.z};
      (wall.clearance(there) >= as_wide * radius ? near : far) = middle;
    }
    most = std::max(most, near);
  }
  return most;
}

void measure_widths(const CentreLine& line, std::size_t first, std::size_t last, MeasuredCanal& canal) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    const CentrePoint& p = line.points[i];
    sum += p.ball;
    if (!canal.narrowest || 2 * p.ball < canal.narrowest->width) canal.narrowest = MeasuredPlace{2 * p.ball, p.at};
  }
  if (last > first) {
    canal.mean_width = 2 * sum / static_cast<double>(last - first);
    return;
  }
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) sum += line.points[i].ball;
  canal.mean_width = 2 * sum / static_cast<double>(line.points.size() - line.orifice);
}

}  // namespace

double schneider_of(const CentreLine& line, std::size_t orifice_point, double slack) {
  const CentrePoint& orifice = line.points[orifice_point];
  const double whole = line.points.back().along + length(line.end - line.points.back().at) - orifice.along + (orifice_point == 0 ? length(orifice.at - line.start) : 0);
  const auto third = std::find_if(line.points.begin() + static_cast<std::ptrdiff_t>(orifice_point), line.points.end(),
                                  [&](const CentrePoint& p) { return p.along >= orifice.along + whole / 3; });
  if (third == line.points.end()) return 0;
  const Direction way = third->at - orifice.at;
  const Direction axis = (1 / length(way)) * way;
  for (auto p = third; p != line.points.end(); ++p) {
    const Direction off = p->at - orifice.at;
    if (length(cross(axis, off)) <= 0.5 * p->radius + slack) continue;
    const Direction apical = line.end - p->at;
    return degrees_per_radian * std::atan2(length(cross(axis, apical)), dot(axis, apical));
  }
  return 0;
}

std::pair<std::size_t, std::size_t> between_ends(const CentreLine& line) {
  const double width = usual_width(line);
  std::size_t first = line.orifice, last = line.points.size();
  // Blind ends are narrow, and a tube without a chamber has two.
  while (last > first && length(line.end - line.points[last - 1].at) < width) --last;
  if (line.orifice == 0 && line.starts_blind())
    while (first < last && length(line.start - line.points[first].at) < width) ++first;
  return {first, last};
}

MeasuredCanal measured_canal(const CentreLine& line, const WallTree& wall) {
  MeasuredCanal canal;
  canal.name = line.name;
  canal.orifice = line.orifice == 0 ? line.start : line.points[line.orifice].at;
  canal.end = line.end;
  canal.length = line.length_to_wall();
  const auto [first, last] = between_ends(line);
  measure_widths(line, first, last, canal);
  canal.schneider_deg = schneider_of(line, line.orifice, 0);
  // Just below the orifice the line still turns out of the chamber.
  std::size_t below = first;
  while (line.orifice > 0 && below < last && line.points[below].along - line.points[first].along < canal.mean_width) ++below;
  std::vector<Point3> places;
  for (std::size_t i = below; i < last; ++i) places.push_back(line.points[i].at);
  const Bend bend = smallest_bend(places, canal.mean_width, [&](const Point3& at, const Direction& side) { return room_aside(at, side, wall); });
  canal.smallest_bend = bend.radius;
  canal.bend_fit = bend.uncertainty;
  return canal;
}

}  // namespace odontoscope::cavity
