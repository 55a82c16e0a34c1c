#include "tests/cavity/canal_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "recon/delaunay/reconstruct.h"
#include "recon/sample/trace.h"

namespace odontoscope::test {
namespace {

constexpr double block_radius = 4;

/// Sebastiano Vigna's SplitMix64: the same numbers everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  double between(double low, double high) {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

double distance_to(const RootShape& shape, const Point3& p) {
  double nearest = ball_distance(p, {}, shape.chamber);
  for (const std::vector<Point3>& axis : shape.canals) nearest = std::min(nearest, tube_distance(p, axis, shape.radius));
  return nearest;
}

std::vector<sample::Loop> loops_of(const RootShape& shape, double z) {
  constexpr double step = 0.08;
  const double wide = 2.6, deep = shape.chamber + 0.6;
  sample::Grid grid{{-wide, -deep}, step, static_cast<std::size_t>(2 * wide / step), static_cast<std::size_t>(2 * deep / step), {}};
  for (std::size_t row = 0; row < grid.rows; ++row)
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const Point2 at = grid.at(column, row);
      grid.values.push_back(distance_to(shape, {at.x, at.y, z}));
    }
  return sample::trace(grid, 0.002);   // all points: loops about to join come too close to each other for thinning
}

double length_of(const std::vector<Point3>& axis, double radius) {
  double sum = radius;
  for (std::size_t i = 1; i < axis.size(); ++i) sum += length(axis[i] - axis[i - 1]);
  return sum;
}

}  // namespace

RootShape random_root(std::uint64_t seed) {
  static const std::array<std::string, 8> types = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  Dice dice(seed);
  RootShape shape = root_of_type(types[seed % types.size()], dice.between(1.08, 1.25));
  const double tall = dice.between(0.9, 1.15), wide = dice.between(0.95, 1.2);
  for (std::vector<Point3>& axis : shape.canals)
    for (Point3& p : axis) p = {wide * p.x, wide * p.y, tall * p.z};
  shape.radius = dice.between(0.22, 0.36);
  shape.chamber = dice.between(1.15, 1.45);
  return shape;
}

ContourStack slices_of(const RootShape& shape, double spacing) {
  double low = 0;
  for (const std::vector<Point3>& axis : shape.canals)
    for (const Point3& p : axis) low = std::min(low, p.z);
  constexpr int corners = 48;
  constexpr double off = 0.0137;   // of symmetries
  ContourStack stack;
  for (int k = 0;; ++k) {
    const double z = low - shape.radius - 1.5 + off + k * spacing;
    if (z > shape.chamber + 1) break;
    Slice slice{z, {}};
    Contour outer;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      outer.points.push_back({block_radius * std::cos(angle), block_radius * std::sin(angle)});
    }
    slice.contours.push_back(outer);
    for (sample::Loop& loop : loops_of(shape, z)) {
      std::reverse(loop.begin(), loop.end());
      slice.contours.push_back({"tooth", std::move(loop)});
    }
    stack.slices.push_back(std::move(slice));
  }
  return stack;
}

FamilyVerdict judge(const RootShape& shape, double spacing) {
  const Reconstruction tooth = reconstruct(slices_of(shape, spacing));
  std::vector<StructureSurface> model;
  for (const Solid& solid : tooth.solids) model.push_back({solid.structure, &solid.surface});
  const Anatomy made = measure_anatomy(model);
  FamilyVerdict verdict;
  const bool one_root = made.roots.size() == 1;
  verdict.counted = one_root && made.canals.size() == shape.canals.size() && made.roots[0].vertucci == shape.type && made.roots[0].sections == shape.sections;
  verdict.told = fmt::format("{} expected, told {} with {} canals, {} horns, {} branches", shape.type, one_root ? made.roots[0].vertucci : fmt::format("{} roots", made.roots.size()), made.canals.size(),
                             made.horns, made.other_branches);
  if (made.canals.size() != shape.canals.size()) return verdict;
  std::vector<double> known, found;
  for (const std::vector<Point3>& axis : shape.canals) known.push_back(length_of(axis, shape.radius));
  for (const MeasuredCanal& canal : made.canals) {
    found.push_back(length(canal.orifice - Point3{}) + canal.length);
    const double width = canal.narrowest ? canal.narrowest->width : canal.mean_width;
    verdict.width_error = std::max(verdict.width_error, std::abs(width / (2 * shape.radius) - 1));
  }
  std::sort(known.begin(), known.end());
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < known.size(); ++i) verdict.length_error = std::max(verdict.length_error, std::abs(found[i] / known[i] - 1));
  return verdict;
}

}  // namespace odontoscope::test
