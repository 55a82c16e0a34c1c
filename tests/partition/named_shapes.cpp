#include "tests/partition/named_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odontoscope::test {
namespace {

using Ring = std::vector<Point2>;

Ring circle(Point2 centre, double radius, int points) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

Ring box(double low_x, double low_y, double high_x, double high_y) {
  return {{low_x, low_y}, {high_x, low_y}, {high_x, high_y}, {low_x, high_y}};
}

}  // namespace

ContourStack three_in_a_drifting_line() {
  ContourStack stack;
  for (int k = 0; k < 5; ++k) {
    const Point2 meet{0.3 * k - 0.6, 0.4 * std::sin(k)};
    Slice slice{0.5 * k, {}};
    slice.contours.push_back({"a", {meet, {2, -2}, {2, 2}, {0, 2}}});
    slice.contours.push_back({"b", {meet, {0, 2}, {-2, 2}, {-2, -2}}});
    slice.contours.push_back({"c", {meet, {-2, -2}, {2, -2}}});
    stack.slices.push_back(slice);
  }
  return stack;
}

ContourStack one_between_two_in_one_slice() {
  ContourStack stack;
  for (int k = 0; k < 3; ++k) {
    Slice slice{1.0 * k, {}};
    const double half = k == 1 ? 0.3 : 0;
    slice.contours.push_back({"left", box(-2, -1, -half, 1)});
    slice.contours.push_back({"right", box(half, -1, 2, 1)});
    if (k == 1) slice.contours.push_back({"between", box(-half, -1, half, 1)});
    stack.slices.push_back(slice);
  }
  return stack;
}

ContourStack thin_shell_that_drifts() {
  ContourStack stack;
  for (int k = 0; k < 5; ++k) {
    const Point2 centre{0.2 * k, 0};
    Slice slice{0.25 * k, {}};
    slice.contours.push_back({"enamel", circle(centre, 2.1, 40)});
    slice.contours.push_back({"dentine", circle(centre, 2.0, 40)});
    stack.slices.push_back(slice);
  }
  return stack;
}

ContourStack checkerboard_corner() {
  ContourStack stack;
  for (int k = 0; k < 3; ++k) {
    Slice slice{1.0 * k, {}};
    slice.contours.push_back({"a", box(0, 0, 1, 1)});
    slice.contours.push_back({"b", box(-1, -1, 0, 0)});
    slice.contours.push_back({"c", box(-1, 0, 0, 1)});
    slice.contours.push_back({"d", box(0, -1, 1, 0)});
    stack.slices.push_back(slice);
  }
  return stack;
}

ContourStack canal_through_the_apex() {
  ContourStack stack;
  for (int k = 0; k < 6; ++k) {
    Slice slice{0.5 * k, {}};
    slice.contours.push_back({"dentine", circle({0, 0}, 0.6 + 0.2 * k, 36)});
    slice.contours.push_back({"pulp", circle({0.05 * k, 0}, 0.2 + 0.03 * k, 24)});
    stack.slices.push_back(slice);
  }
  return stack;
}

double slanting_margin_height(double angle) { return 1.5 + std::cos(angle); }

ContourStack slanting_margin() {
  constexpr int points = 90;
  constexpr double radius = 2, slope = 0.3, thickest = 0.3;
  ContourStack stack;
  for (int k = 0; k < 12; ++k) {
    const double z = 0.25 * k;
    Ring dentine;
    bool covered = false;
    for (int i = 0; i < points; ++i) {
      const double angle = 2 * std::numbers::pi * i / points;
      const double wall = std::clamp(slope * (z - slanting_margin_height(angle)), 0.0, thickest);
      covered = covered || wall > 0;
      dentine.push_back({(radius - wall) * std::cos(angle), (radius - wall) * std::sin(angle)});
    }
    Slice slice{z, {{"dentine", dentine}}};
    if (covered) slice.contours.push_back({"enamel", circle({0, 0}, radius, points)});
    stack.slices.push_back(slice);
  }
  return stack;
}

}  // namespace odontoscope::test
