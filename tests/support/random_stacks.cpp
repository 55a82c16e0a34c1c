#include "tests/support/random_stacks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "tests/support/plane_check.h"
#include "tests/support/random_numbers.h"
#include "tests/support/voxel_outlines.h"

namespace odontoscope::test {
namespace {

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;
constexpr double box = 10;

/// Mathematics libraries differ in the last bit of a cosine; rounding to a fixed grid far finer than any feature hides
/// that.
double settled(double value) { return std::round(value * 0x1p46) * 0x1p-46; }

Ring around(RandomNumbers& random, Point2 centre, int count, auto radius_at) {
  Ring ring;
  const double turn_by = random.between(0, 2 * std::numbers::pi);
  for (int i = 0; i < count; ++i) {
    const double angle = turn_by + 2 * std::numbers::pi * (i + random.between(-0.3, 0.3)) / count;
    const double radius = radius_at(i);
    ring.push_back({settled(centre.x + radius * std::cos(angle)), settled(centre.y + radius * std::sin(angle))});
  }
  return ring;
}

Point2 somewhere(RandomNumbers& random) { return {random.between(0, box), random.between(0, box)}; }

Ring random_blob(RandomNumbers& random) {
  const double radius = random.chance(0.3) ? random.between(2.5, 5) : random.between(0.4, 2.5);
  const double roughness = random.between(0, 0.4);
  return around(random, somewhere(random), random.whole(3, 22),
                [&](int) { return radius * (1 + random.between(-roughness, roughness)); });
}

Ring random_star(RandomNumbers& random) {
  const double tip = random.between(1, 5), notch = tip * random.between(0.08, 0.5);
  return around(random, somewhere(random), 2 * random.whole(3, 11),
                [&](int i) { return (i % 2 == 0 ? tip : notch) * random.between(0.8, 1.2); });
}

Ring lattice_rectangle(RandomNumbers& random, int size) {
  const int x = random.whole(0, size - 1), y = random.whole(0, size - 1);
  const int w = random.whole(1, size - x), h = random.whole(1, size - y);
  const int step_x = random.chance(0.5) ? 1 : w, step_y = random.chance(0.5) ? 1 : h;
  Ring ring;
  for (int i = 0; i < w; i += step_x) ring.push_back({double(x + i), double(y)});
  for (int i = 0; i < h; i += step_y) ring.push_back({double(x + w), double(y + i)});
  for (int i = w; i > 0; i -= step_x) ring.push_back({double(x + i), double(y + h)});
  for (int i = h; i > 0; i -= step_y) ring.push_back({double(x), double(y + i)});
  return ring;
}

Ring lattice_shape(RandomNumbers& random, int size) {
  if (random.chance(0.5)) return lattice_rectangle(random, size);
  Ring ring = random.chance(0.5) ? random_star(random) : random_blob(random);
  for (Point2& p : ring) p = {p.x * size / box, p.y * size / box};
  return ring;
}

bool fits(const Rings& rings, const Ring& ring) {
  return is_simple(ring) &&
         std::all_of(rings.begin(), rings.end(), [&](const Ring& other) { return are_disjoint(ring, other); });
}

/// The slice above resembles the one below: every contour moved and scaled a little, if it still fits.
Rings resembling(RandomNumbers& random, const Rings& below) {
  const Point2 drift{random.between(-0.8, 0.8), random.between(-0.8, 0.8)};
  Rings rings;
  for (const Ring& from : below) {
    const double size = random.between(0.8, 1.2);
    Ring ring = from;
    for (Point2& p : ring) {
      p.x = settled(from[0].x + size * (p.x - from[0].x) + drift.x + random.between(-0.05, 0.05));
      p.y = settled(from[0].y + size * (p.y - from[0].y) + drift.y + random.between(-0.05, 0.05));
    }
    if (fits(rings, ring)) rings.push_back(ring);
  }
  return rings;
}

/// A smaller copy, which mostly lies within: a hole, or an island in a hole.
Ring within(RandomNumbers& random, const Ring& outer) {
  Point2 middle;
  for (Point2 p : outer) middle = {middle.x + p.x / double(outer.size()), middle.y + p.y / double(outer.size())};
  const double size = random.between(0.3, 0.85);
  Ring ring;
  for (Point2 p : outer) {
    const double here = size * random.between(0.9, 1.1);
    ring.push_back({settled(middle.x + here * (p.x - middle.x)), settled(middle.y + here * (p.y - middle.y))});
  }
  return ring;
}

Ring on_lattice(Ring ring) {
  for (Point2& p : ring) p = {std::round(p.x), std::round(p.y)};
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

Rings placed(RandomNumbers& random, auto make_ring, auto rounded) {
  Rings rings;
  const int wanted = random.whole(1, 6);
  for (int tries = 0; tries < 12 * wanted && int(rings.size()) < wanted; ++tries) {
    const bool nested = !rings.empty() && random.chance(0.5);
    const Ring ring = rounded(nested ? within(random, rings.back()) : make_ring(random));
    if (fits(rings, ring)) rings.push_back(ring);
  }
  return rings;
}

enum class Kind { blobs, stars, lattice, voxels, field };

struct Plan {
  Kind kind;
  int slices;
  int lattice_size;
  bool on_lattice() const { return kind == Kind::lattice || kind == Kind::voxels; }
};

std::vector<Rings> shapes_of(RandomNumbers& random, const Plan& plan) {
  const WavyField field(random);
  std::vector<Rings> slices;
  for (int k = 0; k < plan.slices; ++k) {
    if (random.chance(0.06)) {
      slices.emplace_back();
    } else if (plan.kind == Kind::voxels || plan.kind == Kind::field) {
      slices.push_back(outlines(field, plan.lattice_size + 2, k, {.interpolated = plan.kind == Kind::field}));
    } else if (plan.kind == Kind::lattice) {
      slices.push_back(
          k > 0 && random.chance(0.2)
              ? slices.back()
              : placed(
                    random, [&](RandomNumbers& r) { return lattice_shape(r, plan.lattice_size); }, on_lattice));
    } else if (k > 0 && !slices.back().empty() && random.chance(0.5)) {
      slices.push_back(resembling(random, slices.back()));
    } else {
      slices.push_back(
          placed(random, plan.kind == Kind::blobs ? random_blob : random_star, [](const Ring& ring) { return ring; }));
    }
  }
  return slices;
}

void add_structure(RandomNumbers& random, const Plan& plan, const std::string& structure, ContourStack& stack) {
  const std::vector<Rings> shapes = shapes_of(random, plan);
  for (std::size_t k = 0; k < shapes.size(); ++k)
    for (Ring ring : shapes[k]) {
      if (random.chance(0.5)) std::reverse(ring.begin(), ring.end());
      stack.slices[k].contours.push_back({structure, ring});
    }
}

/// Far from the origin or very small, as long as that leaves the contours valid.
ContourStack displaced(RandomNumbers& random, const ContourStack& stack) {
  const double factor = random.chance(0.5) ? 1 : 0x1p-14;
  const Point2 by = random.chance(0.5) ? Point2{} : Point2{65536, -131072};
  ContourStack result = stack;
  for (Slice& slice : result.slices)
    for (Contour& contour : slice.contours)
      for (Point2& p : contour.points) p = {p.x * factor + by.x, p.y * factor + by.y};
  return breach(result).empty() ? result : stack;
}

std::string name_of(Kind kind) {
  constexpr const char* names[] = {"blobs", "stars", "lattice", "voxels", "field"};
  return names[int(kind)];
}

}  // namespace

RandomStack random_stack(std::uint64_t seed) {
  RandomNumbers random(seed);
  RandomStack result;
  do {
    const Plan plan{Kind(random.below(5)), random.whole(2, 5), random.whole(4, 9)};
    result = {{}, name_of(plan.kind), !plan.on_lattice()};
    double z = 0;
    for (int k = 0; k < plan.slices; ++k) {
      result.stack.slices.push_back({z, {}});
      z += plan.on_lattice() ? 1.0 : settled(random.between(0.1, 3));
    }
    add_structure(random, plan, "tooth", result.stack);
    if (random.chance(0.1)) add_structure(random, plan, "pulp", result.stack);
    // Scaling by a power of two is exact, but adding a large number rounds, which may create ties.
    if (random.chance(0.1)) {
      result.stack = displaced(random, result.stack);
      result.general_position = false;
    }
    if (random.chance(0.2)) random.shuffle(result.stack.slices);
  } while (!breach(result.stack).empty());
  return result;
}

std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

std::uint64_t random_stacks_of(std::uint64_t usual) {
  return std::min(usual, number_from_environment("ODONTOSCOPE_RANDOM_STACKS", usual));
}

}  // namespace odontoscope::test
