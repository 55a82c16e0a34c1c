// Stacks by a tester who has read the source: gaps that propagate, needles that meet, heights and coordinates at the
// ends of their ranges, walls that structures share.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

/// A comb: a spine below y = 0, teeth up to `height`, as wide as the spaces between them less two gaps.
Ring comb(int teeth, double left, double height, double gap) {
  Ring ring{{left, -1}, {left + 2 * teeth, -1}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = left + 2 * i;
    ring.insert(ring.end(), {{x + 2 - gap, 0}, {x + 2 - gap, height}, {x + 1 + gap, height}, {x + 1 + gap, 0}});
  }
  ring.push_back({left, 0});
  return ring;
}

/// Two combs that reach into each other with a narrow gap between them; above them the same shifted by half a tooth, or
/// one of the two.
ContourStack zippers(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), teeth = std::clamp(points / count / 9, 1, 60);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const double gap = random.chance(0.3) ? 0.1 : small(random, 2, 12), shift = one_of(random, {0.0, 0.5, 1.0, 1e-9});
    Rings rings;
    add_if_it_fits(rings, comb(teeth, shift, 3, gap));
    if (random.chance(0.8)) {
      Ring other = comb(teeth, 0, 3, gap);  // turned over, it comes down into the first
      for (Point2& p : other) p = {2 * teeth + shift - p.x, 3 + small(random, 1, 1) - p.y};
      for (Point2& p : other) p.x += shift;
      add_if_it_fits(rings, other);
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

Ring urchin(RandomNumbers& random, int spikes, double inner, double angle) {
  return ring_around({0, 0}, 2 * spikes, angle, [&](int i) { return i % 2 == 0 ? random.between(1, 3) : inner; });
}

/// Stars whose needles all but meet in the middle, turned against each other.
ContourStack urchins(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), spikes = std::clamp(points / count / 2, 3, 400);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    const double inner = random.chance(0.3) ? 0.3 : small(random, 1, 10);
    add_if_it_fits(rings, urchin(random, random.chance(0.6) ? spikes : random.whole(3, spikes), inner,
                                 random.chance(0.5) ? 0 : random.between(0, 1)));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Spirals over fingers: long thin walls that cross each other all over.
ContourStack spirals_over_fingers(RandomNumbers& random, int points) {
  const int steps = std::clamp(points / 4, 8, 500);
  const double turns = std::max(1.0, steps / 16.0), thin = random.between(0.05, 0.45);
  Ring out, in;
  for (int i = 0; i <= steps; ++i) {
    const double t = double(i) / steps, angle = 2 * std::numbers::pi * turns * t, radius = 1 + turns * t;
    out.push_back({settled((radius + thin) * std::cos(angle)), settled((radius + thin) * std::sin(angle))});
    in.push_back({settled(radius * std::cos(angle)), settled(radius * std::sin(angle))});
  }
  out.insert(out.end(), in.rbegin(), in.rend());
  Rings spiral, fingers;
  add_if_it_fits(spiral, out);
  const int teeth = std::clamp(points / 9, 2, 200);
  const double wide = 2 * (turns + 1.5) / (2 * teeth);
  add_if_it_fits(fingers, scaled(moved(comb(teeth, -teeth, 2 * teeth, random.chance(0.5) ? 0.1 : small(random, 2, 7)),
                                       {0, -double(teeth)}),
                                 wide));
  std::vector<Rings> slices{spiral, fingers};
  if (random.chance(0.5)) slices.push_back({turned(out, one_of(random, {0.0, 0.01, std::numbers::pi / 2}))});
  return stacked(random, slices);
}

/// One polygon of very many corners with a hole, and a triangle in the hole that all but touches it; the other slice
/// has few corners.
ContourStack gon_and_triangle(RandomNumbers& random, int points) {
  const int corners = std::max(8, points - 12);
  const double gap = random.chance(0.3) ? 0.2 : small(random, 2, 12);
  Rings many, few;
  add_if_it_fits(many, regular({0, 0}, corners / 2, 0, 2));
  add_if_it_fits(many, regular({0, 0}, corners / 2, random.chance(0.5) ? 0 : 0.01, 1));
  const double apothem = std::cos(std::numbers::pi / (corners / 2));
  add_if_it_fits(many, regular({0, 0}, 3, random.chance(0.5) ? 0 : random.between(0, 6), apothem - gap));
  add_if_it_fits(few, regular({random.between(-0.5, 0.5), 0}, 3, random.between(0, 6), random.chance(0.5) ? 0.4 : 4));
  std::vector<Rings> slices{many, few};
  if (random.chance(0.5)) std::swap(slices[0], slices[1]);
  if (random.chance(0.3)) slices.push_back({regular({0, 0}, 3, 0.5, 1.5)});
  return stacked(random, slices);
}

/// Details of a ten millionth at the end of the range of coordinates.
ContourStack far_details(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3);
  const Point2 far{one_of(random, {999990.0, -999990.0, 0.0}), one_of(random, {999990.0, -999990.0})};
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const double detail = small(random, 5, 8), size = random.chance(0.5) ? 1 : 1000 * detail;
    Rings rings;
    Ring ring = ring_around({0, 0}, std::max(5, points / count), random.between(0, 1),
                            [&](int) { return size + detail * random.between(-1, 1); });
    add_if_it_fits(rings, moved(ring, far));
    if (random.chance(0.5)) add_if_it_fits(rings, moved(regular({detail, 0}, 3, 0.3, size / 2), far));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Heights at denormal distances, at a unit in the last place, and at the ends of their range.
ContourStack extreme_heights(RandomNumbers& random, int points) {
  const int count = random.whole(2, 5);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    add_if_it_fits(rings, regular({random.between(-0.3, 0.3), 0}, std::max(3, points / count), random.between(0, 1),
                                  random.between(0.5, 2)));
    if (random.chance(0.4)) add_if_it_fits(rings, regular({0, 0}, 4, 0.2, 0.2));
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  double z = one_of(random, {-1e6, 0.0, -5e-324, 1e-310, -1e-20});
  for (Slice& slice : stack.slices) {
    slice.z = z;
    switch (random.below(5)) {
      case 0:
        z = steps_from(z, random.whole(1, 12));
        break;
      case 1:
        z = z < 0 ? z / 2 : z + 5e-324 * random.whole(1, 1000);
        break;
      case 2:
        z = std::max(z + 1e-300, steps_from(z, 1));
        break;
      case 3:
        z += std::max(std::abs(z) * 1e-9, 1e-12);
        break;
      default:
        z = z < 0 ? 0.0 : z < 1 ? 1.0 : std::min(1e6, z * 1e3 + 1);
    }
  }
  return stack;
}

/// An inner structure that fills the hole of an outer one, corner for corner, through all slices, and a third that
/// shares single corners.
ContourStack shared_walls(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), corners = std::max(4, points / count / 4);
  ContourStack stack;
  double z = 0;
  Ring hole = regular({0, 0}, corners, 0.1, 1);
  for (int k = 0; k < count; ++k) {
    if (random.chance(0.5)) hole = ring_around({0, 0}, corners, 0.1, [&](int) { return random.between(0.4, 1.2); });
    Ring outer = regular({0, 0}, corners, random.between(0, 1), 3), wedge{hole[0], hole[1], {0, 0}};
    if (random.chance(0.3)) wedge = {hole[0], outer[0], outer[1]};
    Slice slice{z, {{"enamel", outer}, {"enamel", hole}, {"dentine", hole}, {"pulp", wedge}}};
    if (random.chance(0.2)) slice.contours.erase(slice.contours.begin() + 1);
    stack.slices.push_back(slice);
    z += random.between(0.05, 2);
  }
  return stack;
}

}  // namespace

const std::vector<NamedMaker>& attack_makers() {
  static const std::vector<NamedMaker> makers{{"zippers", zippers},
                                              {"urchins", urchins},
                                              {"spirals-over-fingers", spirals_over_fingers},
                                              {"gon-and-triangle", gon_and_triangle},
                                              {"far-details", far_details},
                                              {"extreme-heights", extreme_heights},
                                              {"shared-walls", shared_walls}};
  return makers;
}

}  // namespace odontoscope::test
