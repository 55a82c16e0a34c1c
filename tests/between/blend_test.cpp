// Virtual slices of shapes for which the right answer is known.

#include "recon/between/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "recon/core/error.h"
#include "tests/between/slabs.h"

namespace odontoscope::test {
namespace {

using between::blend;
using between::ContourLink;
using between::need;
using between::Surroundings;

constexpr std::array quarters{0.25, 0.5, 0.75};
constexpr double pi = std::numbers::pi;

struct Slab {
  Outline lower, upper;
  Links links;
  Outline before, after;  // none if empty
  double z_before = -1, z_lower = 0, z_upper = 1, z_after = 2;

  std::vector<Outline> blended(std::span<const double> shares = quarters) const {
    Surroundings s;
    s.before = before.empty() ? nullptr : &before;
    s.lower = &lower;
    s.upper = &upper;
    s.after = after.empty() ? nullptr : &after;
    s.z_before = z_before, s.z_lower = z_lower, s.z_upper = z_upper, s.z_after = z_after;
    s.material = links.material;
    s.voids = links.voids;
    return blend(s, shares);
  }
};

Slab overlapping(Outline lower, Outline upper, Outline before = {}, Outline after = {}) {
  const Links links = overlap_links(lower, upper);
  return {std::move(lower), std::move(upper), links, std::move(before), std::move(after)};
}

Outline ring(double outer, double inner, Point2 centre = {}) {
  return {circle(outer, centre), hole(circle(inner, centre))};
}

/// Lobes on a circle; smooth, and larger where the height says so.
Ring lobed(double radius, double depth, int lobes) {
  Ring points;
  for (int n = 0; n < 200; ++n) {
    const double angle = 2 * pi * n / 200, r = radius + depth * std::cos(lobes * angle);
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

Point2 middle(const Ring& contour) {
  double x = 0, y = 0, twice = 0;
  for (std::size_t n = 0; n < contour.size(); ++n) {
    const Point2 a = contour[n], b = contour[(n + 1) % contour.size()];
    const double cross = a.x * b.y - a.y * b.x;
    twice += cross;
    x += cross * (a.x + b.x);
    y += cross * (a.y + b.y);
  }
  return {x / (3 * twice), y / (3 * twice)};
}

/// Through f at four heights: Hermite's cubic with the slopes of parabolas, in the textbook's order.
double catmull_rom(const std::array<double, 4>& z, const std::array<double, 4>& f, double share) {
  const auto chord = [&](int a, int b) { return (f[b] - f[a]) / (z[b] - z[a]); };
  const auto slope = [&](int n) {
    const double h = z[n] - z[n - 1], k = z[n + 1] - z[n];
    return (k * chord(n - 1, n) + h * chord(n, n + 1)) / (h + k);
  };
  const double h = z[2] - z[1], t = share;
  return (2 * t * t * t - 3 * t * t + 1) * f[1] + (t * t * t - 2 * t * t + t) * h * slope(1) +
         (3 * t * t - 2 * t * t * t) * f[2] + (t * t * t - t * t) * h * slope(2);
}

TEST(Blend, IsPlainCubicInterpolationOfDistancesWhereNothingDrifts) {
  const Slab slab{{lobed(3, 0.3, 3)},
                  {lobed(3.5, 0.5, 3)},
                  {{{0, 0}}, {}},
                  {lobed(2.7, 0.2, 3)},
                  {lobed(3.7, 0.6, 3)},
                  -0.7,
                  0,
                  1,
                  1.6};
  const std::vector<Outline> made = slab.blended();
  for (std::size_t n = 0; n < quarters.size(); ++n) {
    ASSERT_EQ(made[n].size(), 1u);
    double farthest = 0;
    for (const Point2 p : made[n][0]) {
      const std::array<double, 4> f{distance(slab.before, p), distance(slab.lower, p), distance(slab.upper, p),
                                    distance(slab.after, p)};
      farthest = std::max(farthest, std::abs(catmull_rom({-0.7, 0, 1, 1.6}, f, quarters[n])));
    }
    EXPECT_LT(farthest, 0.002) << "share " << quarters[n];
  }
}

TEST(Blend, IsLinearWithoutNeighbours) {
  const Slab slab = overlapping({circle(2)}, {circle(3)});
  for (std::size_t n = 0; const Outline& made : slab.blended()) {
    ASSERT_EQ(made.size(), 1u);
    EXPECT_NEAR(std::sqrt(area(made) / pi), 2 + quarters[n++], 0.006);
  }
}

TEST(Blend, IsTheParabolaWithOneNeighbour) {
  Slab slab = overlapping({circle(2)}, {circle(2.5)});
  slab.after = {circle(3.2)};  // 2 + 0.4 t + 0.1 t^2
  for (std::size_t n = 0; const Outline& made : slab.blended()) {
    const double t = quarters[n++];
    EXPECT_NEAR(std::sqrt(area(made) / pi), 2 + 0.4 * t + 0.1 * t * t, 0.006);
  }
}

TEST(Blend, LeavesOutANeighbourThatIsUnlike) {
  Slab slab = overlapping({circle(2)}, {circle(3)});
  slab.after = {circle(0.5, {-2, 0}), circle(0.5, {2, 0})};
  EXPECT_EQ(slab.blended(), overlapping({circle(2)}, {circle(3)}).blended());
}

/// The part of a disc to the right of x = gap / 2, and its mirror image.
Outline halves(double radius, double gap) {
  Ring right;
  const double x = gap / 2, end = std::acos(x / radius);
  for (int n = 0; n <= 100; ++n) {
    const double angle = end * (n / 50.0 - 1);
    right.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  Ring left;
  for (const Point2 p : right) left.push_back({-p.x, -p.y});
  return {right, left};
}

TEST(Blend, HearsAllPiecesThatAShapeSplitsIntoBeyondTheSlab) {
  Slab split = overlapping({circle(2)}, {circle(2.3)}), whole = split;
  split.before = whole.before = {circle(1.9)};
  split.after = halves(2.4, 0.05);
  whole.after = {circle(2.4)};
  const std::vector<Outline> made = split.blended(), wanted = whole.blended();
  for (std::size_t n = 0; n < made.size(); ++n) {
    for (const Point2 p : made[n][0]) {
      if (std::abs(p.x) > 0.3) {
        EXPECT_NEAR(distance(wanted[n], p), 0, 0.005);
      }
    }
  }
}

TEST(Blend, ClosesAHoleWhereItsCourseSays) {
  Slab slab = overlapping({circle(5), hole(circle(0.5))}, {circle(5)});
  slab.before = {circle(5), hole(circle(1))};
  const std::vector<Outline> made = slab.blended();
  ASSERT_EQ(made[0].size(), 2u);
  EXPECT_GT(std::sqrt(-area({made[0][1]}) / pi), 0.25);
  EXPECT_LT(std::sqrt(-area({made[0][1]}) / pi), 0.42);
  EXPECT_EQ(made[2].size(), 1u);
}

TEST(Blend, CarriesARingThatDriftsByTwiceItsWidth) {
  const double whole = area(ring(2, 1.8));
  for (const Outline& made : overlapping(ring(2, 1.8), ring(2, 1.8, {0.4, 0})).blended()) {
    ASSERT_EQ(made.size(), 2u);
    EXPECT_GT(area({made[0]}), 0);
    EXPECT_LT(area({made[1]}), 0);
    EXPECT_NEAR(area(made), whole, 0.02 * whole);
  }
}

TEST(Blend, CarriesACThatDriftsByMoreThanItsWidth) {
  const Outline c{c_shape(2, 1.8, 0.5)};
  Slab slab = overlapping(c, moved(c, {0.3, 0.1}));
  for (const Outline& made : slab.blended()) {
    ASSERT_EQ(made.size(), 1u);
    EXPECT_NEAR(area(made), area(c), 0.03 * area(c));
  }
}

TEST(Blend, CarriesACThatGrowsByMoreThanItsWidth) {
  Slab slab = overlapping({c_shape(2, 1.8, 0.5)}, {c_shape(2.4, 2.2, 0.5)});
  slab.links.material = {{0, 0}};
  for (const Outline& made : slab.blended()) ASSERT_EQ(made.size(), 1u);
  EXPECT_NEAR(area(slab.blended()[1]), area({c_shape(2.2, 2.0, 0.5)}), 0.05);
}

TEST(Blend, CarriesACanalThatIsSlantedByThreeRadii) {
  const Slab slab{{circle(0.3)}, {circle(0.3, {0.9, 0})}, {{{0, 0}}, {}}, {}, {}};
  for (std::size_t n = 0; const Outline& made : slab.blended()) {
    ASSERT_EQ(made.size(), 1u);
    EXPECT_NEAR(middle(made[0]).x, 0.9 * quarters[n++], 0.003);
    EXPECT_NEAR(middle(made[0]).y, 0, 0.003);
    EXPECT_NEAR(std::sqrt(area(made) / pi), 0.3, 0.003);
  }
}

TEST(Blend, CarriesACanalThroughItsTooth) {
  const auto tooth = [](Point2 canal) { return Outline{circle(4), hole(circle(0.3, canal))}; };
  const Slab slab{tooth({0, 0}), tooth({0.9, 0}), {{{0, 0}}, {{1, 1}}}, {}, {}};
  for (std::size_t n = 0; const Outline& made : slab.blended()) {
    ASSERT_EQ(made.size(), 2u);
    EXPECT_NEAR(middle(made[1]).x, 0.9 * quarters[n++], 0.005);
    EXPECT_NEAR(std::sqrt(-area({made[1]}) / pi), 0.3, 0.005);
  }
}

TEST(Blend, CurvesACanalThroughFourSlices) {
  const auto at = [](double z) { return Outline{circle(0.3, {0.3 * z * z, 0})}; };
  const Slab slab{at(1), at(2), {{{0, 0}}, {}}, at(0), at(3), 0, 1, 2, 3};
  const std::vector<Outline> made = slab.blended();
  ASSERT_EQ(made[1].size(), 1u);
  EXPECT_NEAR(middle(made[1][0]).x, 0.3 * 1.5 * 1.5, 0.004);
}

TEST(Blend, ClosesAHoleUnderAFlatRoof) {
  const std::vector<Outline> made = overlapping(ring(3, 2.5), {circle(3)}).blended();
  ASSERT_EQ(made[0].size(), 2u);
  EXPECT_NEAR(std::sqrt(-area({made[0][1]}) / pi), 2.25, 0.01);  // where (1 - t) (r - 2.5) + t (3 - r) = 0
  EXPECT_EQ(made[2].size(), 1u);
}

TEST(Blend, ShrinksAHoleToASmallOne) {
  const Slab slab = overlapping(ring(3, 2.5), {circle(3), hole(circle(0.3, {0.5, 0}))});
  double last = 2.5;
  for (const Outline& made : slab.blended()) {
    ASSERT_EQ(made.size(), 2u);
    const double radius = std::sqrt(-area({made[1]}) / pi);
    EXPECT_LT(radius, last);
    EXPECT_GT(radius, 0.3);
    last = radius;
  }
}

TEST(Blend, ForksFromOnePieceToTwo) {
  const Slab slab = overlapping({circle(1)}, {circle(0.6, {-0.8, 0}), circle(0.6, {0.8, 0})});
  constexpr std::array shares{0.1, 0.95};
  const std::vector<Outline> made = slab.blended(shares);
  EXPECT_EQ(made[0].size(), 1u);
  EXPECT_EQ(made[1].size(), 2u);
}

/// Halfway up, at a place in the middle of its way, is what is carried there?
bool carried_at(const Slab& slab, Point2 at, bool hollow) {
  constexpr std::array middle{0.5};
  return covers(slab.blended(middle)[0], at) != hollow;
}

// A bead beside the chamber, which has a section of its own to go on to.
TEST(Blend, CarriesABeadIntoTheChamberThatItDoesNotOverlap) {
  const Ring chamber = circle(1), bead = circle(0.2, {1.6, 0});
  EXPECT_TRUE(carried_at({{chamber, bead}, {chamber}, {{{0, 0}, {1, 0}}, {}}, {}, {}}, {1.2, 0}, false));
  EXPECT_FALSE(carried_at({{chamber, bead}, {chamber}, {{{0, 0}}, {}}, {}, {}}, {1.2, 0}, false)) << "not linked";
  EXPECT_TRUE(carried_at(
      {{circle(3), hole(chamber), hole(bead)}, {circle(3), hole(chamber)}, {{{0, 0}}, {{1, 1}, {2, 1}}}, {}, {}},
      {1.2, 0}, true));
}

TEST(Blend, CarriesAHoleOutThroughTheWallBesideIt) {
  const Ring bead = circle(0.2, {2.6, 0});
  EXPECT_TRUE(carried_at({{circle(3), hole(bead)}, {circle(2.95)}, {{{0, 0}}, {{1, between::outside}}}, {}, {}},
                         {2.85, 0}, true));
}

TEST(Blend, AFinerGridKeepsAWallThinnerThanAStep) {
  const Outline walled{rectangle({0, 0}, {12, 12}), hole(rectangle({1, 1}, {5.98, 11})),
                       hole(rectangle({6.02, 1}, {11, 11}))};
  const Links links = overlap_links(walled, walled);
  Surroundings s{nullptr, &walled, &walled, nullptr, 0, 0, 1, 0, links.material, links.voids};
  constexpr std::array middle{0.5};
  EXPECT_LT(blend(s, middle, {.most_grid_points = 10'000}).front().size(), 3u);
  EXPECT_EQ(blend(s, middle, {.most_grid_points = 10'000, .finer = 4}).front().size(), 3u);
}

TEST(Blend, OpensAHoleThroughTheMouthOfAC) {
  const Slab slab = overlapping({c_shape(2, 1.6, 0.5)}, ring(2, 1.6));
  constexpr std::array shares{0.25, 0.98};
  const std::vector<Outline> made = slab.blended(shares);
  EXPECT_EQ(made[0].size(), 1u);
  EXPECT_EQ(made[1].size(), 2u);
}

TEST(Blend, KeepsAnIslandInItsHole) {
  Outline lower = ring(3, 2), upper = ring(3, 2, {0.2, 0});
  lower.push_back(circle(1));
  upper.push_back(circle(1, {0.4, 0}));
  for (const Outline& made : overlapping(lower, upper).blended()) {
    ASSERT_EQ(made.size(), 3u);
    EXPECT_NEAR(area(made), area(lower), 0.02 * area(lower));
  }
}

TEST(Blend, LetsWhatHasNoPartnerEndBetweenTheSlices) {
  const Slab slab = overlapping({circle(1), circle(0.5, {3, 0})}, {circle(1)});
  constexpr std::array shares{0.05, 0.95};
  EXPECT_EQ(slab.blended(shares)[0].size(), 2u);
  EXPECT_EQ(slab.blended(shares)[1].size(), 1u);
}

TEST(Blend, MakesNothingOfNothing) {
  EXPECT_EQ((Slab{{}, {}, {}, {}, {}}.blended()), std::vector<Outline>(3));
  EXPECT_EQ((Slab{{circle(1)}, {}, {}, {}, {}}.blended()[2]), Outline{});
}

TEST(Blend, HasNoMorePointsThanItsNeighbours) {
  const Slab slab{{lobed(3, 0.3, 5)}, {lobed(3.2, 0.3, 5)}, {{{0, 0}}, {}}, {}, {}};
  for (const Outline& made : slab.blended()) EXPECT_LE(points_in(made), 200u);
}

TEST(Blend, RoundsToAPowerOfTwoThatFollowsTheScale) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const Slab slab = overlapping({circle(3 * scale)}, {circle(3.3 * scale, {0.1 * scale, 0})});
    const double grain = std::ldexp(1.0, std::ilogb(6.6 * scale) - 33);
    for (const Outline& made : slab.blended()) {
      ASSERT_EQ(made.size(), 1u);
      for (const Point2 p : made[0]) {
        ASSERT_EQ(std::round(p.x / grain) * grain, p.x);
        ASSERT_EQ(std::round(p.y / grain) * grain, p.y);
      }
    }
  }
}

TEST(Blend, IsTheSameFarFromTheOrigin) {
  const Slab near = overlapping({circle(3)}, {circle(3.3, {0.1, 0})});
  Slab far = near;
  far.lower = moved(near.lower, {1 << 19, 0});
  far.upper = moved(near.upper, {1 << 19, 0});
  const std::vector<Outline> a = near.blended(), b = far.blended();
  for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(area(a[n]), area(moved(b[n], {-(1 << 19), 0})), 0.01);
}

TEST(Blend, TakesTheNearerSliceWhereDoublesAreTooCoarse) {
  const Outline lower = moved({circle(1e-9)}, {1e6, 0}), upper = moved({circle(2e-9)}, {1e6, 0});
  const Slab slab{lower, upper, {{{0, 0}}, {}}, {}, {}};
  EXPECT_EQ(slab.blended()[0], lower);
  EXPECT_EQ(slab.blended()[2], upper);
}

TEST(Blend, TakesTheNearerSliceWhereAreasAreNoNumbers) {
  for (const double size : {1e-155, 1e-162, 1e-300, 1e-320}) {  // squared they are denormal, or nothing
    const Outline lower{circle(size)}, upper{circle(2 * size)};
    const Slab slab{lower, upper, {{{0, 0}}, {}}, {}, {}};
    EXPECT_EQ(slab.blended()[0], lower);
    EXPECT_EQ(slab.blended()[2], upper);
    EXPECT_EQ(need(lower, upper).travel, 0);
  }
}

TEST(Blend, TellsRegionsFromHolesHoweverSmall) {
  for (const double size : {1e-162, 1e-300}) {
    const Outline lower{circle(2, {5, 0}), circle(size), hole(circle(size / 2))}, upper = lower;
    EXPECT_NO_THROW((Slab{lower, upper, {{{0, 0}, {1, 1}}, {{2, 2}}}, {}, {}}.blended()));
  }
  const Outline needle{{{0, 0}, {3, 1}, {1.5, 0.5000000000000001}}};  // its area is less than its rounding
  EXPECT_NO_THROW((Slab{needle, needle, {{{0, 0}}, {}}, {}, {}}.blended()));
}

TEST(Blend, RefusesLinksAndSharesThatMeanNothing) {
  EXPECT_THROW((Slab{ring(2, 1), ring(2, 1), {{{1, 0}}, {}}, {}, {}}.blended()), InternalError);
  EXPECT_THROW((Slab{ring(2, 1), ring(2, 1), {{}, {{0, 1}}}, {}, {}}.blended()), InternalError);
  EXPECT_THROW((Slab{ring(2, 1), ring(2, 1), {{{0, 2}}, {}}, {}, {}}.blended()), InternalError);
  constexpr std::array at_the_end{1.0};
  constexpr std::array falling{0.5, 0.25};
  EXPECT_THROW(overlapping(ring(2, 1), ring(2, 1)).blended(at_the_end), InternalError);
  EXPECT_THROW(overlapping(ring(2, 1), ring(2, 1)).blended(falling), InternalError);
}

TEST(SlabNeed, IsTheWidthAndAreaOfTheDifference) {
  EXPECT_NEAR(need({circle(3)}, {circle(2)}).travel, 1, 0.05);
  EXPECT_NEAR(need({circle(3)}, {circle(2)}).area, 5 * pi, 0.3);
  EXPECT_NEAR(need(ring(3, 2.5), {circle(3)}).travel, 5, 0.1);
  EXPECT_EQ(need({circle(3)}, {circle(3)}).travel, 0);
  EXPECT_EQ(need({}, {}).area, 0);
}

}  // namespace
}  // namespace odontoscope::test
