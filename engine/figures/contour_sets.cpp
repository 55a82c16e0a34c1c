#include "engine/figures/contour_sets.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "recon/sample/sample_tooth.h"

namespace odontoscope::figures {
namespace {

using Ring = std::vector<Point2>;

/// Points at even angles, at the radius that `radius` gives for the angle.
Ring polar(int count, Point2 centre, double first_angle, auto radius) {
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = first_angle + 2 * std::numbers::pi * i / count;
    ring.push_back({centre.x + radius(angle) * std::cos(angle), centre.y + radius(angle) * std::sin(angle)});
  }
  return ring;
}

Ring polygon(int corners, double radius, Point2 centre, double first_angle = 0) {
  return polar(corners, centre, first_angle, [radius](double) { return radius; });
}

Slice slice_of(double z, std::vector<Ring> rings) {
  Slice slice{z, {}};
  for (Ring& ring : rings) slice.contours.push_back({"tooth", std::move(ring)});
  return slice;
}

void keep(ContourStack& stack, const std::string& structure) {
  for (Slice& slice : stack.slices)
    std::erase_if(slice.contours, [&](const Contour& contour) { return contour.structure != structure; });
}

}  // namespace

ContourStack shifted_stumps(double radii) {
  constexpr double radius = 2;
  constexpr int points = 48;
  ContourStack stack;
  for (std::size_t k = 0; k < 2 * stump_slices; ++k) {
    const double shift = k < stump_slices ? 0 : radii * radius;
    stack.slices.push_back(slice_of(stump_spacing * static_cast<double>(k), {polygon(points, radius, {shift, 0})}));
  }
  return stack;
}

ContourStack well_placed_pair() {
  return {{slice_of(0, {Ring{{-2.2, -0.9}, {0.2, -1.2}, {2.3, -0.8}, {2.0, 0.9}, {-0.1, 1.2}, {-2.0, 0.8}}}),
           slice_of(2.2, {Ring{{-0.9, -2.1}, {0.8, -2.3}, {1.2, 0.1}, {0.9, 2.2}, {-0.8, 2.0}, {-1.2, -0.2}}})},
          {}};
}

ContourStack one_over_two() {
  return {{slice_of(0, {polygon(6, 1.25, {-1.9, 0}, 0.2), polygon(6, 1.25, {1.9, 0}, -0.1)}),
           slice_of(2.2, {Ring{{-1.9, -1.2},
                               {0.1, -1.35},
                               {2.0, -1.1},
                               {2.6, 0.1},
                               {1.8, 1.25},
                               {-0.2, 1.3},
                               {-2.1, 1.1},
                               {-2.7, -0.1}}})},
          {}};
}

ContourStack badly_placed_pair() {
  return {{slice_of(0, {polygon(6, 1.5, {-2.1, 0}, 0.2)}), slice_of(2.2, {polygon(6, 1.5, {2.1, 0.1}, 0.5)})}, {}};
}

ContourStack crown_sections() {
  constexpr int points = 64;
  const auto lower = [](double angle) { return 3.2 + 0.35 * std::cos(4 * angle); };
  const auto upper = [](double angle) { return 3.9 + 0.5 * std::cos(4 * angle) + 0.25 * std::cos(angle); };
  return {{slice_of(0, {polar(points, {0, 0}, 0, lower)}), slice_of(1.6, {polar(points, {0.25, 0}, 0, upper)})}, {}};
}

ContourStack part_of(const ContourStack& tooth, double low, double high) {
  ContourStack part;
  part.source = tooth.source;
  for (const Slice& slice : tooth.slices)
    if (slice.z >= low && slice.z <= high) part.slices.push_back(slice);
  return part;
}

ContourStack roots_and_trunk() {
  const auto oval = [](int count, Point2 centre, double half_x, double half_y) {
    Ring ring = polygon(count, 1, {}, 0.1);
    for (Point2& p : ring) p = {centre.x + half_x * p.x, centre.y + half_y * p.y};
    return ring;
  };
  return {{slice_of(0, {oval(12, {-2.4, 0}, 1.5, 2.4), oval(6, {-2.4, 0}, 0.45, 0.8), oval(12, {2.4, 0}, 1.5, 2.4),
                        oval(6, {2.4, 0}, 0.45, 0.8)}),
           slice_of(3, {oval(20, {0, 0}, 4.3, 2.9), oval(10, {0, 0}, 2.7, 1.1)})},
          {}};
}

ContourStack molar_furcation() {
  constexpr double below = 3.2, above = 1.8;
  const double furcation = sample_facts(ToothKind::molar).furcation_z;
  ContourStack tooth = sample_tooth(ToothKind::molar, {.walls = SampleWalls::apart, .hollow_dentine = false});
  keep(tooth, "dentine");
  return part_of(tooth, furcation - below, furcation + above);
}

}  // namespace odontoscope::figures
