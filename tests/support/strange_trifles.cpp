// Stacks that are awkward by trifles: numbers at the very ends of doubles, points that say nothing, slices that differ
// in next to nothing, the same again in another order.

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

Ring blob(RandomNumbers& random, int points, double radius) {
  return ring_around({0, 0}, std::max(3, points), random.between(0, 6),
                     [&](int) { return radius * random.between(0.5, 1); });
}

/// Contours so small that squares of their size are denormal, or nothing.
ContourStack minute(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3);
  const double size = one_of(random, {1e-60, 1e-100, 1e-155, 1e-162, 1e-200, 1e-300, 1e-307, 5e-320});
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    const Ring ring = blob(random, points / count, 2), inner = scaled(ring, 0.5);
    add_if_it_fits(rings, scaled(ring, size));
    if (random.chance(0.3)) add_if_it_fits(rings, scaled(inner, size));
    if (random.chance(0.3))
      add_if_it_fits(rings, moved(blob(random, 4, 1), {random.between(-5, 5), 5}));  // beside something large
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  if (random.chance(0.5))
    for (std::size_t k = 0; k < stack.slices.size(); ++k) stack.slices[k].z = size * double(k);
  return stack;
}

/// Contours that fill the whole range of coordinates, with details down to a micron, and heights that do.
ContourStack vast(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings{scaled(random.chance(0.5) ? box_of({-1, -1}, {1, 1}) : blob(random, points / count / 2, 1), 1e6)};
    for (int c = 0; c < 3; ++c)
      add_if_it_fits(rings, moved(scaled(blob(random, points / count / 6, 1), small(random, -4, 3)),
                                  {1e6 * random.between(-1, 1), 1e6 * random.between(-1, 1)}));
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  const double low = random.chance(0.5) ? -1e6 : -1e-3;
  for (std::size_t k = 0; k < stack.slices.size(); ++k)
    stack.slices[k].z = low * (1 - 2.0 * double(k) / double(count - 1));
  return stack;
}

/// Boxes with points by the hundred exactly on their edges; in the next slice between those, on fewer edges, or in
/// other numbers.
ContourStack exactly_straight(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const auto box = [&](double low, double high, int each) {
      Ring ring;
      const Ring corners = box_of({low, low}, {high, high});
      for (std::size_t side = 0; side < 4; ++side) {
        const Point2 a = corners[side], b = corners[(side + 1) % 4];
        const int here = random.chance(0.2) ? 1 : each;
        for (int i = 0; i < here; ++i) ring.push_back({a.x + (b.x - a.x) * i / here, a.y + (b.y - a.y) * i / here});
      }
      return ring;
    };
    int each = 1;  // a power of two, so that all points lie on their edge exactly
    while (each * 16 * count < points) each *= 2;
    const double shift = one_of(random, {0.0, 0.0, 0.5, 1.0 / each});
    Rings rings;
    add_if_it_fits(rings, moved(box(0, 8, random.chance(0.3) ? each * 2 : each), {shift, 0}));
    if (random.chance(0.6)) add_if_it_fits(rings, moved(box(2, 6, each), {shift, 0}));
    if (random.chance(0.3)) add_if_it_fits(rings, moved(box(3, 5, std::max(1, each / 2)), {shift, 0}));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// A fractal over the one a step coarser, which has every other of its corners, edges in common, or over its mirror
/// image.
ContourStack generations(RandomNumbers& random, int points) {
  Ring ring = regular({0, 0}, random.whole(3, 5), 0.25, 2);
  const double height = random.between(0.1, 0.28), side = random.chance(0.7) ? 1 : -1;
  std::vector<Rings> slices{{ring}};
  std::size_t all = ring.size();
  while (all + ring.size() * 4 <= std::size_t(std::max(points, 20))) {
    Ring finer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 a = ring[i], b = ring[(i + 1) % ring.size()], d{b.x - a.x, b.y - a.y};
      finer.insert(finer.end(), {a,
                                 {a.x + d.x / 3, a.y + d.y / 3},
                                 {a.x + d.x / 2 + side * height * d.y, a.y + d.y / 2 - side * height * d.x},
                                 {a.x + 2 * d.x / 3, a.y + 2 * d.y / 3}});
    }
    ring = finer;
    all += ring.size();
    slices.push_back({});
    add_if_it_fits(slices.back(), ring);
  }
  if (random.chance(0.3)) std::reverse(slices.begin(), slices.end());
  if (random.chance(0.3)) {
    Ring mirrored = ring;
    for (Point2& p : mirrored) p.x = -p.x;
    slices.push_back({mirrored});
  }
  return stacked(random, slices);
}

/// Slices that differ in one corner by 1e-3 to 1e-12, in where their lists begin, or in which way they run.
ContourStack nearly_equal(RandomNumbers& random, int points) {
  const int corners = std::clamp(points / 6, 3, 200), count = std::clamp(points / corners / 2, 2, 60);
  Rings rings{blob(random, corners, 2)};
  add_if_it_fits(rings, scaled(rings[0], 0.5));
  if (random.chance(0.3)) add_if_it_fits(rings, scaled(rings[0], 0.2));
  std::vector<Rings> slices{rings};
  for (int k = 1; k < count; ++k) {
    Ring& ring = rings[std::size_t(random.below(int(rings.size())))];
    const Ring before = ring;
    const std::size_t at = std::size_t(random.below(int(ring.size())));
    switch (random.below(4)) {
      case 0:
        std::rotate(ring.begin(), ring.begin() + long(at), ring.end());
        break;
      case 1:
        std::reverse(ring.begin(), ring.end());
        break;
      case 2:
        ring[at].x += small(random, 3, 12);
        break;
      default:
        ring[at] = {ring[at].x == 0 ? -0.0 : ring[at].x, steps_from(ring[at].y, random.whole(-3, 3))};
    }
    if (Rings all = {}; !std::all_of(rings.begin(), rings.end(), [&](const Ring& r) { return add_if_it_fits(all, r); }))
      ring = before;
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// A square with holes within holes' places, over it the same holes as islands, or the next generation of holes.
ContourStack carpets(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3);
  const double part = one_of(random, {1.0, 0.9, 0.5, 0.999999});  // of a third, that a hole takes
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings holes;
    std::vector<std::array<double, 3>> fields{{-0.5, -0.5, 1}};
    while (!fields.empty() && int(holes.size() + fields.size()) * 4 * count <= std::max(points, 12 * count)) {
      std::vector<std::array<double, 3>> next;
      for (const auto& [x, y, side] : fields) {
        const double rim = side / 3 + side / 6 * (1 - part) + (part == 1.0 ? side / 1024 : 0);
        holes.push_back(box_of({x + rim, y + rim}, {x + side - rim, y + side - rim}));
        for (int i = 0; i < 9; ++i)
          if (i != 4) next.push_back({x + i % 3 * side / 3, y + i / 3 * side / 3, side / 3});
      }
      fields = next;
    }
    if (random.chance(0.6)) holes.push_back(box_of({-0.5, -0.5}, {0.5, 0.5}));
    const double scale = one_of(random, {3.0, 3.0, 1.0, 0.3});
    for (Ring& ring : holes) ring = scaled(ring, scale);
    slices.push_back(holes);
  }
  return stacked(random, slices);
}

/// Needles as a fan from one place, those of the next slice from another, so that all cross all; tips end at any
/// length.
ContourStack fans(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), needles = std::clamp(points / count / 3, 2, 60);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const Point2 from{random.between(-1, 1), random.between(-1, 1)};
    const double spread = random.between(0.1, 3), thin = random.chance(0.3) ? 0.2 : small(random, 1, 8),
                 first = random.between(0, 6);
    Rings rings;
    for (int i = 0; i < needles; ++i) {
      const double at = first + spread * i / needles, near = random.between(0.05, 0.2), far = random.between(1, 4),
                   wide = near * thin * spread / needles;
      const Point2 d{std::cos(at), std::sin(at)};
      const Ring needle{{from.x + near * d.x - wide * d.y, from.y + near * d.y + wide * d.x},
                        {from.x + near * d.x + wide * d.y, from.y + near * d.y - wide * d.x},
                        {from.x + far * d.x, from.y + far * d.y}};
      add_if_it_fits(rings, random.chance(0.5) ? needle : Ring{needle[2], needle[1], needle[0]});
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

}  // namespace

const std::vector<NamedMaker>& trifle_makers() {
  static const std::vector<NamedMaker> makers{{"minute", minute},
                                              {"vast", vast},
                                              {"exactly-straight", exactly_straight},
                                              {"generations", generations},
                                              {"nearly-equal", nearly_equal},
                                              {"carpets", carpets},
                                              {"fans", fans}};
  return makers;
}

}  // namespace odontoscope::test
