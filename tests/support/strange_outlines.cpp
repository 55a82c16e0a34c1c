// Outlines that are awkward by their shape.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/plane_check.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Draws until the ring is simple; after that many tries a triangle.
Ring simple_one(auto draw) {
  for (int tries = 0; tries < 30; ++tries)
    if (Ring ring = draw(); is_simple(ring)) return ring;
  return {{0, 0}, {2, 0}, {0.5, 1.75}};
}

Point2 somewhere(RandomNumbers& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach)};
}

Ring koch(RandomNumbers& random, int points) {
  return simple_one([&] {
    Ring ring = regular(somewhere(random, 0.5), random.whole(3, 6), random.between(0, full_turn), random.between(1, 3));
    const bool alike = random.chance(0.4);
    const double height = random.between(0.15, 0.3);
    while (int(ring.size()) * 2 <= std::max(points, 12)) {
      Ring finer;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 a = ring[i], b = ring[(i + 1) % ring.size()], d{b.x - a.x, b.y - a.y};
        const double side = alike || random.chance(0.5) ? height : -height,
                     jitter = alike ? 0 : random.between(-0.05, 0.05);
        const auto at = [&](double along, double off) {
          return Point2{settled(a.x + along * d.x + off * d.y), settled(a.y + along * d.y - off * d.x)};
        };
        for (Point2 p : {a, at(1.0 / 3 + jitter, 0), at(0.5, side), at(2.0 / 3 + jitter, 0)}) finer.push_back(p);
      }
      ring = finer;
    }
    return ring;
  });
}

Ring coastline(RandomNumbers& random, int points) {
  return simple_one([&] {
    Ring ring = regular(somewhere(random, 1), random.whole(3, 7), random.between(0, full_turn), random.between(1, 3));
    const double rough = random.between(0.1, 0.4);
    while (int(ring.size()) * 2 <= std::max(points, 8)) {
      Ring finer;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
        const double off = random.between(-rough, rough);
        finer.push_back(a);
        finer.push_back({settled((a.x + b.x) / 2 + off * (b.y - a.y)), settled((a.y + b.y) / 2 - off * (b.x - a.x))});
      }
      ring = finer;
    }
    return ring;
  });
}

std::vector<Rings> slices_of_rings(RandomNumbers& random, int points, auto draw) {
  const int slices = random.whole(2, points > 100 ? 4 : 3);
  std::vector<Rings> result;
  for (int k = 0; k < slices; ++k) {
    Rings rings;
    const int wanted = random.chance(0.3) ? 2 : 1;
    for (int c = 0; c < wanted; ++c) {
      Ring ring = draw(random, points / slices / wanted);
      if (c > 0) ring = random.chance(0.5) ? scaled(ring, 0.3) : moved(ring, {random.between(2, 5), 0});
      add_if_it_fits(rings, ring);
    }
    if (k > 0 && random.chance(0.2)) rings = result.back();  // the same again, turned or moved a little
    if (k > 0 && random.chance(0.3) && !result.back().empty()) {
      rings = result.back();
      for (Ring& ring : rings)
        ring = random.chance(0.5) ? turned(ring, random.between(0, 0.3)) : moved(ring, somewhere(random, 0.2));
    }
    result.push_back(rings);
  }
  return result;
}

ContourStack kochs(RandomNumbers& random, int points) { return stacked(random, slices_of_rings(random, points, koch)); }
ContourStack coastlines(RandomNumbers& random, int points) {
  return stacked(random, slices_of_rings(random, points, coastline));
}

/// A bar with teeth that point up.
Ring comb(int teeth, double pitch, double width, double height, double bar) {
  Ring ring{{0, -bar}, {pitch * (teeth - 1) + width, -bar}};
  for (int i = teeth - 1; i >= 0; --i)
    for (Point2 p : {Point2{pitch * i + width, 0}, {pitch * i + width, height}, {pitch * i, height}, {pitch * i, 0}})
      if (!(ring.size() == 2 && p.y == 0)) ring.push_back(p);  // the bar's corner and the last tooth are in line
  ring.pop_back();
  return ring;
}

/// Two combs that reach into each other, in the next slice shifted, turned by a quarter or upside down.
ContourStack fingers(RandomNumbers& random, int points) {
  const int teeth = std::max(2, points / 16);
  const double gap = random.chance(0.5) ? random.between(0.05, 0.4) : small(random, 2, 9);
  const double pitch = 1, width = (pitch - 2 * gap) * random.between(0.3, 1), height = random.between(0.5, 6);
  const Ring up = comb(teeth, pitch, width, height, 0.5);
  Ring down = comb(teeth, pitch, width, height, 0.5);
  for (Point2& p : down) p = {settled(p.x + pitch / 2), settled(height + std::max(gap, 0.05) - p.y)};
  std::vector<Rings> slices;
  for (int k = 0, count = random.whole(2, 3); k < count; ++k) {
    Rings rings{up};
    if (width < pitch / 2) rings.push_back(down);
    const int change = random.below(4);
    const double shift = one_of(random, {0.0, 0.25, 0.5, 1.0, 0.1});
    for (Ring& ring : rings)
      for (Point2& p : ring) {
        if (change == 1) p = {settled(p.y + shift), p.x};
        if (change == 2) p = {settled(p.x + shift), p.y};
        if (change == 3) p = {p.x, settled(height - p.y)};
      }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

Ring spiral(RandomNumbers& random, int points, double start, double direction) {
  const int half = std::max(6, points / 2);
  const double turns = random.between(0.8, std::max(1.0, half / 8.0)), pitch = random.between(0.5, 1);
  const double wide = pitch * random.between(0.05, 0.9);
  Ring ring;
  for (int side = 0; side < 2; ++side)
    for (int j = 0; j < half; ++j) {
      const int i = side == 0 ? j : half - 1 - j;
      const double angle = full_turn * turns * i / (half - 1);
      const double radius = 0.3 + pitch * angle / full_turn + (side == 0 ? 0 : wide);
      const double at = start + direction * angle;
      ring.push_back({settled(radius * std::cos(at)), settled(radius * std::sin(at))});
    }
  return ring;
}

ContourStack spirals(RandomNumbers& random, int points) {
  std::vector<Rings> slices;
  const int count = random.whole(2, 3);
  for (int k = 0; k < count; ++k) {
    if (k > 0 && random.chance(0.3)) {
      Rings rings = slices.back();
      for (Ring& ring : rings) ring = turned(ring, one_of(random, {0.1, 0.5, std::numbers::pi / 2, std::numbers::pi}));
      slices.push_back(rings);
      continue;
    }
    Rings rings;
    add_if_it_fits(rings, spiral(random, points / count, random.between(0, full_turn), random.chance(0.5) ? 1 : -1));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Toothed wheels, bored or not, each turned by half a tooth or so against the one below.
ContourStack gears(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), teeth = std::max(3, points / count / 4);
  const double tip = random.between(1, 4), root = tip * random.between(0.2, 0.95),
               bore = root * random.between(0.1, 0.95);
  const bool bored = random.chance(0.5);
  std::vector<Rings> slices;
  double angle = 0;
  for (int k = 0; k < count; ++k) {
    Rings rings{ring_around({0, 0}, 2 * teeth, angle, [&](int i) { return i % 2 == 0 ? tip : root; })};
    if (bored)
      add_if_it_fits(rings, random.chance(0.5) ? regular({0, 0}, 2 * teeth, angle, bore)
                                               : ring_around({0, 0}, 2 * teeth, angle,
                                                             [&](int i) { return (i % 2 == 0 ? 0.9 : 0.5) * bore; }));
    slices.push_back(rings);
    angle += one_of(random, {0.0, 0.25, 0.5, 1.0}) * full_turn / teeth +
             (random.chance(0.2) ? random.between(-0.1, 0.1) : 0);
  }
  return stacked(random, slices);
}

/// Long triangles, down to 1e-9 wide.
ContourStack needles(RandomNumbers& random, int points) {
  std::vector<Rings> slices;
  const int count = random.whole(2, 3);
  for (int k = 0; k < count; ++k) {
    Rings rings;
    const bool parallel = random.chance(0.3);
    for (int tries = 0; tries < points && int(rings.size()) * 3 * count < points; ++tries) {
      const Point2 a = somewhere(random, 4);
      const double angle = parallel ? 0.3 : random.between(0, full_turn), length = random.between(0.5, 6);
      const double wide = random.chance(0.3) ? random.between(0.01, 0.3) : small(random, 2, 9);
      const Point2 d{settled(length * std::cos(angle)), settled(length * std::sin(angle))};
      add_if_it_fits(
          rings,
          {a, {a.x + d.x, a.y + d.y}, {settled(a.x + d.x * 0.5 - wide * d.y), settled(a.y + d.y * 0.5 + wide * d.x)}});
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Open rings whose mouths face each other, one within the other, turned from slice to slice.
ContourStack hooks(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), half = std::max(3, points / count / 4);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    for (int which = 0; which < 2; ++which) {
      const double from = random.between(0, full_turn), open = random.between(0.3, 2.5), radius = which == 0 ? 3 : 1.6;
      const double wide = random.between(0.05, 0.9);
      Ring ring;
      for (int side = 0; side < 2; ++side)
        for (int j = 0; j < half; ++j) {
          const int i = side == 0 ? j : half - 1 - j;
          const double at = from + (full_turn - open) * i / (half - 1), r = radius - (side == 0 ? 0 : wide);
          ring.push_back({settled(r * std::cos(at)), settled(r * std::sin(at))});
        }
      add_if_it_fits(rings, ring);
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

}  // namespace

const std::vector<NamedMaker>& outline_makers() {
  static const std::vector<NamedMaker> makers{{"koch", kochs},      {"coastline", coastlines}, {"fingers", fingers},
                                              {"spirals", spirals}, {"gears", gears},          {"needles", needles},
                                              {"hooks", hooks}};
  return makers;
}

}  // namespace odontoscope::test
