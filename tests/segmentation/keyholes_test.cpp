// Holes drawn in one line with their outlines, and taken out again.

#include "recon/segmentation/keyholes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/exchange/unbridge.h"
#include "tests/segmentation/made.h"

namespace odontoscope {
namespace {

using made::polygon;
using made::reversed;

double area_of(const std::vector<Ring>& rings) {
  double sum = 0;
  for (const Ring& ring : rings) sum += made::signed_area(ring);
  return sum;
}

std::vector<Ring> parted(const std::vector<Ring>& lines) {
  std::vector<Ring> rings;
  for (const Ring& line : lines)
    for (Ring& ring : without_bridges(line)) rings.push_back(std::move(ring));
  return rings;
}

/// From its least point on.
Ring rolled(Ring ring) {
  const auto less = [](const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), less), ring.end());
  return ring;
}

std::vector<Ring> sorted(std::vector<Ring> rings) {
  for (Ring& ring : rings) ring = rolled(std::move(ring));
  std::sort(rings.begin(), rings.end(),
            [](const Ring& a, const Ring& b) { return std::pair(a[0].x, a[0].y) < std::pair(b[0].x, b[0].y); });
  return rings;
}

/// Edges of all lines that cross another, or have a point of another in their middle: bridges that run where they may
/// not.
int crossings(const std::vector<Ring>& lines) {
  std::vector<std::pair<Point2, Point2>> edges;
  for (const Ring& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) edges.emplace_back(line[i], line[(i + 1) % line.size()]);
  const auto turn = [](const Point2& a, const Point2& b, const Point2& c) {
    const double sine = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return sine > 1e-12 ? 1 : sine < -1e-12 ? -1 : 0;
  };
  const auto in_middle = [&](const Point2& a, const Point2& b, const Point2& p) {
    return turn(a, b, p) == 0 && (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) < -1e-12;
  };
  int count = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const auto& [a, b] = edges[i];
      const auto& [c, d] = edges[j];
      count += turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
      count += in_middle(a, b, c) || in_middle(c, d, a);
    }
  return count;
}

void expect_same_again(const std::vector<Ring>& rings, std::size_t lines_wanted) {
  const std::vector<Ring> lines = with_keyholes(rings);
  EXPECT_EQ(lines.size(), lines_wanted);
  EXPECT_NEAR(area_of(lines), area_of(rings), 1e-9);
  EXPECT_EQ(crossings(lines), 0);
  EXPECT_EQ(sorted(parted(lines)), sorted(rings));  // to the bit
}

TEST(Keyholes, WithoutHolesNothingChanges) {
  const std::vector<Ring> rings{polygon(7, 2), polygon(5, 1, {9, 9})};
  EXPECT_EQ(with_keyholes(rings), rings);
  EXPECT_EQ(without_bridges(rings[0]), std::vector<Ring>{rings[0]});
}

TEST(Keyholes, AHoleGoesInAndOutAgain) {
  const std::vector<Ring> rings{polygon(40, 5), reversed(polygon(9, 1, {1, 1}))};
  const std::vector<Ring> lines = with_keyholes(rings);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), 40u + 9 + 2);
  expect_same_again(rings, 1);
}

TEST(Keyholes, OfASieveAllGoInAndOutAgain) { expect_same_again(made::sieve(9, 7), 1); }

TEST(Keyholes, IslandsInHolesAreLinesOfTheirOwn) {
  expect_same_again({polygon(40, 9), reversed(polygon(30, 7)), polygon(20, 5), reversed(polygon(10, 1, {2, 0})),
                     reversed(polygon(10, 1, {-2, 0}))},
                    2);
}

TEST(Keyholes, BehindASpikeAnotherPointIsTaken) {
  // The nearest point of the outline by distance lies behind the notch that reaches in between.
  const Ring outline{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5.2}, {5.4, 5.05}, {0, 4.9}};
  expect_same_again({outline, reversed(polygon(8, 0.4, {6, 6}))}, 1);
  expect_same_again({outline, reversed(polygon(8, 0.4, {2, 6.5})), reversed(polygon(8, 0.4, {2, 3.5}))}, 1);
}

TEST(Keyholes, PointsInLineWithTheBridgeAreNotJumped) {
  // All on one height: hole, hole, and points of the outline.
  const Ring outline{{0, -4}, {12, -4}, {12, 0}, {12, 4}, {0, 4}, {0, 0}};
  const auto square = [](double x) { return Ring{{x, 0}, {x + 1, 1}, {x + 2, 0}, {x + 1, -1}}; };
  expect_same_again({outline, square(2), square(5), square(8)}, 1);
}

TEST(Keyholes, SpursVanish) {
  const Ring spur{{0, 0}, {4, 0}, {4, 4}, {7, 7}, {4, 4}, {0, 4}};
  const std::vector<Ring> rings = without_bridges(spur);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].size(), 4u);
  EXPECT_TRUE(without_bridges({{0, 0}, {1, 0}, {0, 0}, {-1, 0}}).empty());
}

TEST(Keyholes, ABridgeThatIsOffByABitIsNone) {
  const Ring line{
      {0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}, {2, 4}, {2, 6}, {6, 6}, {6, 2}, {2, 2}, {2, std::nextafter(4.0, 5.0)},
      {0, 4}};
  EXPECT_EQ(without_bridges(line), std::vector<Ring>{line});
}

}  // namespace
}  // namespace odontoscope
