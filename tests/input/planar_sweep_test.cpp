// The sweep against an oracle that tries every pair of edges in integer arithmetic.
#include "recon/input/planar_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>

#include "tests/input/shapes.h"

namespace odontoscope {
namespace {

using Kind = Breach::Kind;

std::vector<std::size_t> all(const std::vector<Contour>& contours) {
  std::vector<std::size_t> members(contours.size());
  std::iota(members.begin(), members.end(), std::size_t{0});
  return members;
}

SweepResult sweep_all(const std::vector<Contour>& contours) { return sweep(contours, all(contours)); }

// --- oracle for lattice points -----------------------------------------------------------------------------------

std::int64_t turn(const Point2& a, const Point2& b, const Point2& c) {
  const auto i = [](double v) { return static_cast<std::int64_t>(v); };
  const std::int64_t t = (i(b.x) - i(a.x)) * (i(c.y) - i(a.y)) - (i(b.y) - i(a.y)) * (i(c.x) - i(a.x));
  return (t > 0) - (t < 0);
}

bool within(const Point2& p, const Point2& a, const Point2& b) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

struct Segment {
  Point2 a, b;
  std::size_t contour, point;
};

std::vector<Segment> segments_of(const std::vector<Contour>& contours) {
  std::vector<Segment> segments;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const auto& p = contours[c].points;
    for (std::size_t i = 0; i < p.size(); ++i) segments.push_back({p[i], p[(i + 1) % p.size()], c, i});
  }
  return segments;
}

/// Every kind of breach that there is.
std::set<Kind> breaches(const std::vector<Contour>& contours) {
  std::set<Kind> kinds;
  const std::vector<Segment> segments = segments_of(contours);
  for (const Segment& s : segments) {
    for (const Segment& t : segments) {
      if (s.contour == t.contour && s.point == t.point) continue;
      const std::size_t n = contours[s.contour].points.size();
      const bool next = s.contour == t.contour && t.point == (s.point + 1) % n;
      if (s.a == t.a)
        kinds.insert(s.contour == t.contour ? Kind::repeated_point : Kind::touch);
      else if (!next && within(s.a, t.a, t.b) && s.a != t.b)
        kinds.insert(Kind::touch);
      else if (next && within(s.a, t.a, t.b) && s.a != t.b)
        kinds.insert(Kind::touch);
      if (next && turn(s.a, s.b, t.b) == 0 && (within(s.a, t.a, t.b) || within(t.b, s.a, s.b))) {
        kinds.insert(Kind::fold_back);
      }
      const bool properly =
          turn(s.a, s.b, t.a) * turn(s.a, s.b, t.b) < 0 && turn(t.a, t.b, s.a) * turn(t.a, t.b, s.b) < 0;
      if (properly) kinds.insert(Kind::crossing);
    }
  }
  return kinds;
}

/// Number of other contours around a point that lies on none of them.
std::size_t contours_around(const Point2& p, std::size_t own, const std::vector<Contour>& contours) {
  std::size_t depth = 0;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    if (c == own) continue;
    bool inside = false;
    const auto& q = contours[c].points;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Point2 &a = q[i], &b = q[(i + 1) % q.size()];
      const Point2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
      if (low.y <= p.y && p.y < high.y && turn(low, high, p) > 0) inside = !inside;
    }
    depth += inside;
  }
  return depth;
}

bool positive_area(const std::vector<Point2>& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2& q = p[(i + 1) % p.size()];
    twice += p[i].x * q.y - p[i].y * q.x;
  }
  return twice > 0;
}

struct Lattice {
  int extent, contours, most_points;
  int reach;  // of a contour, so that some are small beside the lattice
};

class SweepAgainstOracle : public testing::TestWithParam<Lattice> {};

TEST_P(SweepAgainstOracle, AgreesOnRandomLatticePolygons) {
  const Lattice lattice = GetParam();
  std::mt19937 random(static_cast<unsigned>(lattice.extent * 1000 + lattice.contours * 100 + lattice.most_points));
  const auto number = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  int sound = 0, broken = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::vector<Contour> contours;
    for (int c = 0; c < lattice.contours; ++c) {
      shapes::Points points;
      const int x = number(0, lattice.extent), y = number(0, lattice.extent);
      for (int i = number(3, lattice.most_points); i > 0; --i) {
        points.push_back({double(x + number(0, lattice.reach)), double(y + number(0, lattice.reach))});
      }
      contours.push_back(shapes::tooth(points));
    }
    const std::set<Kind> expected = breaches(contours);
    const SweepResult found = sweep_all(contours);
    ASSERT_EQ(found.breach.has_value(), !expected.empty()) << "round " << round;
    if (found.breach) {
      ++broken;
      ASSERT_TRUE(expected.contains(found.breach->kind)) << "round " << round << " " << int(found.breach->kind);
      if (expected.contains(Kind::repeated_point)) {
        ASSERT_EQ(found.breach->kind, Kind::repeated_point);
      }
      continue;
    }
    ++sound;
    for (std::size_t c = 0; c < contours.size(); ++c) {
      ASSERT_EQ(found.nesting[c].counter_clockwise, positive_area(contours[c].points));
      ASSERT_EQ(counter_clockwise(contours[c].points), positive_area(contours[c].points));
      ASSERT_EQ(found.nesting[c].depth, contours_around(contours[c].points[0], c, contours));
    }
  }
  EXPECT_GT(sound, 30);
  EXPECT_GT(broken, 30);
}

INSTANTIATE_TEST_SUITE_P(Lattices, SweepAgainstOracle,
                         testing::Values(Lattice{0, 1, 5, 3}, Lattice{0, 1, 9, 6}, Lattice{3, 2, 4, 4},
                                         Lattice{3, 3, 3, 9}, Lattice{10, 3, 4, 40}, Lattice{60, 9, 3, 20},
                                         Lattice{0, 1, 7, 1000}, Lattice{40, 5, 3, 20}));

// --- the place of a breach ---------------------------------------------------------------------------------------

TEST(Sweep, NamesBothEdgesOfACrossing) {
  const std::vector<Contour> contours = {shapes::tooth({{0, 0}, {4, 4}, {4, 0}, {0, 4}})};
  const SweepResult found = sweep_all(contours);
  ASSERT_TRUE(found.breach);
  EXPECT_EQ(found.breach->kind, Kind::crossing);
  EXPECT_EQ(found.breach->point, 0u);
  EXPECT_EQ(found.breach->other_point, 2u);
  EXPECT_EQ(found.breach->at, (Point2{2, 2}));
}

TEST(Sweep, CountsNestedRings) {
  std::vector<Contour> contours;
  for (int ring = 0; ring < 6; ++ring) contours.push_back(shapes::tooth(shapes::circle(0, 0, 1.0 + ring, 64)));
  const SweepResult found = sweep_all(contours);
  ASSERT_FALSE(found.breach);
  for (std::size_t ring = 0; ring < 6; ++ring) EXPECT_EQ(found.nesting[ring].depth, 5 - ring);
}

/// One unit in the last place decides: no float cross product can tell these apart.
TEST(Sweep, SeparatesAPointFromAnEdgeByOneUlp) {
  const Point2 a{0.1, 0.1}, b{0.7, 0.7};
  const double on = 0.3, off = std::nextafter(0.3, 1);
  const auto with_apex = [&](double y) {
    return std::vector<Contour>{shapes::tooth({a, b, {1, 0}}), shapes::tooth({{on, y}, {on, 1}, {0.2, 1}})};
  };
  EXPECT_FALSE(sweep_all(with_apex(off)).breach);
  ASSERT_TRUE(sweep_all(with_apex(on)).breach);
  EXPECT_EQ(sweep_all(with_apex(on)).breach->kind, Kind::touch);
  ASSERT_TRUE(sweep_all(with_apex(std::nextafter(0.3, 0))).breach);
  EXPECT_EQ(sweep_all(with_apex(std::nextafter(0.3, 0))).breach->kind, Kind::crossing);
}

TEST(Sweep, SurvivesTinyAndHugeCoordinates) {
  const double tiny = 5e-324;
  EXPECT_FALSE(sweep_all({shapes::tooth({{0, 0}, {tiny, 0}, {0, tiny}})}).breach);
  EXPECT_TRUE(sweep_all({shapes::tooth({{0, 0}, {tiny, tiny}, {tiny, 0}, {0, tiny}})}).breach);
  EXPECT_TRUE(
      sweep_all({shapes::tooth({{-1e6, -1e6}, {1e6, 1e6}, {0, tiny}, {1e6, -1e6}, {0, -tiny}, {0, tiny / 1}})}).breach);
}

TEST(Collinear, IsExact) {
  EXPECT_TRUE(collinear({{0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}, {0.1, 0.1}}));
  EXPECT_FALSE(collinear({{0.1, 0.1}, {0.3, std::nextafter(0.3, 1)}, {0.7, 0.7}}));
  EXPECT_TRUE(collinear({{1, 1}, {1, 1}, {1, 1}}));
  EXPECT_TRUE(collinear({}));
}

}  // namespace
}  // namespace odontoscope
