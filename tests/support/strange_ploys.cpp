// Stacks of many slices, and slices that fit each other too well: twists, canals that wind, holes that fill what they
// are in, jigsaws.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// A star whose hole is a star again, corners all but touching corners, or corners all but touching edges; an island
/// that does the same to the hole.
ContourStack touching_stars(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), corners = std::max(3, points / count / 6);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const double gap = random.chance(0.2) ? 0.1 : small(random, 2, 14),
                 angle = random.chance(0.6) ? 0 : random.between(0, 1);
    const double deep = random.between(0.3, 0.95);
    Rings rings{ring_around({0, 0}, 2 * corners, angle, [&](int i) { return i % 2 == 0 ? 2 : 2 * deep; })};
    const int half = random.below(2);  // the hole's corners meet the star's inner corners, or all do
    Ring hole = half == 0 ? regular({0, 0}, corners, angle + full_turn / (2 * corners), 2 * deep - gap)
                          : scaled(rings[0], 1 - gap);
    add_if_it_fits(rings, hole);
    if (random.chance(0.5)) add_if_it_fits(rings, scaled(hole, 1 - gap));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Holes that fill what they are in to 1e-12, and islands that fill the holes; above it the same, or only one of them.
ContourStack filled_holes(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), corners = std::max(3, points / count / 3);
  const double gap = small(random, 3, 13), rough = random.chance(0.5) ? 0 : random.between(0, 0.6);
  std::vector<Rings> slices;
  Ring outer = ring_around({0, 0}, corners, 0, [&](int) { return 2 * (1 - rough * random.unit()); });
  for (int k = 0; k < count; ++k) {
    if (random.chance(0.3))
      outer = ring_around({0, 0}, corners, random.between(0, 1), [&](int) { return 2 * (1 - rough * random.unit()); });
    Rings rings;
    const int first =
        random.below(3);  // 0: from the outer one, 1: what would be the hole alone, 2: what would be the island alone
    for (int ring = first; ring < random.whole(first + 1, 4); ++ring)
      add_if_it_fits(rings, scaled(outer, 1 - ring * gap));
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// The same slim contour in all slices, turned a little more each time, or by the same large angle; now and then with a
/// hole, or two side by side.
ContourStack twists(RandomNumbers& random, int points) {
  const int corners = std::clamp(points / 12, 3, 60), count = std::clamp(points / corners / 2, 2, 120);
  const double slim = random.between(0.01, 0.5),
               step = one_of(random, {0.05, 0.3, 0.8, std::numbers::pi / 2, std::numbers::pi, 2.4});
  Ring bar = ring_around({0, 0}, corners, 0.1, [](int) { return 3; });
  for (Point2& p : bar) p.y = settled(p.y * slim);
  const bool bored = random.chance(0.4), two = random.chance(0.3);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    add_if_it_fits(rings, turned(bar, k * step));
    if (bored) add_if_it_fits(rings, turned(scaled(bar, 0.6), k * step));
    if (two) add_if_it_fits(rings, turned(moved(bar, {0, 7 * slim}), k * step));
    slices.push_back(rings);
  }
  ContourStack stack = stacked(random, slices);
  if (random.chance(0.7))
    for (std::size_t k = 0; k < stack.slices.size(); ++k) stack.slices[k].z = 0.25 * double(k);
  return stack;
}

/// Hundreds of slices of one triangle, the same or trembling, at even heights or at heights that grow by powers.
ContourStack towers(RandomNumbers& random, int points) {
  const int count = std::max(3, points / 3);
  const double tremble = random.chance(0.3) ? 0 : small(random, 1, 12), step = one_of(random, {0.1, 1e-3, 1e-9, 2.0});
  const Ring triangle{{0, 0}, {1, 0.125}, {0.25, 1}};
  ContourStack stack;
  double z = 0;
  for (int k = 0; k < count; ++k) {
    Ring ring = triangle;
    for (Point2& p : ring) p = {p.x + tremble * random.between(-1, 1), p.y + tremble * random.between(-1, 1)};
    stack.slices.push_back({z, {{"tooth", ring}}});
    z += step;
  }
  return stack;
}

/// Slices with contours and slices without take turns, at the ends of the stack too; two empty ones in a row.
ContourStack now_and_then(RandomNumbers& random, int points) {
  const int full = std::clamp(points / 16, 1, 60), corners = std::max(3, points / full / 2);
  std::vector<Rings> slices;
  if (random.chance(0.5)) slices.emplace_back();
  for (int k = 0; k < full; ++k) {
    Rings rings{regular({random.between(-0.5, 0.5), 0}, corners, random.between(0, 1), random.between(0.5, 2))};
    if (random.chance(0.5)) add_if_it_fits(rings, scaled(rings[0], random.between(0.1, 0.9)));
    slices.push_back(rings);
    for (int i = random.whole(random.chance(0.7) ? 1 : 0, 2); i > 0; --i) slices.emplace_back();
  }
  if (slices.size() < 2) slices.emplace_back();
  return stacked(random, slices);
}

/// A disc with canals that wind round each other by more than their own width a slice, and meet and part at times.
ContourStack winding_canals(RandomNumbers& random, int points) {
  const int canals = random.whole(1, 4), corners = std::clamp(points / 30, 3, 24),
            count = std::clamp(points / (corners * (canals + 1)), 2, 60);
  const double orbit = random.between(0.3, 1.5), wide = random.between(0.02, 0.5), step = random.between(0.1, 3.2);
  const bool material = random.chance(0.5);  // the canals are what is drawn, with nothing round them
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    Rings rings;
    if (!material) rings.push_back(regular({0, 0}, corners + 5, 0.2, 2.25));
    for (int c = 0; c < canals; ++c) {
      const double at = full_turn * c / canals + k * step,
                   far = orbit * (random.chance(0.2) ? random.between(0.3, 1) : 1);
      add_if_it_fits(rings, regular({settled(far * std::cos(at)), settled(far * std::sin(at))}, corners, at, wide));
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

/// Structures that share their walls corner for corner, four of them so laid that none meets itself; cells are left
/// out, moved, swapped.
ContourStack jigsaws(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), m = std::clamp(int(std::sqrt(points / count / 4.0)), 2, 20);
  constexpr const char* names[] = {"enamel", "dentine", "pulp", "cement"};
  const double step = one_of(random, {1.0, 0.1, 0.3, 1e-3}), rough = random.chance(0.5) ? 0 : random.between(0, 0.3);
  ContourStack stack;
  double z = 0;
  std::vector<Point2> corner;
  for (int k = 0; k < count; ++k) {
    if (k == 0 || random.chance(0.4)) {
      corner.clear();
      for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= m; ++j)
          corner.push_back({step * (i + rough * random.between(-1, 1)), step * (j + rough * random.between(-1, 1))});
    }
    const auto at = [&](int i, int j) { return corner[std::size_t(i * (m + 1) + j)]; };
    const int shift = random.below(2);
    Slice slice{z, {}};
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j)
        if (random.chance(0.85))
          slice.contours.push_back(
              {names[(i + shift) % 2 + 2 * (j % 2)], {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
    stack.slices.push_back(slice);
    z += step * random.between(0.2, 2);
  }
  return stack;
}

/// Bars over bars laid crosswise: a grating whose crossings make as many handles as there are meshes.
ContourStack gratings(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), bars = std::clamp(points / count / 4, 2, 24);
  std::vector<Rings> slices;
  for (int k = 0; k < count; ++k) {
    const double wide = random.chance(0.3) ? small(random, 1, 9) : random.between(0.1, 0.9),
                 angle = one_of(random, {0.0, std::numbers::pi / 2, 0.01, 1.0});
    const bool across = random.chance(0.5);
    Rings rings;
    for (int b = 0; b < bars; ++b) {
      Ring bar = box_of({-0.5, b - wide / 2}, {bars - 0.5, b + wide / 2});
      if (across)
        for (Point2& p : bar) p = {p.y, p.x};
      if (across) std::reverse(bar.begin(), bar.end());
      add_if_it_fits(rings, angle == 0 || random.chance(0.5) ? bar : turned(bar, angle));
    }
    slices.push_back(rings);
  }
  return stacked(random, slices);
}

}  // namespace

const std::vector<NamedMaker>& ploy_makers() {
  static const std::vector<NamedMaker> makers{{"touching-stars", touching_stars},
                                              {"filled-holes", filled_holes},
                                              {"twists", twists},
                                              {"towers", towers},
                                              {"now-and-then", now_and_then},
                                              {"winding-canals", winding_canals},
                                              {"jigsaws", jigsaws},
                                              {"gratings", gratings}};
  return makers;
}

}  // namespace odontoscope::test
