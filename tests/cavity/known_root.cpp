#include "tests/cavity/known_root.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/core/error.h"
#include "recon/mesh/vector.h"
#include "recon/sample/field_loops.h"
#include "tests/cavity/voids.h"

namespace odontoscope::test {
namespace {

constexpr double pi = std::numbers::pi;

Point3 on(const Point3& a, const Point3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

double length_of(const std::vector<Point3>& axis) {
  double sum = 0;
  for (std::size_t i = 1; i < axis.size(); ++i) sum += length(axis[i] - axis[i - 1]);
  return sum;
}

Point3 place(const std::vector<Point3>& axis, double along) {
  for (std::size_t i = 1; i < axis.size(); ++i) {
    const double piece = length(axis[i] - axis[i - 1]);
    if (along <= piece || i + 1 == axis.size())
      return on(axis[i - 1], axis[i], along / piece);  // straight on beyond the end
    along -= piece;
  }
  return axis.back();
}

/// Share of the way from a to b where it is nearest to p.
double foot(const Point3& p, const Point3& a, const Point3& b) {
  const Direction way = b - a;
  const double square = dot(way, way);
  return square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
}

/// From a tube's axis, as if it were round: what lies in the plane y = 0 across the axis counts less.
double across(const Direction& off, const Direction& way, double aside) {
  if (aside == 1) return length(off);
  const double along = dot(off, (1 / length(way)) * way);
  const Direction rest = off + (-along / length(way)) * way;
  return std::sqrt(along * along + off.y * off.y + (rest.x * rest.x + rest.z * rest.z) / (aside * aside));
}

double distance_to(const Point3& p, const KnownCanal& canal) {
  double nearest = std::numeric_limits<double>::infinity(), along = 0, at = 0, far = 0;
  for (std::size_t i = 1; i < canal.axis.size(); ++i) {
    const Point3 &a = canal.axis[i - 1], &b = canal.axis[i];
    const double t = foot(p, a, b), piece = length(b - a);
    const Direction off = p - on(a, b, t);
    if (length(off) < nearest) {
      nearest = length(off);
      at = along + t * piece;
      far = across(off, b - a, canal.aside);
    }
    along += piece;
  }
  return far - (canal.radius_above + (canal.radius_below - canal.radius_above) * at / along);
}

double distance_to(const Point3& p, const SideCanal& canal) {
  return length(p - on(canal.from, canal.end, foot(p, canal.from, canal.end))) - canal.radius;
}

double distance_to(const Point3& p, const Wing& wing) {
  return std::max({std::abs(p.y) - wing.thick / 2, wing.left - p.x, p.x - wing.right, p.z - wing.high, wing.low - p.z});
}

double distance_to(const Point3& p, const Gutter& gutter) {
  const double most = gutter.half_angle_deg * pi / 180, angle = std::clamp(std::atan2(p.y, p.x), -most, most);
  const Point3 middle{gutter.radius * std::cos(angle), gutter.radius * std::sin(angle),
                      std::clamp(p.z, gutter.low, 0.0)};
  return length(p - middle) - gutter.thick / 2;
}

/// Negative in the void; changes no faster than the place.
double void_at(const KnownRoot& root, Point3 p) {
  p.y /= root.oval;
  double nearest = length(p - Point3{}) - root.chamber;
  for (const KnownCanal& canal : root.canals) nearest = std::min(nearest, distance_to(p, canal));
  for (const SideCanal& canal : root.accessory) nearest = std::min(nearest, distance_to(p, canal));
  if (root.wing) nearest = std::min(nearest, distance_to(p, *root.wing));
  if (root.gutter) nearest = std::min(nearest, distance_to(p, *root.gutter));
  return nearest;
}

double block_at(const KnownRoot& root, const Point3& p) {
  const Point3 low{0, 0, root.block_low}, high{0, 0, root.block_high};
  return length(p - on(low, high, foot(p, low, high))) - root.block;
}

Point3 own_of(const KnownRoot& root, const Point3& p) {
  const double tilt = root.tilt_deg * pi / 180, spin = root.spin_deg * pi / 180;
  const double y = std::cos(tilt) * p.y + std::sin(tilt) * p.z, z = -std::sin(tilt) * p.y + std::cos(tilt) * p.z;
  return {std::cos(spin) * p.x + std::sin(spin) * y, -std::sin(spin) * p.x + std::cos(spin) * y, z};
}

/// Asks everywhere near a wall only.
std::vector<double> values_on(const KnownRoot& root, const sample::Grid& grid, double z) {
  constexpr std::size_t block = 8;
  std::vector<double> values(grid.columns * grid.rows);
  const auto value = [&](std::size_t column, std::size_t row) {
    const Point2 at = grid.at(column, row);
    const Point3 own = own_of(root, {at.x, at.y, z});
    return std::max(block_at(root, own), -void_at(root, own));
  };
  for (std::size_t row = 0; row < grid.rows; row += block)
    for (std::size_t column = 0; column < grid.columns; column += block) {
      const double middle = value(column + block / 2, row + block / 2);
      const bool near = std::abs(middle) < 1.5 * block * grid.step;
      for (std::size_t r = row; r < std::min(row + block, grid.rows); ++r)
        for (std::size_t c = column; c < std::min(column + block, grid.columns); ++c)
          values[r * grid.columns + c] = near ? value(c, r) : middle;
    }
  return values;
}

/// Marching squares put a point on a chord: onto the wall itself, so that contours are as narrow as their sides make
/// them and no narrower.
void onto_wall(const KnownRoot& root, double z, Polygon& loop) {
  constexpr double reach = 1e-4;
  for (Point2& p : loop) {
    const auto at = [&](double x, double y) { return void_at(root, own_of(root, {x, y, z})); };
    const double value = at(p.x, p.y), dx = (at(p.x + reach, p.y) - at(p.x - reach, p.y)) / (2 * reach),
                 dy = (at(p.x, p.y + reach) - at(p.x, p.y - reach)) / (2 * reach);
    const double square = dx * dx + dy * dy;
    if (square < 0.1) continue;  // about an end
    p = {p.x - value * dx / square, p.y - value * dy / square};
  }
}

/// With fewer points; those that come too close to each other for that, about to join, keep all as they were traced.
std::vector<Polygon> fine_holes(const KnownRoot& root, double z, const std::vector<Polygon>& traced) {
  std::vector<Polygon> moved = traced;
  for (Polygon& loop : moved) onto_wall(root, z, loop);
  try {
    return sample::thin(moved, {0.4, 0.001, 1e-4, 1e-6});
  } catch (const InternalError&) {
    return traced;
  }
}

/// Of a tube so stretched, between two places along it, by its formula: the rounded end, too.
double wall_area(const KnownCanal& canal, double stretch, double whole, double from, double to) {
  constexpr int along = 400, round = 240;
  const double axis = length_of(canal.axis);
  const auto radius = [&](double s) {
    const double r = canal.radius_above + (canal.radius_below - canal.radius_above) * std::min(s / axis, 1.0);
    return s <= axis ? r : std::sqrt(std::max(0.0, canal.radius_below * canal.radius_below - (s - axis) * (s - axis)));
  };
  const auto at = [&](double s, double turn) {
    return Point3{radius(s) * std::cos(turn), stretch * radius(s) * std::sin(turn), s};
  };
  double sum = 0;
  for (int i = 0; i < along; ++i) {
    const double s = from + (to - from) * i / along, t = std::min(from + (to - from) * (i + 1) / along, whole);
    for (int k = 0; k < round; ++k) {
      const double a = 2 * pi * k / round, b = 2 * pi * (k + 1) / round;
      sum += length(cross(at(t, b) - at(s, a), at(t, a) - at(s, b))) / 2;
    }
  }
  return sum;
}

/// As MeasuredCanal says, of the exact line.
double schneider(const KnownCanal& canal, double begin, double whole) {
  const Point3 orifice = place(canal.axis, begin), end = place(canal.axis, whole);
  const double size = whole - begin, axis = length_of(canal.axis);
  const Direction long_axis = place(canal.axis, begin + size / 3) - orifice;
  for (double s = begin + size / 3; s < axis; s += size / 2000) {
    const Point3 p = place(canal.axis, s);
    const double radius = canal.radius_above + (canal.radius_below - canal.radius_above) * s / axis;
    if (length(cross(long_axis, p - orifice)) / length(long_axis) <= 0.5 * radius) continue;
    return std::atan2(length(cross(long_axis, end - p)), dot(long_axis, end - p)) * 180 / pi;
  }
  return 0;
}

/// From the canal's wall to the block's outside.
double thinnest_wall(const KnownRoot& root, const KnownCanal& canal, double begin, double whole) {
  const double axis = length_of(canal.axis);
  double least = std::numeric_limits<double>::infinity();
  constexpr int along = 400, round = 60;
  begin += 0.5 * canal.radius_above;  // above, the wall is as much the chamber's
  for (int i = 0; i <= along; ++i) {
    const double s = begin + (whole - begin) * i / along, t = std::min(s, axis);
    const double r = canal.radius_above + (canal.radius_below - canal.radius_above) * t / axis;
    const double here = s <= axis ? r : std::sqrt(std::max(0.0, r * r - (s - axis) * (s - axis)));
    const Direction way = place(canal.axis, s + 1e-3) - place(canal.axis, s - 1e-3);
    const Direction side = cross({0, 1, 0}, way);
    const Direction u = (1 / length(side)) * side;
    for (int k = 0; k < round; ++k) {
      const double turn = 2 * pi * k / round;
      const Point3 p = place(canal.axis, s);
      const double wide = canal.aside * here * std::cos(turn);
      const Point3 wall{p.x + wide * u.x, root.oval * (p.y + here * std::sin(turn)), p.z + wide * u.z};
      least = std::min(least, -block_at(root, wall));
    }
  }
  return least;
}

}  // namespace

Point3 as_it_lies(const KnownRoot& root, const Point3& own) {
  const double tilt = root.tilt_deg * pi / 180, spin = root.spin_deg * pi / 180;
  const double x = std::cos(spin) * own.x - std::sin(spin) * own.y, y = std::sin(spin) * own.x + std::cos(spin) * own.y;
  return {x, std::cos(tilt) * y - std::sin(tilt) * own.z, std::sin(tilt) * y + std::cos(tilt) * own.z};
}

Cavity void_of(const KnownRoot& root, double grid) {
  const double wide = std::max(root.oval, 1.0);
  Point3 low{-root.chamber, -wide * root.chamber, -root.chamber}, high{root.chamber, wide * root.chamber, root.chamber};
  for (const KnownCanal& canal : root.canals) {
    const double room = std::max(canal.radius_above, canal.radius_below) * wide * canal.aside;
    for (const Point3& p : canal.axis) {
      low = {std::min(low.x, p.x - room), std::min(low.y, p.y - room), std::min(low.z, p.z - room)};
      high = {std::max(high.x, p.x + room), std::max(high.y, p.y + room), std::max(high.z, p.z + room)};
    }
  }
  Point3 from = as_it_lies(root, low), to = from;  // of the box's corners
  for (int corner = 1; corner < 8; ++corner) {
    const Point3 p =
        as_it_lies(root, {corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
    from = {std::min(from.x, p.x), std::min(from.y, p.y), std::min(from.z, p.z)};
    to = {std::max(to.x, p.x), std::max(to.y, p.y), std::max(to.z, p.z)};
  }
  const double room = 3 * grid;
  return void_of([&](const Point3& p) { return void_at(root, own_of(root, p)); },
                 {from.x - room, from.y - room, from.z - room}, {to.x + room, to.y + room, to.z + room}, grid);
}

ContourStack slices_of(const KnownRoot& root, double spacing) {
  constexpr double step = 0.05, off = 0.0137;  // off symmetries
  const Point3 low = as_it_lies(root, {0, 0, root.block_low}), high = as_it_lies(root, {0, 0, root.block_high});
  ContourStack stack;
  for (double z = low.z - root.block + spacing / 2 + off; z < high.z + root.block; z += spacing) {
    // Where the block's middle line is nearest to this height, and all about it.
    const double y_low = std::min(low.y, high.y) - root.block - 1, y_high = std::max(low.y, high.y) + root.block + 1,
                 wide = root.block + 1;
    sample::Grid grid{{-wide + off, y_low + off},
                      step,
                      static_cast<std::size_t>(2 * wide / step),
                      static_cast<std::size_t>((y_high - y_low) / step),
                      {}};
    grid.values = values_on(root, grid, z);
    Slice slice{z, {}};
    std::vector<Polygon> outer, holes;  // the block's outside needs no such fineness
    for (Polygon& loop : sample::trace(grid, 1e-4)) (signed_area(loop) > 0 ? outer : holes).push_back(std::move(loop));
    for (Polygon& loop : sample::thin(outer, {0.6, 0.005, 1e-4, 1e-6}))
      slice.contours.push_back({"dentine", std::move(loop)});
    for (Polygon& loop : fine_holes(root, z, holes)) slice.contours.push_back({"dentine", std::move(loop)});
    if (!slice.contours.empty()) stack.slices.push_back(std::move(slice));
  }
  return stack;
}

KnownFigures figures_of(const KnownRoot& root, const KnownCanal& canal) {
  const double axis = length_of(canal.axis);
  const auto radius = [&](double s) {
    return canal.radius_above + (canal.radius_below - canal.radius_above) * std::min(s / axis, 1.0);
  };
  double begin = 0, whole = axis + canal.radius_below;
  const auto leaves_chamber = [&](double s) {
    return std::hypot(length(place(canal.axis, s) - Point3{}), radius(s)) >= root.chamber;
  };
  while (!leaves_chamber(begin)) begin += 1e-3;
  for (double s = begin; s < axis; s += 1e-3)
    if (block_at(root, place(canal.axis, s)) > 0) {
      whole = s;
      break;
    }
  const bool open = whole < axis;
  KnownFigures known;
  known.orifice = as_it_lies(root, place(canal.axis, begin));
  known.end = as_it_lies(root, place(canal.axis, whole));
  known.length = whole - begin;
  std::vector<double> radii;
  for (double s = begin; s <= whole; s += 1e-2) radii.push_back(radius(s));
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
  const double last = whole - 2 * radii[radii.size() / 2];
  known.narrowest = std::numeric_limits<double>::infinity();
  double sum = 0, count = 0;
  for (double s = begin; s <= last; s += 1e-2) {
    known.narrowest = std::min(known.narrowest, 2 * radius(s));
    sum += 2 * radius(s);
    ++count;
  }
  known.mean_width = sum / count;
  known.schneider_deg = schneider(canal, begin, whole);
  known.thinnest_wall = open ? 0 : thinnest_wall(root, canal, begin, whole);
  const auto half_width = [&](double s) {
    return s <= axis ? radius(s)
                     : std::sqrt(std::max(0.0, canal.radius_below * canal.radius_below - (s - axis) * (s - axis)));
  };
  for (const double far : {1.0, 2.0, 3.0, 4.0}) {
    known.apical_width.push_back(2 * half_width(whole - far));
    known.apical_area.push_back(pi * root.oval * canal.aside * half_width(whole - far) * half_width(whole - far));
  }
  for (int third = 0; third < 3; ++third) {
    const double from = begin + third * known.length / 3, to = from + known.length / 3;
    double volume = 0;
    constexpr int parts = 2000;
    for (int i = 0; i < parts; ++i)
      volume += (to - from) / parts * pi * root.oval * canal.aside *
                std::pow(half_width(from + (to - from) * (i + 0.5) / parts), 2);
    known.third_volume.push_back(volume);
    known.third_area.push_back(wall_area(canal, root.oval * canal.aside, whole, from, to));
  }
  return known;
}

}  // namespace odontoscope::test
