// Stacks that are awkward by their numbers: nearly collinear, nearly touching, nearly the same, nearly at one height,
// far away.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/plane_check.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

Ring blob(RandomNumbers& random, int points, Point2 centre, double radius) {
  const double rough = random.between(0, 0.5);
  return ring_around(centre, std::max(3, points), random.between(0, 6.28),
                     [&](int) { return radius * (1 - rough * random.unit()); });
}

/// The polygon with points added on its edges, each off its edge by `off` of the edge's length, to either side.
Ring nearly_straight(RandomNumbers& random, const Ring& corners, int points, double off) {
  Ring ring;
  const int each = std::max(1, points / int(corners.size()) - 1);
  const bool halves = random.chance(0.3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 a = corners[i], b = corners[(i + 1) % corners.size()];
    ring.push_back(a);
    std::vector<double> along;
    for (int j = 0; j < each; ++j) along.push_back(halves ? (j + 1.0) / (each + 1) : random.between(0.02, 0.98));
    std::sort(along.begin(), along.end());
    for (double t : along) {
      const double side = off * random.between(-1, 1);
      ring.push_back({a.x + t * (b.x - a.x) + side * (b.y - a.y), a.y + t * (b.y - a.y) - side * (b.x - a.x)});
    }
  }
  return ring;
}

ContourStack collinear(RandomNumbers& random, int points) {
  std::vector<Rings> slices;
  const int count = random.whole(2, 3);
  Ring corners = regular({0, 0}, random.whole(3, 6), random.between(0, 6), random.between(1, 4));
  for (int k = 0; k < count; ++k) {
    const double off = random.chance(0.2) ? 0 : small(random, 9, 16);
    Rings rings;
    add_if_it_fits(rings, nearly_straight(random, corners, points / count, off));
    if (random.chance(0.3))
      add_if_it_fits(rings, nearly_straight(random, scaled(corners, 0.5), points / count / 2, off));
    slices.push_back(rings);
    if (random.chance(0.6))
      corners = regular({random.between(-1, 1), random.between(-1, 1)}, random.whole(3, 6), random.between(0, 6),
                        random.between(1, 4));
  }
  return stacked(random, slices);
}

/// A gap from a few units in the last place to 1e-6.
double gap_at(RandomNumbers& random, double where) {
  return random.chance(0.3) ? steps_from(where, random.whole(1, 8)) - where
                            : small(random, 6, 15) * random.between(1, 9);
}

/// Polygons beside and within each other with next to nothing between them.
ContourStack tangent(RandomNumbers& random, int points) {
  std::vector<Rings> slices;
  const int count = random.whole(2, 3), wanted = std::max(2, points / count / 4);
  for (int k = 0; k < count; ++k) {
    Rings rings{random.chance(0.5) ? box_of({-1, -1}, {1, 1}) : Ring{{1, 1}, {0, random.between(-0.9, 0.1)}, {-1, 1}}};
    for (int c = 1; c < wanted; ++c) {
      const double gap = gap_at(random, 1);
      switch (random.below(5)) {
        case 0:
          add_if_it_fits(rings, box_of({1 + gap, random.between(-2, 0)}, {2.5, random.between(0.1, 2)}));
          break;
        case 1:
          add_if_it_fits(rings, {{1 + gap, random.between(-1, 1)}, {2, -1}, {2, 1}});
          break;
        case 2:
          add_if_it_fits(rings, {{-1 - gap, -1}, {-1 - gap, 1}, {-2, random.between(-1, 1)}});
          break;
        case 3:
          add_if_it_fits(rings, {{random.between(-1, 1), -1 - gap}, {0.5, -2}, {-0.5, -2}});
          break;
        default:
          add_if_it_fits(rings, box_of({-1 + gap, -1 + gap}, {1 - gap_at(random, 1), random.between(-0.9, 0.9)}));
      }
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Heights a few units in the last place apart, and a kilometre, in one stack.
ContourStack ulp_slabs(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    for (int c = 0; c < random.whole(1, 2); ++c)
      add_if_it_fits(rings, blob(random, points / count / 2, {random.between(-1, 1), random.between(-1, 1)},
                                 random.between(0.5, 3)));
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  double z = one_of(random, {0.0, 1.0, -0.75, 1000.1, 999999.0, -1e6, 1e-300});
  for (Slice& slice : stack.slices) {
    slice.z = z;
    switch (random.below(4)) {
      case 0:
        z += 1;
        break;
      case 1:
        z = z < -5e5 ? z + 1e6 : z < 1 ? 1e6 : z + 0.5;
        break;
      default:
        z = steps_from(z, random.chance(0.7) ? random.whole(1, 9) : random.whole(10, 5000));
    }
  }
  return stack;
}

/// The same contours again, every coordinate off by nothing or a few units in the last place.
ContourStack ulp_copies(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4);
  std::vector<Rings> slices(1);
  add_if_it_fits(slices[0], random.chance(0.5) ? regular({0, 0}, std::max(3, points / count), 0, 2)
                                               : blob(random, points / count, {0.1, 0.2}, 2));
  if (random.chance(0.3)) add_if_it_fits(slices[0], scaled(slices[0][0], 0.4));
  const int reach = one_of(random, {0, 1, 3, 1000, 1 << 20});
  for (int k = 1; k < count; ++k) {
    Rings rings = slices.back();
    for (Ring& ring : rings)
      for (Point2& p : ring)
        p = {steps_from(p.x, random.whole(-reach, reach)), steps_from(p.y, random.whole(-reach, reach))};
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Rings as thin as 1e-9 that slide over each other.
ContourStack thin_rings(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), corners = std::max(3, points / count / 2);
  const double thin = random.chance(0.3) ? 0.1 : small(random, 2, corners > 30 ? 4 : 9);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const Point2 centre{random.chance(0.5) ? 0 : thin * random.between(-1, 1),
                        random.chance(0.8) ? 0 : random.between(-0.5, 0.5)};
    const double radius = random.chance(0.5) ? 2 : 2 + thin * random.between(-1.5, 1.5),
                 angle = random.chance(0.5) ? 0 : random.between(0, 1);
    Rings rings{regular(centre, corners, angle, radius)};
    add_if_it_fits(rings, regular(centre, corners, angle, radius - thin));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// From 1e-5 to 1e4 in one slice.
ContourStack scales(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    for (double size = 1e4; size > 1e-5; size *= random.between(0.001, 0.5))
      if (int(rings.size()) * 6 * count < points)
        add_if_it_fits(rings, blob(random, random.whole(3, 7),
                                   {size * random.between(-0.3, 0.3), size * random.between(-0.3, 0.3)}, size));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

constexpr double decimal_spacings[] = {0.1, 0.2, 0.15, 0.075, 0.3, 0.05, 0.35, 0.4, 0.6, 0.7};

/// Rectangles and staircases on a lattice whose coordinates are origin + i * spacing, rounded.
ContourStack decimal_lattice(RandomNumbers& random, int points) {
  const double step_x = one_of(random, decimal_spacings),
               step_y = random.chance(0.7) ? step_x : one_of(random, decimal_spacings);
  const double x0 = one_of(random, {0.0, -13.3, 0.7, 101.45, -0.1}), y0 = one_of(random, {0.0, -7.9, 3.3, 0.05, -55.5});
  const int count = random.whole(2, 4), size = std::max(4, int(std::sqrt(points)));
  const auto at = [&](int i, int j) { return Point2{x0 + i * step_x, y0 + j * step_y}; };
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    for (int tries = 0; tries < 8; ++tries) {
      const int i0 = random.below(size), j0 = random.below(size), i1 = random.whole(i0 + 1, size),
                j1 = random.whole(j0 + 1, size);
      Ring ring{at(i0, j0)};
      const bool every = random.chance(0.5), cut = random.chance(0.3) && i1 - i0 > 1 && j1 - j0 > 1;
      for (int i = i0 + 1; i < i1; ++i)
        if (every) ring.push_back(at(i, j0));
      for (int j = j0; j < j1; ++j)
        if (every || j == j0) ring.push_back(at(i1, j));
      if (cut)
        ring.insert(ring.end(), {at(i1, j1 - 1), at(i1 - 1, j1 - 1), at(i1 - 1, j1)});
      else
        for (int i = i1; i > i0; --i)
          if (every || i == i1) ring.push_back(at(i, j1));
      for (int j = j1; j > j0; --j)
        if (every || j == j1) ring.push_back(at(i0, j));
      ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
      add_if_it_fits(rings, ring);
    }
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  const double step_z = random.chance(0.5) ? step_x : one_of(random, decimal_spacings);
  for (std::size_t k = 0; k < stack.slices.size(); ++k) stack.slices[k].z = y0 + double(k) * step_z;
  return stack;
}

/// Regular polygons and rings of them about one axis: all points on few circles.
ContourStack cocircular(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), corners = std::max(3, points / count / 2);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    for (int c = 0; c < 2; ++c) {
      Ring all = regular({0, 0}, corners, 0, c == 0 ? 2 : 1), some;
      for (Point2 p : all)
        if (random.chance(0.7)) some.push_back(p);
      add_if_it_fits(rings, some.size() < 3 ? all : some);
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

}  // namespace

const std::vector<NamedMaker>& number_makers() {
  static const std::vector<NamedMaker> makers{{"collinear", collinear},
                                              {"tangent", tangent},
                                              {"ulp-slabs", ulp_slabs},
                                              {"ulp-copies", ulp_copies},
                                              {"thin-rings", thin_rings},
                                              {"scales", scales},
                                              {"decimal-lattice", decimal_lattice},
                                              {"cocircular", cocircular}};
  return makers;
}

}  // namespace odontoscope::test
