#include "recon/cavity/canal_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "recon/cavity/bend.h"
#include "recon/cavity/degrees.h"
#include "recon/cavity/section_middles.h"
#include "recon/core/portable_math.h"

namespace odontoscope::cavity {
namespace {

/// Twice the median of the widest balls.
double usual_width(const CentreLine& line) {
  std::vector<double> balls;
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) balls.push_back(line.points[i].ball);
  std::nth_element(balls.begin(), balls.begin() + static_cast<std::ptrdiff_t>(balls.size() / 2), balls.end());
  return 2 * balls[balls.size() / 2];
}

/// How far a ball may move to that side or the other and still be as wide, but for a hundredth: 0.01 of the radius in a
/// round canal.
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

void measure_widths(const CentreLine& line, const std::vector<double>& widths, std::size_t first, std::size_t last,
                    MeasuredCanal& canal) {
  double sum = 0, ball = 0;
  for (std::size_t i = first; i < last; ++i) {
    sum += widths[i];
    // All of a window is equally wide: the place is where its ball is smallest.
    const bool narrower = !canal.narrowest || widths[i] < canal.narrowest->width ||
                          (widths[i] == canal.narrowest->width && line.points[i].ball < ball);
    if (!narrower) continue;
    canal.narrowest = MeasuredPlace{widths[i], line.points[i].at};
    ball = line.points[i].ball;
  }
  if (last > first) {
    // Rounding, where all of it is equally wide.
    canal.mean_width = std::max(sum / static_cast<double>(last - first), canal.narrowest->width);
    return;
  }
  for (std::size_t i = line.orifice; i < line.points.size(); ++i) sum += widths[i];
  canal.mean_width = sum / static_cast<double>(line.points.size() - line.orifice);
}

/// Of the points that are no nearer to either end than their section is wide: there the line still turns out of the
/// chamber, or into the corner of a flat end.
std::vector<SectionMiddle> middles_between(const CentreLine& line, const SurfaceMesh& wall, std::size_t first,
                                           std::size_t last) {
  const std::vector<SectionMiddle> all = section_middles(wall, line, first, last);
  const auto near_orifice = [&](std::size_t i) {
    return line.orifice > 0 && line.points[i].along - line.points[line.orifice].along < 2 * all[i - first].reach;
  };
  const auto near_start = [&](std::size_t i) {
    return line.orifice == 0 && line.starts_blind() &&
           length(line.start - line.points[i].at) < 2 * all[i - first].reach;
  };
  std::size_t below = first;
  while (below < last && (near_orifice(below) || near_start(below))) ++below;
  while (last > below && length(line.end - line.points[last - 1].at) < 2 * all[last - 1 - first].reach) --last;
  return {all.begin() + static_cast<std::ptrdiff_t>(below - first),
          all.begin() + static_cast<std::ptrdiff_t>(last - first)};
}

/// A part of the line whose sections are all compact, or none is.
struct Stretch {
  std::vector<Point3> places;
  bool compact = false;
  double way() const {
    double sum = 0;
    for (std::size_t i = 1; i < places.size(); ++i) sum += length(places[i] - places[i - 1]);
    return sum;
  }
};

std::vector<Stretch> runs_of(const std::vector<SectionMiddle>& middles) {
  std::vector<Stretch> runs;
  for (const SectionMiddle& middle : middles) {
    if (runs.empty() || runs.back().compact != middle.compact) runs.push_back({{}, middle.compact});
    runs.back().places.push_back(middle.at);
  }
  return runs;
}

/// A few sections that are not compact, less than a width long, are passed over: a pit in the wall.
std::vector<Stretch> stretches_of(const std::vector<SectionMiddle>& middles, double width) {
  std::vector<Stretch> stretches;
  for (Stretch& run : runs_of(middles)) {
    if (!run.compact && !stretches.empty() && run.way() < width) continue;
    if (stretches.empty() || stretches.back().compact != run.compact)
      stretches.push_back(std::move(run));
    else
      stretches.back().places.insert(stretches.back().places.end(), run.places.begin(), run.places.end());
  }
  return stretches;
}

}  // namespace

double schneider_of(const CentreLine& line, std::size_t orifice_point, double slack) {
  const CentrePoint& orifice = line.points[orifice_point];
  const double whole = line.points.back().along + length(line.end - line.points.back().at) - orifice.along +
                       (orifice_point == 0 ? length(orifice.at - line.start) : 0);
  const auto third = std::find_if(line.points.begin() + static_cast<std::ptrdiff_t>(orifice_point), line.points.end(),
                                  [&](const CentrePoint& p) { return p.along >= orifice.along + whole / 3; });
  if (third == line.points.end()) return 0;
  const Direction way = third->at - orifice.at;
  const Direction axis = (1 / length(way)) * way;
  for (auto p = third; p != line.points.end(); ++p) {
    const Direction off = p->at - orifice.at;
    if (length(cross(axis, off)) <= 0.5 * p->radius + slack) continue;
    const Direction apical = line.end - p->at;
    return degrees_per_radian * portable::atan2(length(cross(axis, apical)), dot(axis, apical));
  }
  return 0;
}

std::vector<double> known_widths(const CentreLine& line, double spacing) {
  const std::vector<CentrePoint>& points = line.points;
  // To where a window of one spacing, and of the distance of points, reaches from each point on.
  const double reach = spacing + (points.size() > 1 ? points[1].along - points[0].along : 0);
  std::vector<double> widest;  // of the window that begins there
  std::vector<std::size_t> ends;
  for (std::size_t i = 0, end = 0; i < points.size(); ++i) {
    while (end + 1 < points.size() && points[end].along - points[i].along < reach) ++end;
    const auto wider = [](const CentrePoint& a, const CentrePoint& b) { return a.ball < b.ball; };
    widest.push_back(2 * std::max_element(points.begin() + static_cast<std::ptrdiff_t>(i),
                                          points.begin() + static_cast<std::ptrdiff_t>(end) + 1, wider)
                             ->ball);
    ends.push_back(end);
  }
  std::vector<double> widths(points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = i; k <= ends[i]; ++k) widths[k] = std::min(widths[k], widest[i]);
  // A tube without a chamber begins and ends within a window.
  for (const std::size_t end : {std::size_t{0}, points.size() - 1})
    for (std::size_t k = 0; k < points.size(); ++k)
      if (std::abs(points[k].along - points[end].along) < reach) {
        double most = 0;
        for (std::size_t i = std::min(k, end); i <= std::max(k, end); ++i) most = std::max(most, 2 * points[i].ball);
        widths[k] = std::min(widths[k], most);
      }
  return widths;
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

MeasuredCanal measured_canal(const CentreLine& line, const SurfaceMesh& wall, const WallTree& tree, double spacing) {
  MeasuredCanal canal;
  canal.name = line.name;
  canal.orifice = line.orifice == 0 ? line.start : line.points[line.orifice].at;
  canal.end = line.end;
  canal.length = line.length_to_wall();
  const auto [first, last] = between_ends(line);
  measure_widths(line, known_widths(line, spacing), first, last, canal);
  canal.schneider_deg = schneider_of(line, line.orifice, 0);
  canal.smallest_bend = std::numeric_limits<double>::infinity();
  for (const Stretch& stretch : stretches_of(middles_between(line, wall, first, last), canal.mean_width)) {
    const auto loose = [&](const Point3& at, const Direction& side) { return room_aside(at, side, tree); };
    const Bend bend = stretch.compact ? smallest_bend(stretch.places, canal.mean_width)
                                      : smallest_bend(stretch.places, canal.mean_width, loose);
    if (bend.radius >= canal.smallest_bend) continue;
    canal.smallest_bend = bend.radius;
    canal.bend_fit = bend.uncertainty;
  }
  return canal;
}

}  // namespace odontoscope::cavity
