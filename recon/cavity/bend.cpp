#include "recon/cavity/bend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "recon/cavity/limits.h"
#include "recon/core/portable_math.h"
#include "recon/mesh/vector.h"

namespace odontoscope::cavity {
namespace {

struct Circle {
  double radius = std::numeric_limits<double>::infinity();
  double off = 0;  // root mean square of the points' distances to it
  double bow = 0;  // of the stretch: how far it leaves its chord
};

/// The plane that a stretch bends in: along its chord, and to the side where most of it lies.
struct Frame {
  Point3 origin;
  Direction along, side, up;
};

Frame frame_of(const std::vector<Point3>& line, std::size_t first, std::size_t last) {
  Frame frame{line[first], line[last] - line[first], {}, {}};
  frame.along = (1 / length(frame.along)) * frame.along;
  for (std::size_t i = first; i <= last; ++i) {
    const Direction off = line[i] - line[first];
    frame.side = frame.side + off + -dot(off, frame.along) * frame.along;
  }
  if (!(length(frame.side) > 0))
    frame.side = cross(frame.along, std::abs(frame.along.x) < 0.9 ? Direction{1, 0, 0} : Direction{0, 1, 0});
  frame.side = (1 / length(frame.side)) * frame.side;
  frame.up = cross(frame.along, frame.side);
  return frame;
}

/// Taubin's fit by Newton's method from 0, which its polynomial rises from on one side only.
Circle circle_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  double mx = 0, my = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mx += x[i] / count;
    my += y[i] / count;
  }
  double xx = 0, yy = 0, xy = 0, xz = 0, yz = 0, zz = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = x[i] - mx, v = y[i] - my, z = u * u + v * v;
    xx += u * u / count;
    yy += v * v / count;
    xy += u * v / count;
    xz += u * z / count;
    yz += v * z / count;
    zz += z * z / count;
  }
  const double z = xx + yy, covariance = xx * yy - xy * xy, a3 = 4 * z, a2 = -3 * z * z - zz;
  const double a1 = zz * z + 4 * covariance * z - xz * xz - yz * yz - z * z * z;
  const double a0 = xz * xz * yy + yz * yz * xx - zz * covariance - 2 * xz * yz * xy + z * z * covariance;
  double root = 0;
  constexpr int most_steps = 30;
  for (int i = 0; i < most_steps; ++i) {
    const double value = a0 + root * (a1 + root * (a2 + root * a3)), slope = a1 + root * (2 * a2 + 3 * a3 * root);
    if (!(std::abs(slope) > 0)) break;
    const double next = root - value / slope;
    if (!std::isfinite(next) || std::abs(next - root) <= 1e-14 * z) break;
    root = next;
  }
  Circle circle;
  const double det = root * root - root * z + covariance;
  const double cx = (xz * (yy - root) - yz * xy) / (2 * det), cy = (yz * (xx - root) - xz * xy) / (2 * det);
  circle.radius = std::sqrt(cx * cx + cy * cy + z);
  if (!std::isfinite(circle.radius)) return {};
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    squares += portable::square(portable::hypot(x[i] - mx - cx, y[i] - my - cy) - circle.radius) / count;
  circle.off = std::sqrt(squares);
  return circle;
}

Circle circle_of(const std::vector<Point3>& line, std::size_t first, std::size_t last) {
  const Frame frame = frame_of(line, first, last);
  std::vector<double> x, y;
  double up = 0, aside = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const Direction off = line[i] - frame.origin;
    x.push_back(dot(off, frame.along));
    y.push_back(dot(off, frame.side));
    up += portable::square(dot(off, frame.up)) / static_cast<double>(last - first + 1);
    aside += portable::square(y.back()) / static_cast<double>(last - first + 1);
  }
  Circle circle = circle_through(x, y);
  if (!std::isfinite(circle.radius)) circle.off = std::sqrt(aside);  // all in one line
  circle.off = portable::hypot(circle.off, std::sqrt(up));
  const double half = 0.5 * length(line[last] - line[first]);
  if (std::isfinite(circle.radius)) {
    const double rest = std::sqrt(std::max(circle.radius * circle.radius - half * half, 0.0));
    const bool beyond = *std::max_element(y.begin(), y.end()) > circle.radius;  // more than half a circle
    circle.bow = beyond ? circle.radius + rest : half * half / (circle.radius + rest);
  }
  return circle;
}

/// Few enough points for all stretches to be tried.
std::vector<Point3> thinned(const std::vector<Point3>& line) {
  if (line.size() <= limits::bend_points) return line;
  std::vector<Point3> made;
  for (std::size_t i = 0; i < limits::bend_points; ++i)
    made.push_back(line[i * (line.size() - 1) / (limits::bend_points - 1)]);
  return made;
}

/// Towards where the stretch bends, at its middle and half way to its ends.
double loosest(const std::vector<Point3>& line, std::size_t first, std::size_t last, const Looseness& loose) {
  const Frame frame = frame_of(line, first, last);
  double most = 0;
  for (const std::size_t quarter : {1u, 2u, 3u})
    most = std::max(most, loose(line[first + quarter * (last - first) / 4], frame.side));
  return most;
}

/// What is typical among short stretches.
double noise_of(const std::vector<Point3>& line, std::size_t reach) {
  std::vector<double> off;
  for (std::size_t i = 0; i + reach < line.size(); ++i) off.push_back(circle_of(line, i, i + reach).off);
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
  return off[off.size() / 2];
}

}  // namespace

Bend smallest_bend(const std::vector<Point3>& all, double width, const Looseness& loose) {
  Bend bend{std::numeric_limits<double>::infinity(), 0};
  const std::vector<Point3> line = thinned(all);
  double whole = 0;
  for (std::size_t i = 1; i < line.size(); ++i) whole += length(line[i] - line[i - 1]);
  if (line.size() < 5 || !(whole > 0)) return bend;
  const double step = whole / static_cast<double>(line.size() - 1);
  const auto reach =
      std::max<std::size_t>(4, static_cast<std::size_t>(std::lround(limits::bend_stretch * width / step)));
  if (reach >= line.size()) return bend;
  const double known = std::clamp(limits::bend_noise * noise_of(line, reach), limits::bend_finest * width,
                                  limits::bend_coarsest * width);
  std::size_t covered = 0;  // last point of the stretch before
  for (std::size_t first = 0; first + reach < line.size(); ++first) {
    std::size_t last = first + reach;
    Circle fit = circle_of(line, first, last);
    while (last + 1 < line.size()) {
      const Circle longer = circle_of(line, first, last + 1);
      if (longer.off > known) break;
      fit = longer;
      ++last;
    }
    if (last <= covered) continue;  // a part of it
    covered = last;
    if (fit.bow <= limits::bend_bow * known || fit.radius >= bend.radius) continue;
    const double off = std::max(known, loose ? loosest(line, first, last, loose) : 0);
    if (fit.bow <= limits::bend_bow * off) continue;
    // Middle and ends may be off either way; and the stretch goes on beyond the arc's ends until it is off by as much
    // again.
    bend = {fit.radius, 4 * fit.radius * off / fit.bow};
  }
  return bend;
}

}  // namespace odontoscope::cavity
