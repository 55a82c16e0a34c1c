// Gaps narrower than the places of Gabriel edges can be told: there contour edges are only made Delaunay.

#include <gtest/gtest.h>

#include "tests/delaunay/engine_checks.h"

namespace odontoscope::test {
namespace {

const Contour square{"tooth", {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}};

/// A triangle as good as flat: its middle corner is off the long edge by `width`.
Contour needle(double width) { return {"tooth", {{-0.761, 1.226}, {0.2177, 1.5288}, {-0.27165, 1.3774 - width}}}; }

/// Two triangles with upright walls beside each other, `gap` apart, one wall longer at both ends.
std::vector<Contour> walls(double gap) {
  return {{"tooth", {{1, -1}, {1, 1}, {-1, 1}}}, {"tooth", {{1 + gap, -1.03}, {2.5, 1.95}, {1 + gap, 1.95}}}};
}

/// The slice under a square, above it, and between two.
std::vector<ContourStack> around(const std::vector<Contour>& narrow) {
  const auto flat = [](double z) { return Slice{z, {square}}; };
  return {ContourStack{{Slice{0, narrow}, flat(1)}, ""}, ContourStack{{flat(0), Slice{0.01, narrow}}, ""},
          ContourStack{{flat(0), Slice{1, narrow}, flat(1.5)}, ""}};
}

void expect_certified(const std::vector<Contour>& narrow, std::size_t most_added) {
  const ReconstructOptions options{.correspondence = Correspondence::overlap, .between = Between::delaunay, .links = {}, .threads = 1};
  for (const ContourStack& stack : around(narrow)) {
    const Reconstruction made = certified(stack, options);
    EXPECT_LE(made.counts.steiner_points, most_added);
  }
}

TEST(Narrow, NeedlesAreBuilt) {
  for (double width : {1e-4, 1e-9, 1e-13}) expect_certified({needle(width)}, 1000);
}

TEST(Narrow, WallsThatAllButTouchAreBuilt) {
  for (double gap : {1e-4, 1e-9, 1e-13}) expect_certified(walls(gap), 1000);
}

}  // namespace
}  // namespace odontoscope::test
