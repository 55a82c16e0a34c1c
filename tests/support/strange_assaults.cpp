// Stacks by a tester who has read the other kinds: what they leave out.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Five or so copies of one ragged outline within each other, each a few units in the last place from the next, all
/// along.
ContourStack onion_skins(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), corners = std::clamp(points / count / 4, 3, 120);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    if (k > 0 && random.chance(0.4)) {
      rings = {ring_around({0.3, 0}, std::max(3, corners / 2), 0, [&](int) { return random.between(1, 2.5); })};
    } else {
      const double rough = random.chance(0.5) ? 0.0 : random.between(0, 0.4), step = random.whole(4, 4000) * 0x1p-52;
      const Ring outer = ring_around({random.between(-1, 1), 0}, corners, random.between(0, 1),
                                     [&](int) { return 2 * (1 - rough * random.unit()); });
      for (int skin = 0, skins = random.whole(2, 5); skin < skins; ++skin)
        add_if_it_fits(rings, scaled(outer, 1 - skin * step));
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Strips side by side along a slanted line, each parted from the next by next to nothing.
ContourStack planks(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), strips = std::clamp(points / count / 6, 2, 60);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const double angle = random.between(0, full_turn), gap = small(random, 6, 15),
                 wide = random.chance(0.3) ? 0.5 : small(random, 1, 12);
    Rings rings;
    double at = 0;
    for (int i = 0; i < strips; ++i) {
      const double from = random.between(0, 0.2), to = random.between(1, 3);
      add_if_it_fits(rings, turned(box_of({from, at}, {to, at + wide}), angle));
      if (rings.empty()) add_if_it_fits(rings, box_of({from, at}, {to, at + wide}));
      at += wide + gap;
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// A Hilbert curve, thickened: a lattice of 2^order cells a side.
Ring hilbert(int order, double thickness) {
  const int side = 1 << order;
  std::vector<Point2> way;
  for (int d = 0; d < side * side; ++d) {
    int x = 0, y = 0;
    for (int s = 1, t = d; s < side; s *= 2, t /= 4) {
      const int rx = 1 & (t / 2), ry = 1 & (t ^ rx);
      if (ry == 0) {
        if (rx == 1) x = s - 1 - x, y = s - 1 - y;
        std::swap(x, y);
      }
      x += s * rx;
      y += s * ry;
    }
    way.push_back({double(x), double(y)});
  }
  Ring left, right;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Point2 a = way[i == 0 ? 0 : i - 1], b = way[i], c = way[i + 1 == way.size() ? i : i + 1];
    Point2 in{b.x - a.x, b.y - a.y}, out{c.x - b.x, c.y - b.y};
    if (i == 0) in = out;
    if (i + 1 == way.size()) out = in;
    const double cross = in.x * out.y - in.y * out.x;
    if (cross == 0 && i > 0 && i + 1 < way.size()) continue;  // straight on
    const Point2 side_way = cross == 0 ? Point2{-in.y, in.x} : Point2{-in.y - out.y, in.x + out.x};
    left.push_back({b.x + side_way.x * thickness, b.y + side_way.y * thickness});
    right.push_back({b.x - side_way.x * thickness, b.y - side_way.y * thickness});
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  return left;
}

/// Hilbert curves over each other: another order, turned, or moved by half a cell.
ContourStack hilbert_curves(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3);
  int order = 1;
  while (order < 4 && (4 << (2 * order)) * count * 2 <= points * 2) ++order;
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const int own = std::max(1, order - random.below(2));
    Ring ring = hilbert(own, one_of(random, {0.25, 0.1, 0.4999999, 1e-6}));
    ring = scaled(ring, 4.0 / (1 << own));
    if (random.chance(0.4))
      for (Point2& p : ring) p = {p.y, 4 - p.x};
    if (random.chance(0.3)) ring = moved(ring, {2.0 / (1 << own), 0.1});
    Rings rings;
    add_if_it_fits(rings, ring);
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Rings within rings, twenty deep; in the next slice material and void have changed places, or they are a little
/// narrower.
ContourStack matryoshkas(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), deep = random.whole(2, 20), corners = std::max(3, points / count / deep);
  const double gap = random.chance(0.7) ? 0.1 : small(random, 2, 9);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const int first = random.below(2);
    const double shrink = one_of(random, {1.0, 1.0, 0.97, 0.5}),
                 angle = random.chance(0.5) ? 0.1 : random.between(0, 1);
    Rings rings;
    for (int i = first; i < deep; ++i) add_if_it_fits(rings, regular({0, 0}, corners, angle, (3 - i * gap) * shrink));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Holes of one slice are the islands of the next, corner for corner, and the frame comes and goes.
ContourStack complements(RandomNumbers& random, int points) {
  const int count = random.whole(2, 5), corners = random.whole(3, 7),
            islands = std::clamp(points / count / corners, 1, 80);
  Rings holes;
  for (int i = 0; i < islands; ++i)
    add_if_it_fits(holes, ring_around({random.between(-2, 2), random.between(-2, 2)}, corners, random.between(0, 6),
                                      [&](int) { return random.between(0.05, 0.8); }));
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings = holes;
    if (random.chance(0.5)) rings.insert(rings.begin(), box_of({-4, -4}, {4, 4}));
    if (rings.size() > 2 && random.chance(0.4)) rings.erase(rings.begin() + 1 + random.below(int(rings.size()) - 1));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Slices all through the same points, joined in other ways: polygons sorted round centres of their own.
ContourStack same_points(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), corners = std::clamp(points / count, 5, 300);
  Ring all;
  const bool on_lattice = random.chance(0.4);
  for (int i = 0; i < corners; ++i) {
    const Point2 p = on_lattice ? Point2{double(random.below(12)), double(random.below(12))}
                                : Point2{settled(random.between(0, 12)), settled(random.between(0, 12))};
    if (std::find(all.begin(), all.end(), p) == all.end()) all.push_back(p);
  }
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const Point2 from{settled(random.between(2, 10)) + 1e-3, settled(random.between(2, 10)) + 1.7e-3};
    Ring ring = all;
    std::sort(ring.begin(), ring.end(), [from](Point2 a, Point2 b) {
      return std::atan2(a.y - from.y, a.x - from.x) < std::atan2(b.y - from.y, b.x - from.x);
    });
    Rings rings;
    add_if_it_fits(rings, ring);
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Petals round one point that none of them reaches, turned from slice to slice by less than a petal.
ContourStack pinwheels(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), petals = std::clamp(points / count / 4, 3, 90);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const double eye = small(random, 1, 9), angle = random.between(0, 1),
                 wide = random.between(0.2, 0.95) * std::numbers::pi / petals;
    Rings rings;
    for (int i = 0; i < petals; ++i) {
      const double at = angle + full_turn * i / petals;
      const auto polar = [&](double r, double a) { return Point2{settled(r * std::cos(a)), settled(r * std::sin(a))}; };
      add_if_it_fits(rings,
                     {polar(eye, at), polar(2, at - wide), polar(random.between(2.1, 3), at), polar(2, at + wide)});
    }
    if (random.chance(0.3)) add_if_it_fits(rings, regular({0, 0}, 6, 0, eye / 2));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Heights from a unit in the last place to a kilometre within one stack of ordinary outlines.
ContourStack accordions(RandomNumbers& random, int points) {
  const int count = random.whole(3, 7);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings{ring_around({random.between(-0.5, 0.5), 0}, std::max(4, points / count), random.between(0, 1),
                            [&](int) { return random.between(1, 2); })};
    if (random.chance(0.4)) add_if_it_fits(rings, scaled(rings[0], 0.4));
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  double z = one_of(random, {0.0, 1.0, -1e5, 123456.7, 1e-300});
  for (Slice& slice : stack.slices) {
    slice.z = z;
    if (random.chance(0.4))
      z = steps_from(z, random.whole(1, 40));
    else
      z += one_of(random, {1e-9, 1e-3, 0.1, 1.0, 1e5});
  }
  return stack;
}

/// Beads in rows, every one over none, one or two of the next: with many links (strange_stack) pieces are knotted.
ContourStack knots(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), beads = std::clamp(points / count / 4, 2, 60);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    for (int i = 0; i < beads; ++i)
      add_if_it_fits(rings, regular({settled(random.between(-3, 3)), settled(random.between(-3, 3))},
                                    random.whole(3, 5), random.between(0, 1), random.between(0.1, 0.6)));
    if (random.chance(0.3)) add_if_it_fits(rings, box_of({-5, -5}, {5, 5}));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

}  // namespace

const std::vector<NamedMaker>& assault_makers() {
  static const std::vector<NamedMaker> makers{
      {"onion-skins", onion_skins}, {"planks", planks},           {"hilbert-curves", hilbert_curves},
      {"matryoshkas", matryoshkas}, {"complements", complements}, {"same-points", same_points},
      {"pinwheels", pinwheels},     {"accordions", accordions},   {"knots", knots}};
  return makers;
}

}  // namespace odontoscope::test
