#include "tests/partition/partition_stacks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "recon/core/limits.h"
#include "tests/support/plane_check.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

bool is_valid(const ContourStack& stack) {
  for (const Slice& slice : stack.slices) {
    if (std::abs(slice.z) > limits::largest_coordinate) return false;
    for (const Contour& contour : slice.contours)
      for (Point2 p : contour.points)
        if (std::max(std::abs(p.x), std::abs(p.y)) > limits::largest_coordinate) return false;
  }
  return breach(stack).empty();
}

std::vector<std::string> names_in(const ContourStack& stack) {
  std::set<std::string> names;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) names.insert(contour.structure);
  return {names.begin(), names.end()};
}

void keep_if_valid(ContourStack& stack, const std::function<void(ContourStack&)>& change) {
  ContourStack changed = stack;
  change(changed);
  if (is_valid(changed)) stack = changed;
}

void move_points(ContourStack& stack, const std::function<Point2(Point2)>& to) {
  keep_if_valid(stack, [&](ContourStack& changed) {
    for (Slice& slice : changed.slices)
      for (Contour& contour : slice.contours)
        for (Point2& p : contour.points) p = to(p);
  });
}

/// A structure appears in one slice only.
void leave_in_one_slice(RandomNumbers& random, ContourStack& stack) {
  const std::vector<std::string> names = names_in(stack);
  const std::string name = names[std::size_t(random.below(int(names.size())))];
  const std::size_t kept = std::size_t(random.below(int(stack.slices.size())));
  keep_if_valid(stack, [&](ContourStack& changed) {
    for (std::size_t k = 0; k < changed.slices.size(); ++k)
      if (k != kept) std::erase_if(changed.slices[k].contours, [&](const Contour& c) { return c.structure == name; });
  });
}

void set_heights(RandomNumbers& random, ContourStack& stack) {
  keep_if_valid(stack, [&](ContourStack& changed) {
    const double step = random.chance(0.3) ? 1 : random.between(0.5, 2) * small(random, 0, 6);
    double z = one_of(random, {0.0, -3.7, 1000.1, 1e-9});
    for (Slice& slice : changed.slices) {
      slice.z = z;
      z += step;
    }
  });
}

/// A unit in the last place, or a few, between two slices.
void squeeze(RandomNumbers& random, ContourStack& stack) {
  keep_if_valid(stack, [&](ContourStack& changed) {
    double z = one_of(random, {1.0, 0.1, -17.3});
    for (Slice& slice : changed.slices) {
      slice.z = z;
      z = random.chance(0.6) ? steps_from(z, one_of(random, {1, 2, 7, 20, 1000})) : z + 0.5;
    }
  });
}

void disturb(RandomNumbers& random, ContourStack& stack) {
  if (random.chance(0.15)) leave_in_one_slice(random, stack);
  if (random.chance(0.1))
    keep_if_valid(stack,
                  [&](ContourStack& s) { s.slices[std::size_t(random.below(int(s.slices.size())))].contours.clear(); });
  if (random.chance(0.1)) {
    const double grain = one_of(random, {10.0, 100.0, 1000.0, 16.0});
    move_points(stack, [&](Point2 p) {
      return Point2{std::round(p.x * grain) / grain, std::round(p.y * grain) / grain};
    });
  }
  if (random.chance(0.1)) {
    const double angle = random.between(0, 6.28);
    move_points(stack, [&](Point2 p) { return turned({p}, angle).front(); });
  }
  if (random.chance(0.08)) {
    const double factor = one_of(random, {0.1, 0.3, 1e-4, 1e3, 0.07});
    move_points(stack, [&](Point2 p) { return Point2{p.x * factor, p.y * factor}; });
  }
  if (random.chance(0.08)) {
    const double far = one_of(random, {1e3, 9.9e5, -123456.7});
    move_points(stack, [&](Point2 p) { return Point2{p.x + far, p.y - far / 3}; });
  }
  if (random.chance(0.15)) set_heights(random, stack);
  if (random.chance(0.04)) squeeze(random, stack);
}

const std::vector<NamedPartitionMaker>& all_makers() {
  static const std::vector<NamedPartitionMaker> all = [] {
    std::vector<NamedPartitionMaker> makers;
    for (const auto* some : {&shape_makers(), &border_makers(), &mixed_makers()})
      makers.insert(makers.end(), some->begin(), some->end());
    return makers;
  }();
  return all;
}

int points_wanted(RandomNumbers& random, PartitionSize size) {
  if (size == PartitionSize::large) return 2000;
  if (size == PartitionSize::small || random.chance(0.6)) return random.whole(12, 60);
  return random.chance(0.8) ? random.whole(60, 250) : random.whole(250, 800);
}

}  // namespace

std::string structure_name(int number) { return "s" + std::to_string(number); }

bool add_ring(Slice& slice, int structure, const std::vector<Point2>& ring) {
  if (!is_simple(ring)) return false;
  const std::string name = structure_name(structure);
  for (const Contour& other : slice.contours)
    if (other.structure == name && !are_disjoint(ring, other.points)) return false;
  slice.contours.push_back({name, ring});
  return true;
}

ContourStack stack_slices(RandomNumbers& random, std::vector<Slice> slices) {
  double z = settled(random.between(-5, 5));
  for (Slice& slice : slices) {
    slice.z = z;
    z += settled(random.chance(0.3) ? random.between(0.03, 0.1) : random.between(0.1, 3));
  }
  ContourStack stack;
  stack.slices = std::move(slices);
  return stack;
}

PartitionCase partition_case(std::uint64_t seed, PartitionSize size) {
  const NamedPartitionMaker& maker = all_makers()[seed % all_makers().size()];
  RandomNumbers random(seed ^ 0x9a17110000000000u);
  PartitionCase result;
  result.kind = maker.kind;
  do result.stack = maker.make(random, points_wanted(random, size));
  while (result.stack.slices.empty() || !is_valid(result.stack));
  disturb(random, result.stack);
  result.priority = names_in(result.stack);
  random.shuffle(result.priority);
  if (random.chance(0.2)) result.gap = random.chance(0.5) ? random.between(0, 0.3) : small(random, 2, 7);
  result.delaunay =
      random.chance(size == PartitionSize::small ? 0.93 : 0.4);  // interpolated slices cost ten times as much
  return result;
}

const std::vector<std::string>& partition_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const NamedPartitionMaker& maker : all_makers()) names.emplace_back(maker.kind);
    return names;
  }();
  return kinds;
}

}  // namespace odontoscope::test
