#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odontoscope::test {
namespace {

constexpr double pi = std::numbers::pi;

Ring polar(int count, double first_angle, auto radius_at) {
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = first_angle + 2 * pi * i / count;
    ring.push_back({radius_at(i) * std::cos(angle), radius_at(i) * std::sin(angle)});
  }
  return ring;
}

Ring at(Ring ring, Point2 centre) {
  for (Point2& p : ring) p = {p.x + centre.x, p.y + centre.y};
  return ring;
}

}  // namespace

Ring regular_polygon(int corners, double radius, Point2 centre, double first_angle) {
  return at(polar(corners, first_angle, [&](int) { return radius; }), centre);
}

Ring circle(double radius, Point2 centre) { return regular_polygon(round_points, radius, centre); }

Ring ellipse(double half_x, double half_y, Point2 centre) {
  Ring ring = circle(1);
  for (Point2& p : ring) p = {p.x * half_x, p.y * half_y};
  return at(ring, centre);
}

Ring rectangle(Point2 low, Point2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

Ring lattice_square(int low_x, int low_y, int side) {
  Ring ring;
  const auto add = [&](int x, int y) { ring.push_back({double(low_x + x), double(low_y + y)}); };
  for (int i = 0; i < side; ++i) add(i, 0);
  for (int i = 0; i < side; ++i) add(side, i);
  for (int i = 0; i < side; ++i) add(side - i, side);
  for (int i = 0; i < side; ++i) add(0, side - i);
  return ring;
}

Ring c_shape(double outer, double inner, double half_mouth) {
  Ring ring;
  constexpr int steps = 40;
  const auto add = [&](double radius, double angle) {
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  };
  const double sweep = 2 * (pi - half_mouth);
  for (int i = 0; i <= steps; ++i) add(outer, half_mouth + sweep * i / steps);
  for (int i = steps; i >= 0; --i) add(inner, half_mouth + sweep * i / steps);
  return ring;
}

Ring star(int spikes, double tip, double notch, double first_angle) {
  return polar(2 * spikes, first_angle, [&](int i) { return i % 2 == 0 ? tip : notch; });
}

Ring comb(int teeth, double length, double thickness) {
  Ring ring{{0, -thickness}, {2.0 * teeth - 1, -thickness}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = 2.0 * i, right = left + 1;
    ring.insert(ring.end(),
                {{right, 0}, {left + 0.5 + thickness, length}, {left + 0.5 - thickness, length}, {left, 0}});
  }
  return ring;
}

ContourStack stack_of(const std::vector<std::vector<Ring>>& slices) {
  ContourStack stack;
  for (const std::vector<Ring>& rings : slices) {
    Slice slice{spacing * double(stack.slices.size()), {}};
    for (const Ring& ring : rings) slice.contours.push_back({"tooth", ring});
    stack.slices.push_back(slice);
  }
  return stack;
}

ContourStack moved(ContourStack stack, Point2 by) {
  for (Slice& slice : stack.slices)
    for (Contour& contour : slice.contours) contour.points = at(contour.points, by);
  return stack;
}

ContourStack scaled(ContourStack stack, double factor) {
  for (Slice& slice : stack.slices) {
    slice.z *= factor;
    for (Contour& contour : slice.contours)
      for (Point2& p : contour.points) p = {p.x * factor, p.y * factor};
  }
  return stack;
}

ContourStack turned(ContourStack stack, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Slice& slice : stack.slices)
    for (Contour& contour : slice.contours)
      for (Point2& p : contour.points) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return stack;
}

ContourStack shifted_circles(double radii) {
  constexpr double radius = 2;
  return stack_of({{circle(radius)}, {circle(radius, {radii * radius, 0})}});
}

ContourStack annulus_over_shifted_annulus() {
  return stack_of({{circle(3), circle(1)}, {circle(3, {0.4, 0.1}), circle(1, {0.4, 0.1})}});
}

ContourStack annulus_over_disc() { return stack_of({{circle(3), circle(1)}, {circle(3, {0.2, 0})}}); }

ContourStack annulus_over_disc_with_two_holes() {
  return stack_of({{circle(4), ellipse(2.2, 1)}, {circle(4), circle(0.6, {-1.2, 0}), circle(0.6, {1.2, 0})}});
}

ContourStack one_over(int count) {
  std::vector<Ring> below;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    below.push_back(circle(1, {2 * std::cos(angle), 2 * std::sin(angle)}));
  }
  return stack_of({below, {circle(3.2)}});
}

ContourStack two_over_two_crosswise() {
  return stack_of({{ellipse(4, 0.7, {0, -1.8}), ellipse(4, 0.7, {0, 1.8})},
                   {ellipse(0.7, 4, {-1.8, 0}), ellipse(0.7, 4, {1.8, 0})}});
}

ContourStack drifting_canal() {
  std::vector<std::vector<Ring>> slices;
  for (int i = 0; i < 4; ++i) slices.push_back({circle(4), circle(0.8, {-0.6 + 0.4 * i, 0.1 * i})});
  return stack_of(slices);
}

ContourStack identical_lattice_squares() { return stack_of({{lattice_square(0, 0, 4)}, {lattice_square(0, 0, 4)}}); }

ContourStack lattice_square_over_shifted(int by_x, int by_y) {
  return stack_of({{lattice_square(0, 0, 6)}, {lattice_square(by_x, by_y, 6)}});
}

ContourStack polygon_over_turned_polygon(int corners) {
  return stack_of({{regular_polygon(corners, 2)}, {regular_polygon(corners, 2, {}, pi / corners)}});
}

ContourStack alone_in_the_middle() { return stack_of({{}, {ellipse(2, 1)}, {}}); }

ContourStack alone_at_the_end() { return stack_of({{ellipse(2, 1)}, {}}); }

ContourStack alone_beside_a_column() { return stack_of({{circle(2)}, {circle(2), circle(0.5, {5, 0})}, {circle(2)}}); }

ContourStack empty_slice_between() {
  return stack_of({{circle(2)}, {circle(2, {0.2, 0})}, {}, {circle(2)}, {circle(2, {0.1, 0.1})}});
}

ContourStack islands_nested_four_deep() {
  const std::vector<Ring> nest{circle(4), circle(3), circle(2), circle(1)};
  return stack_of({nest, nest, nest});
}

ContourStack c_with_island() {
  const std::vector<Ring> slice{c_shape(4, 2.5, 0.6), circle(0.8, {1.2, 0})};
  return stack_of({slice, slice});
}

ContourStack ring_over_crescent() {
  const std::vector<Ring> whole{circle(4), circle(3.7)};
  return stack_of({{c_shape(4, 3.7, 2.2)}, whole, whole});
}

ContourStack ring_between_crescents() {
  const Ring below = c_shape(4, 3.7, 1.8);
  Ring above = below;
  for (Point2& p : above) p = {-p.x, -p.y};
  return stack_of({{below}, {circle(4), circle(3.7)}, {above}});
}

ContourStack crescent_between_stubs() {
  const std::vector<Ring> stub{rectangle({-4.1, -0.3}, {-3.6, 0.3})};
  return stack_of({stub, {c_shape(4, 3.7, 0.3)}, stub});
}

ContourStack hole_that_opens_outside() {
  const std::vector<Ring> disc{circle(4)}, annulus{circle(4), circle(2)}, open{c_shape(4, 2, 0.6)};
  return stack_of({disc, annulus, open, annulus, disc});
}

ContourStack hole_between_roots() {
  const std::vector<Ring> roots{ellipse(1, 2.5, {-3, 0}), ellipse(1, 2.5, {3, 0})};
  return stack_of({roots, {ellipse(4.2, 3), ellipse(1.5, 1.2)}, {ellipse(4.2, 3)}});
}

ContourStack star_over_turned_star() { return stack_of({{star(9, 4, 1)}, {star(9, 4, 1, pi / 9)}}); }

ContourStack comb_over_mirrored_comb() {
  Ring upper = comb(5, 4, 0.1);
  for (Point2& p : upper) p.y = 3 - p.y;
  std::reverse(upper.begin(), upper.end());
  return stack_of({{comb(5, 4, 0.1)}, {upper}});
}

ContourStack crossing_slivers() {
  return stack_of({{rectangle({-5, -0.005}, {5, 0.005})}, {Ring{{-0.004, -5}, {0.005, -4.9}, {0.003, 5}}}});
}

ContourStack triangle_with_triangular_hole() {
  const std::vector<Ring> slice{Ring{{0, 0}, {6, 0}, {3, 5}}, Ring{{2.5, 1.5}, {3.5, 1.5}, {3, 2.5}}};
  return stack_of({slice, slice});
}

ContourStack triangular_hole_under_disc() {
  return stack_of({{circle(3), Ring{{-0.5, -0.4}, {0.5, -0.4}, {0, 0.6}}}, {circle(3)}});
}

ContourStack triangular_ring_alone() {
  return stack_of({{Ring{{0, 0}, {6, 0}, {3, 5}}, Ring{{2.5, 1.5}, {3.5, 1.5}, {3, 2.5}}}, {}});
}

ContourStack close_neighbours(double gap) {
  const std::vector<Ring> slice{rectangle({0, 0}, {2, 1}), rectangle({0.3, 1 + gap}, {2.7, 2 + gap})};
  return stack_of({slice, slice});
}

ContourStack tiny_features(double size) {
  const Ring ring{{0, 0},          {1, 0}, {1, 0.5},        {1 + size, 0.5 + size / 2},
                  {1, 0.5 + size}, {1, 1}, {0.5 + size, 1}, {0.5 + size / 2, 1 - size},
                  {0.5, 1},        {0, 1}};
  Ring upper = ring;
  for (Point2& p : upper) p.x += size / 2;
  return stack_of({{ring}, {upper}});
}

std::vector<NamedStack> all_shapes() {
  return {{"shifted_circles_0.2", shifted_circles(0.2)},
          {"shifted_circles_0.9", shifted_circles(0.9)},
          {"shifted_circles_1.5", shifted_circles(1.5)},
          {"shifted_circles_2.5", shifted_circles(2.5)},
          {"annulus_over_shifted_annulus", annulus_over_shifted_annulus()},
          {"annulus_over_disc", annulus_over_disc()},
          {"annulus_over_disc_with_two_holes", annulus_over_disc_with_two_holes()},
          {"one_over_two", one_over(2)},
          {"one_over_three", one_over(3)},
          {"two_over_two_crosswise", two_over_two_crosswise()},
          {"drifting_canal", drifting_canal()},
          {"identical_lattice_squares", identical_lattice_squares()},
          {"lattice_square_over_shifted_1_2", lattice_square_over_shifted(1, 2)},
          {"lattice_square_over_shifted_3_3", lattice_square_over_shifted(3, 3)},
          {"square_over_turned_square", polygon_over_turned_polygon(4)},
          {"hexagon_over_turned_hexagon", polygon_over_turned_polygon(6)},
          {"alone_in_the_middle", alone_in_the_middle()},
          {"alone_at_the_end", alone_at_the_end()},
          {"alone_beside_a_column", alone_beside_a_column()},
          {"empty_slice_between", empty_slice_between()},
          {"islands_nested_four_deep", islands_nested_four_deep()},
          {"c_with_island", c_with_island()},
          {"hole_that_opens_outside", hole_that_opens_outside()},
          {"hole_between_roots", hole_between_roots()},
          {"star_over_turned_star", star_over_turned_star()},
          {"comb_over_mirrored_comb", comb_over_mirrored_comb()},
          {"crossing_slivers", crossing_slivers()},
          {"triangle_with_triangular_hole", triangle_with_triangular_hole()},
          {"triangular_hole_under_disc", triangular_hole_under_disc()},
          {"triangular_ring_alone", triangular_ring_alone()},
          {"close_neighbours_1e-3", close_neighbours(1e-3)},
          {"ring_over_crescent", ring_over_crescent()},
          {"ring_between_crescents", ring_between_crescents()},
          {"crescent_between_stubs", crescent_between_stubs()},
          {"tiny_features_1e-9", tiny_features(1e-9)},
          {"annuli_at_1e5", moved(annulus_over_shifted_annulus(), {1e5, -1e5})},
          {"tiny_annuli_at_1e5", moved(scaled(annulus_over_shifted_annulus(), 1e-3), {1e5, -1e5})},
          {"tiny_annuli", scaled(annulus_over_shifted_annulus(), 1e-9)}};
}

}  // namespace odontoscope::test
