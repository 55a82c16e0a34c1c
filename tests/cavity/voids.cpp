#include "tests/cavity/voids.h"

#include <algorithm>
#include <cmath>

#include "recon/distance/marching_cubes.h"

namespace odontoscope::test {
namespace {

double segment_distance(const Point3& p, const Point3& a, const Point3& b) {
  const double x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  const double t =
      std::clamp(((p.x - a.x) * x + (p.y - a.y) * y + (p.z - a.z) * z) / (x * x + y * y + z * z), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y, p.z - a.z - t * z);
}

}  // namespace

Cavity void_of(const Distance& distance, const Point3& low, const Point3& high, double grid_step) {
  Grid grid;
  // Off any symmetry of the shapes, so that no grid point lies on a wall.
  grid.x0 = low.x + 0.137 * grid_step;
  grid.y0 = low.y + 0.219 * grid_step;
  grid.dx = grid.dy = grid_step;
  const auto steps = [&](double from, double to) {
    return static_cast<std::size_t>(std::ceil((to - from) / grid_step)) + 2;
  };
  grid.columns = steps(low.x, high.x);
  grid.rows = steps(low.y, high.y);
  for (std::size_t layer = 0; layer < steps(low.z, high.z); ++layer)
    grid.layers.push_back({low.z + (static_cast<double>(layer) + 0.353) * grid_step, {}});
  Field field{"void", std::vector<double>(grid.size())};
  for (std::size_t layer = 0; layer < grid.layers.size(); ++layer)
    for (std::size_t row = 0; row < grid.rows; ++row)
      for (std::size_t column = 0; column < grid.columns; ++column)
        field.values[grid.index(column, row, layer)] = distance(grid.point(column, row, layer));
  const SurfaceMesh body = march(grid, field, CaseTable::consistent).mesh;
  return voids_filled_by("body", body).at(0);
}

double tube_distance(const Point3& p, const std::vector<Point3>& axis, double radius) {
  double nearest = segment_distance(p, axis[0], axis[1]);
  for (std::size_t i = 2; i < axis.size(); ++i) nearest = std::min(nearest, segment_distance(p, axis[i - 1], axis[i]));
  return nearest - radius;
}

double ball_distance(const Point3& p, const Point3& centre, double radius) {
  return std::hypot(p.x - centre.x, p.y - centre.y, p.z - centre.z) - radius;
}

std::vector<Point3> arc(double radius, double angle) {
  constexpr int pieces = 60;
  std::vector<Point3> points;
  for (int i = 0; i <= pieces; ++i)
    points.push_back({radius * std::cos(angle * i / pieces), 0, -radius * std::sin(angle * i / pieces)});
  return points;
}

Cavity straight_tube(double length, double radius) {
  return void_of(
      [&](const Point3& p) {
        return tube_distance(p, {{0, 0, 0}, {0, 0, -length}}, radius);
      },
      {-1.5 * radius, -1.5 * radius, -length - 1.5 * radius}, {1.5 * radius, 1.5 * radius, 1.5 * radius}, radius / 8);
}

Cavity bent_tube(double bend, double angle, double radius) {
  const std::vector<Point3> axis = arc(bend, angle);
  return void_of([&](const Point3& p) { return tube_distance(p, axis, radius); },
                 {-bend - 2 * radius, -2 * radius, -bend - 2 * radius}, {bend + 2 * radius, 2 * radius, 2 * radius},
                 radius / 9);
}

Cavity ring(double bend, double radius) {
  return void_of([&](const Point3& p) { return std::hypot(std::hypot(p.x, p.y) - bend, p.z) - radius; },
                 {-bend - 2 * radius, -bend - 2 * radius, -2 * radius},
                 {bend + 2 * radius, bend + 2 * radius, 2 * radius}, radius / 9);
}

Cavity y_shape(double leg, double radius) {
  const double x = leg * std::sqrt(0.75), z = -leg / 2;
  return void_of(
      [&](const Point3& p) {
        return std::min({tube_distance(p, {{0, 0, 0}, {0, 0, leg}}, radius),
                         tube_distance(p, {{0, 0, 0}, {x, 0, z}}, radius),
                         tube_distance(p, {{0, 0, 0}, {-x, 0, z}}, radius)});
      },
      {-x - 2 * radius, -2 * radius, z - 2 * radius}, {x + 2 * radius, 2 * radius, leg + 2 * radius}, radius / 9);
}

Cavity three_canals(const ThreeCanals& shape) {
  return void_of(
      [&](const Point3& p) {
        double nearest = ball_distance(p, {}, shape.chamber);
        for (std::size_t i = 0; i < shape.ends.size(); ++i)
          nearest = std::min(nearest, tube_distance(p, {{0, 0, 0}, shape.ends[i]}, shape.radii[i]));
        return nearest;
      },
      {-4, -3, -10}, {3.5, 3, 2}, 0.06);
}

namespace {

/// Without corners, but for those in the root's middle, where canals part and join.
std::vector<Point3> rounded(const std::vector<Point3>& axis) {
  constexpr int pieces = 12;
  constexpr double share = 0.45;  // of the way to the next corner
  const auto between = [](const Point3& a, const Point3& b, double t) {
    return Point3{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
  };
  std::vector<Point3> made{axis.front()};
  for (std::size_t i = 1; i + 1 < axis.size(); ++i) {
    const Point3 from = between(axis[i], axis[i - 1], share), to = between(axis[i], axis[i + 1], share);
    for (int k = 0; axis[i].x != 0 && k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      made.push_back(between(between(from, axis[i], t), between(axis[i], to, t), t));
    }
    if (axis[i].x == 0) made.push_back(axis[i]);
  }
  made.push_back(axis.back());
  return made;
}

RootShape angular_root(const std::string& type, double uneven) {
  const Point3 top{0, 0, 0};
  // The same height on either side of the root's middle plane.
  const auto left = [](double x, double z) { return Point3{-x, 0, z}; };
  const auto right = [&](double x, double z) { return Point3{uneven * x, 0, z}; };
  const auto middle = [](double z) { return Point3{0, 0, z}; };
  if (type == "I") return {type, {1}, {{top, middle(-9)}}};
  if (type == "II")
    return {
        type, {2, 1}, {{top, left(1.1, -3), middle(-6), middle(-9)}, {top, right(1.1, -3), middle(-6), middle(-9)}}};
  if (type == "III")
    return {type,
            {1, 2, 1},
            {{top, middle(-3), left(1, -5), middle(-7), middle(-10)},
             {top, middle(-3), right(1, -5), middle(-7), middle(-10)}}};
  if (type == "IV") return {type, {2}, {{top, left(1.2, -4), left(1.2, -9)}, {top, right(1.2, -4), right(1.2, -8.5)}}};
  if (type == "V") return {type, {1, 2}, {{top, middle(-4.5), left(1.3, -9)}, {top, middle(-4.5), right(1.3, -8.7)}}};
  if (type == "VI")
    return {type,
            {2, 1, 2},
            {{top, left(1.1, -3), middle(-5), middle(-7), left(1.1, -10)},
             {top, right(1.1, -3), middle(-5), middle(-7), right(1.1, -9.8)}}};
  if (type == "VII")
    return {type,
            {1, 2, 1, 2},
            {{top, middle(-2.8), left(0.9, -4.4), middle(-6), middle(-7.6), left(1.1, -10.6)},
             {top, middle(-2.8), right(0.9, -4.4), middle(-6), middle(-7.6), right(1.1, -10.4)}}};
  return {
      type,
      {3},
      {{top, {-1.5, 0, -4}, {-1.5, 0, -9}}, {top, {1.2, 1, -4}, {1.2, 1, -8.5}}, {top, {1.2, -1, -4}, {1.2, -1, -8}}}};
}

}  // namespace

RootShape root_of_type(const std::string& type, double uneven) {
  RootShape shape = angular_root(type, uneven);
  constexpr double tall = 1.25;
  for (std::vector<Point3>& axis : shape.canals) {
    for (Point3& p : axis) p.z *= tall;
    axis = rounded(axis);
  }
  return shape;
}

Cavity void_of_root(const RootShape& shape) {
  const double room = 1.4 * shape.radius;
  Point3 low{-shape.chamber, -shape.chamber, 0}, high{shape.chamber, shape.chamber, shape.chamber + room};
  for (const std::vector<Point3>& axis : shape.canals) {
    for (const Point3& p : axis) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return void_of(
      [&](const Point3& p) {
        double nearest = ball_distance(p, {}, shape.chamber);
        for (const std::vector<Point3>& axis : shape.canals)
          nearest = std::min(nearest, tube_distance(p, axis, shape.radius));
        return nearest;
      },
      {low.x - room, low.y - room, low.z - room}, {high.x + room, high.y + room, high.z}, shape.radius / 8);
}

}  // namespace odontoscope::test
