#include "tests/cavity/voids.h"

#include <algorithm>
#include <cmath>

#include "recon/distance/marching_cubes.h"

namespace odontoscope::test {
namespace {

double segment_distance(const Point3& p, const Point3& a, const Point3& b) {
  const double x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
  const double t = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y + (p.z - a.z) * z) / (x * x + y * y + z * z), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y, p.z - a.z - t * z);
}

}  // namespace

Cavity void_of(const Distance& distance, const Point3& low, const Point3& high, double grid_step) {
  Grid grid;
  // Off any symmetry of the shapes, so that no grid point lies on a wall.
  grid.x0 = low.x + 0.137 * grid_step;
  grid.y0 = low.y + 0.219 * grid_step;
  grid.dx = grid.dy = grid_step;
  const auto steps = [&](double from, double to) { return static_cast<std::size_t>(std::ceil((to - from) / grid_step)) + 2; };
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
  for (int i = 0; i <= pieces; ++i) points.push_back({radius * std::cos(angle * i / pieces), 0, -radius * std::sin(angle * i / pieces)});
  return points;
}

Cavity straight_tube(double length, double radius) {
  return void_of([&](const Point3& p) { return tube_distance(p, {{0, 0, 0}, {0, 0, -length}}, radius); },
                 {-1.5 * radius, -1.5 * radius, -length - 1.5 * radius}, {1.5 * radius, 1.5 * radius, 1.5 * radius}, radius / 8);
}

Cavity bent_tube(double bend, double angle, double radius) {
  const std::vector<Point3> axis = arc(bend, angle);
  return void_of([&](const Point3& p) { return tube_distance(p, axis, radius); },
                 {-bend - 2 * radius, -2 * radius, -bend - 2 * radius}, {bend + 2 * radius, 2 * radius, 2 * radius}, radius / 9);
}

Cavity ring(double bend, double radius) {
  return void_of([&](const Point3& p) { return std::hypot(std::hypot(p.x, p.y) - bend, p.z) - radius; },
                 {-bend - 2 * radius, -bend - 2 * radius, -2 * radius}, {bend + 2 * radius, bend + 2 * radius, 2 * radius}, radius / 9);
}

Cavity y_shape(double leg, double radius) {
  const double x = leg * std::sqrt(0.75), z = -leg / 2;
  return void_of(
      [&](const Point3& p) {
        return std::min({tube_distance(p, {{0, 0, 0}, {0, 0, leg}}, radius), tube_distance(p, {{0, 0, 0}, {x, 0, z}}, radius),
                         tube_distance(p, {{0, 0, 0}, {-x, 0, z}}, radius)});
      },
      {-x - 2 * radius, -2 * radius, z - 2 * radius}, {x + 2 * radius, 2 * radius, leg + 2 * radius}, radius / 9);
}

Cavity three_canals(const ThreeCanals& shape) {
  return void_of(
      [&](const Point3& p) {
        double nearest = ball_distance(p, {}, shape.chamber);
        for (std::size_t i = 0; i < shape.ends.size(); ++i) nearest = std::min(nearest, tube_distance(p, {{0, 0, 0}, shape.ends[i]}, shape.radii[i]));
        return nearest;
      },
      {-4, -3, -10}, {3.5, 3, 2}, 0.06);
}

}  // namespace odontoscope::test
