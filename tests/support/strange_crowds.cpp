// Many contours, tiny ones, nested ones, and slices that share points, edges and whole contours.

#include <algorithm>
#include <cmath>

#include "tests/support/plane_check.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

/// m x m small polygons on a jittered grid.
Rings islands_of(RandomNumbers& random, int m, double jitter, double size) {
  Rings rings;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < m; ++j)
      if (random.chance(0.95))
        rings.push_back(regular({i + jitter * random.between(-1, 1), j + jitter * random.between(-1, 1)},
                                random.whole(3, 4), random.between(0, 6), size * random.between(0.3, 1)));
  return rings;
}

ContourStack islands(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), m = std::max(2, int(std::sqrt(points / count / 3.5)));
  const double jitter = random.chance(0.3) ? 0 : 0.2, size = random.between(0.05, 0.29);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings = islands_of(random, m, jitter, size);
    if (k > 0 && random.chance(0.4)) rings = slices.back();
    const Point2 by{one_of(random, {0.0, 0.5, 0.25, 0.1}), one_of(random, {0.0, 0.5, 0.1})};
    for (Ring& ring : rings) ring = moved(ring, by);
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

ContourStack one_over_many(RandomNumbers& random, int points) {
  const int m = std::max(2, int(std::sqrt(points / 4.0)));
  const double tiny = random.chance(0.5) ? 0.29 : small(random, 1, 6);
  Rings many = islands_of(random, m, 0.1, tiny), one;
  add_if_it_fits(one, random.chance(0.5) ? box_of({-1, -1}, {double(m), double(m)})
                                         : regular({m / 2.0, m / 2.0}, 12, 0.1, double(m)));
  if (random.chance(0.3)) add_if_it_fits(one, regular({m / 2.0, m / 2.0}, 7, 0, m / 4.0));
  std::vector<Rings> slices{many, one};
  if (random.chance(0.5)) std::swap(slices[0], slices[1]);
  if (random.chance(0.4)) slices.push_back(slices[0]);
  return stacked(random, slices);
}

/// Rings within rings, 30 deep if the points allow; above them as many, fewer, or the same shifted by half a ring.
ContourStack nested(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), corners = random.whole(3, 6),
            deep = std::clamp(points / count / corners, 2, 30);
  const double angle = random.between(0, 1);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    const double shift = one_of(random, {0.0, 0.5, 0.25, 0.01}),
                 aside = random.chance(0.3) ? random.between(-0.3, 0.3) : 0;
    const int here = random.chance(0.5) ? deep : random.whole(1, deep);
    for (int d = 0; d < here; ++d)
      add_if_it_fits(rings,
                     regular({aside, 0}, corners, random.chance(0.8) ? angle : angle + 0.3, (d + 1 + shift) * 1.0));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// A board of squares with a gap, its black fields or its white ones, as islands or as holes (with islands in some).
ContourStack checkerboard(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), m = std::max(2, int(std::sqrt(points / count / 2.0)));
  const double gap = random.chance(0.5) ? 0.125 : small(random, 2, 10);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    const int colour = random.below(2);
    const double shift = one_of(random, {0.0, 0.0, 0.5, 0.25});
    if (random.chance(0.5)) rings.push_back(box_of({-0.5, -0.5}, {m + 0.5, m + 0.5}));
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j)
        if ((i + j) % 2 == colour) {
          rings.push_back(box_of({i + gap, j + gap}, {i + 1 - gap, j + 1 - gap}));
          if (random.chance(0.1)) rings.push_back(box_of({i + 0.375, j + 0.375}, {i + 0.625, j + 0.625}));
        }
    for (Ring& ring : rings) ring = moved(ring, {shift, shift});
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Any simple polygon through lattice points.
Ring through_lattice(RandomNumbers& random, int corners, int size) {
  for (int tries = 0; tries < 40; ++tries) {
    Ring ring;
    Point2 middle;
    for (int i = 0; i < corners; ++i) {
      ring.push_back({double(random.whole(0, size)), double(random.whole(0, size))});
      middle = {middle.x + ring.back().x / corners, middle.y + ring.back().y / corners};
    }
    std::sort(ring.begin(), ring.end(), [&](Point2 a, Point2 b) {
      return std::atan2(a.y - middle.y, a.x - middle.x) < std::atan2(b.y - middle.y, b.x - middle.x);
    });
    if (is_simple(ring)) return ring;
  }
  return {{0, 0}, {1, 0}, {0, 1}};
}

/// Three points over four, five over five, hexagon over triangle: few points, many of them the same or on one circle.
ContourStack tiny(RandomNumbers& random, int) {
  std::vector<Rings> slices;
  const Ring circle = regular({1, 1}, 6, 0, 1);
  const double shrink = random.chance(0.5) ? 1 : random.between(0.001, 0.1);
  for (int k = 0, count = random.whole(2, 3); k < count; ++k) {
    Rings rings;
    for (int c = 0; c < random.whole(1, 2); ++c) {
      Ring ring;
      switch (random.below(4)) {
        case 0:
          ring = through_lattice(random, random.whole(3, 6), random.whole(1, 4));
          break;
        case 1:
          for (Point2 p : circle)
            if (random.chance(0.7)) ring.push_back(p);
          break;
        case 2:
          ring = ring_around({random.between(-1, 1), random.between(-1, 1)}, random.whole(3, 6), random.between(0, 6),
                             [&](int) { return random.between(0.01, 2); });
          break;
        default:
          ring = k > 0 && !slices.back().empty() ? slices.back()[0] : circle;
          if (ring.size() > 3) ring.erase(ring.begin() + random.below(int(ring.size())));
      }
      if (random.chance(0.5)) ring = scaled(ring, shrink);
      if (ring.size() >= 3) add_if_it_fits(rings, ring);
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

ContourStack lattice_polygons(RandomNumbers& random, int points) {
  std::vector<Rings> slices;
  const int count = random.whole(2, 4), size = random.whole(2, 6);
  for (int k = 0; k < count; ++k) {
    Rings rings;
    for (int c = 0; c < 4; ++c)
      add_if_it_fits(rings, through_lattice(random, random.whole(3, std::clamp(points / count / 2, 4, 12)), size));
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  if (random.chance(0.7))
    for (std::size_t k = 0; k < stack.slices.size(); ++k) stack.slices[k].z = double(k);
  return stack;
}

/// Contours that share edges and points with the slice below: a point taken out, put in, moved; cut in two; the same.
ContourStack shared_borders(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4);
  std::vector<Rings> slices(1);
  const int corners = std::max(4, points / count);
  add_if_it_fits(slices[0], random.chance(0.5)
                                ? through_lattice(random, std::min(corners, 14), 6)
                                : ring_around({3, 3}, corners, 0, [&](int) { return random.between(1, 3); }));
  for (int k = 1; k < count; ++k) {
    Rings rings = slices.back();
    for (std::size_t c = 0; c < rings.size(); ++c) {
      Ring ring = rings[c];
      const std::size_t n = ring.size(), at = std::size_t(random.below(int(n)));
      const Point2 a = ring[at], b = ring[(at + 1) % n];
      switch (random.below(5)) {
        case 0:
          if (n > 3) ring.erase(ring.begin() + long(at));
          break;
        case 1:
          ring.insert(ring.begin() + long(at) + 1, {(a.x + b.x) / 2, (a.y + b.y) / 2});
          break;
        case 2:
          ring[at] = {a.x + random.between(-0.5, 0.5), a.y + random.between(-0.5, 0.5)};
          break;
        case 3:
          if (n > 5) {  // one half of it
            std::rotate(ring.begin(), ring.begin() + long(at), ring.end());
            ring.resize(n / 2 + 1);
          }
          break;
        default:
          break;
      }
      if (is_simple(ring)) rings[c] = ring;
    }
    if (random.chance(0.2)) add_if_it_fits(rings, scaled(moved(rings[0], {-rings[0][0].x, -rings[0][0].y}), 0.2));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// One slice again and again, shifted by half a cell, a quarter, or a cell.
ContourStack half_cells(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), size = std::max(3, int(std::sqrt(points)));
  Rings first;
  for (int tries = 0; tries < 10; ++tries) {
    const int x = random.below(size), y = random.below(size);
    const Ring ring =
        box_of({double(x), double(y)}, {double(random.whole(x + 1, size)), double(random.whole(y + 1, size))});
    add_if_it_fits(first, random.chance(0.5) ? ring : through_lattice(random, random.whole(3, 8), size));
  }
  std::vector<Rings> slices{first};
  for (int k = 1; k < count; ++k) {
    Rings rings = slices.back();
    const Point2 by{one_of(random, {0.0, 0.5, 1.0, 0.25, -0.5}), one_of(random, {0.0, 0.5, 1.0, -0.5})};
    for (Ring& ring : rings) ring = moved(ring, by);
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  const double height = one_of(random, {1.0, 0.5, 2.0, 1.001});
  for (std::size_t k = 0; k < stack.slices.size(); ++k) stack.slices[k].z = double(k) * height;
  return stack;
}

/// A large region with hundreds of specks over it, down to 1e-7.
ContourStack dust(RandomNumbers& random, int points) {
  std::vector<Rings> slices{{regular({0, 0}, random.whole(3, 9), random.between(0, 1), 5)}};
  Rings specks;
  for (int tries = 0; tries < points && int(specks.size()) * 3 < points; ++tries) {
    const double size = small(random, 1, 7);
    const Point2 at{random.between(-5, 5), random.between(-5, 5)};
    specks.push_back({at,
                      {at.x + size, at.y + size * random.between(-0.5, 0.5)},
                      {at.x + size * random.between(-0.5, 0.5), at.y + size}});
  }
  slices.push_back(specks);
  if (random.chance(0.5)) slices.push_back(slices[0]);
  return stacked(random, slices);
}

}  // namespace

const std::vector<NamedMaker>& crowd_makers() {
  static const std::vector<NamedMaker> makers{{"islands", islands},
                                              {"one-over-many", one_over_many},
                                              {"nested", nested},
                                              {"checkerboard", checkerboard},
                                              {"tiny", tiny},
                                              {"lattice-polygons", lattice_polygons},
                                              {"shared-borders", shared_borders},
                                              {"half-cells", half_cells},
                                              {"dust", dust}};
  return makers;
}

}  // namespace odontoscope::test
