#include "tests/support/strange_stacks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "recon/core/limits.h"
#include "tests/support/plane_check.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {

double settled(double value) { return std::round(value * 0x1p46) * 0x1p-46; }

Ring regular(Point2 centre, int n, double angle, double radius) {
  return ring_around(centre, n, angle, [&](int) { return radius; });
}

Ring box_of(Point2 low, Point2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

Ring moved(Ring ring, Point2 by) {
  for (Point2& p : ring) p = {p.x + by.x, p.y + by.y};
  return ring;
}

Ring scaled(Ring ring, double by) {
  for (Point2& p : ring) p = {p.x * by, p.y * by};
  return ring;
}

Ring turned(const Ring& ring, double angle) {
  const double c = settled(std::cos(angle)), s = settled(std::sin(angle));
  Ring result;
  for (Point2 p : ring) result.push_back({settled(c * p.x - s * p.y), settled(s * p.x + c * p.y)});
  return result;
}

double small(RandomNumbers& random, int largest_k, int smallest_k) {
  double value = 1;
  for (int k = random.whole(largest_k, smallest_k); k > 0; --k) value /= 10;
  return value;
}

double steps_from(double value, int steps) {
  for (int i = 0; i < std::min(std::abs(steps), 64); ++i) value = std::nextafter(value, steps > 0 ? 1e300 : -1e300);
  const double unit = std::nextafter(std::abs(value), 1e300) - std::abs(value);
  return std::abs(steps) > 64 ? value + unit * (steps > 0 ? steps - 64 : steps + 64) : value;
}

bool add_if_it_fits(Rings& rings, const Ring& ring) {
  if (!is_simple(ring)) return false;
  for (const Ring& other : rings)
    if (!are_disjoint(ring, other)) return false;
  rings.push_back(ring);
  return true;
}

ContourStack stacked(RandomNumbers& random, const std::vector<Rings>& slices) {
  ContourStack stack;
  double z = settled(random.between(-5, 5));
  for (const Rings& rings : slices) {
    Slice slice{z, {}};
    for (const Ring& ring : rings) slice.contours.push_back({"tooth", ring});
    stack.slices.push_back(slice);
    z += settled(random.chance(0.3) ? random.between(0.03, 0.1) : random.between(0.1, 3));
  }
  return stack;
}

namespace {

/// Rules of contour_stack.h, and the largest coordinate, that docs/formats.md allows.
bool is_valid(const ContourStack& stack) {
  for (const Slice& slice : stack.slices) {
    if (std::abs(slice.z) > limits::largest_coordinate) return false;
    for (const Contour& contour : slice.contours)
      for (Point2 p : contour.points)
        if (std::max(std::abs(p.x), std::abs(p.y)) > limits::largest_coordinate) return false;
  }
  return breach(stack).empty();
}

int points_wanted(RandomNumbers& random, StrangeSize size) {
  if (size == StrangeSize::large) return 2000;
  if (size == StrangeSize::cheap || random.chance(0.4)) return random.whole(12, 60);
  return random.chance(0.6)   ? random.whole(60, 250)
         : random.chance(0.7) ? random.whole(250, 700)
                              : random.whole(700, 2000);
}

using Transform = std::function<Point2(Point2)>;

/// The stack with every point sent elsewhere, if that leaves it valid.
void apply_if_valid(ContourStack& stack, const Transform& transform) {
  ContourStack result = stack;
  for (Slice& slice : result.slices)
    for (Contour& contour : slice.contours)
      for (Point2& p : contour.points) p = transform(p);
  if (is_valid(result)) stack = result;
}

/// Now and then the stack is scaled by a decimal, rounded to some digits as files are, moved a kilometre away, made
/// flat or tall, or a slice is emptied.
void disturb(RandomNumbers& random, ContourStack& stack) {
  if (random.chance(0.1)) {
    const double factor = one_of(random, {0.1, 1e-3, 0.3, 1e-6, 10.0});
    apply_if_valid(stack, [&](Point2 p) { return Point2{p.x * factor, p.y * factor}; });
  }
  if (random.chance(0.2)) {
    const double grain = one_of(random, {10.0, 100.0, 1e3, 1e4, 1e6});
    apply_if_valid(stack, [&](Point2 p) {
      return Point2{std::round(p.x * grain) / grain, std::round(p.y * grain) / grain};
    });
  }
  if (random.chance(0.08)) {
    const Point2 by{one_of(random, {999000.0, -987654.3, 0.0}), one_of(random, {999000.1, -1e5})};
    apply_if_valid(stack, [&](Point2 p) { return Point2{p.x + by.x, p.y + by.y}; });
  }
  if (random.chance(0.15)) {
    ContourStack other = stack;
    const double factor = one_of(random, {1e-3, 0.01, 0.1, 10.0, 1000.0});
    for (Slice& slice : other.slices) slice.z *= factor;
    if (is_valid(other)) stack = other;
  }
  if (random.chance(0.03)) {
    ContourStack other = stack;
    other.slices[std::size_t(random.below(int(other.slices.size())))].contours.clear();
    if (is_valid(other)) stack = other;
  }
}

/// Largest coordinate of a slice's points, 0 if there is none.
double reach_of(const Slice& slice) {
  double reach = 0;
  for (const Contour& contour : slice.contours)
    for (Point2 p : contour.points) reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
  return reach;
}

/// Every slice by another maker, brought to about one size.
ContourStack medley(RandomNumbers& random, int points) {
  ContourStack stack;
  double z = random.between(-5, 5);
  for (int k = 0, count = random.whole(2, 4); k < count; ++k) {
    const auto& makers = *one_of(random, {&outline_makers(), &number_makers(), &crowd_makers()});
    const ContourStack made = makers[std::size_t(random.below(int(makers.size())))].make(random, points / count * 2);
    Slice slice = made.slices.empty() ? Slice{} : made.slices[std::size_t(random.below(int(made.slices.size())))];
    const double factor = random.between(1, 4) / std::max(reach_of(slice), 1e-9);
    for (Contour& contour : slice.contours)
      for (Point2& p : contour.points) p = {settled(p.x * factor), settled(p.y * factor)};
    slice.z = z;
    z += settled(random.between(0.05, 4));
    stack.slices.push_back(slice);
  }
  return stack;
}

const std::vector<NamedMaker>& all_makers() {
  static const std::vector<NamedMaker> all = [] {
    std::vector<NamedMaker> makers;
    for (const auto* some : {&outline_makers(), &number_makers(), &crowd_makers(), &label_makers(), &attack_makers(),
                             &ploy_makers(), &trifle_makers(), &assault_makers()})
      makers.insert(makers.end(), some->begin(), some->end());
    makers.push_back({"medley", medley});
    return makers;
  }();
  return all;
}

std::vector<std::size_t> outer_contours(const Slice& slice, const std::string& structure) {
  std::vector<std::vector<Point2>> rings;
  std::vector<std::size_t> numbers, outer;
  for (std::size_t c = 0; c < slice.contours.size(); ++c)
    if (slice.contours[c].structure == structure) {
      rings.push_back(slice.contours[c].points);
      numbers.push_back(c);
    }
  for (std::size_t r = 0; r < rings.size(); ++r)
    if (depth_of(rings, r) % 2 == 0) outer.push_back(numbers[r]);
  return outer;
}

/// At most `most` of a slab.
std::vector<Link> random_links(RandomNumbers& random, const ContourStack& stack, int most) {
  std::vector<Link> links;
  std::set<std::array<std::size_t, 3>> taken;
  std::set<std::string> structures;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) structures.insert(contour.structure);
  const double forced = random.between(0, 1);
  for (const std::string& structure : structures)
    for (std::size_t k = 0; k + 1 < stack.slices.size(); ++k) {
      const auto lower = outer_contours(stack.slices[k], structure),
                 upper = outer_contours(stack.slices[k + 1], structure);
      if (lower.empty() || upper.empty()) continue;
      for (int i = random.whole(0, most); i > 0; --i) {
        const std::size_t a = lower[std::size_t(random.below(int(lower.size())))],
                          b = upper[std::size_t(random.below(int(upper.size())))];
        if (taken.insert({k, a, b}).second) links.push_back({structure, k, a, b, random.chance(forced)});
      }
    }
  return links;
}

}  // namespace

std::size_t points_of(const ContourStack& stack) {
  std::size_t points = 0;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) points += contour.points.size();
  return points;
}

StrangeStack strange_stack(std::uint64_t seed, StrangeSize size) {
  const NamedMaker& maker = all_makers()[seed % all_makers().size()];
  RandomNumbers random(seed ^ 0x5ca1ab1e00000000u);
  StrangeStack result;
  result.kind = maker.kind;
  double share = 1;  // of what is wanted: makers keep to it roughly
  for (;; ++result.thrown_away) {
    result.stack = maker.make(random, std::max(12, int(share * points_wanted(random, size))));
    const std::size_t points = points_of(result.stack);
    if (size == StrangeSize::large && points > largest_strange_stack)
      share *= 0.9;
    else if (is_valid(result.stack))
      break;
  }
  disturb(random, result.stack);
  const bool knotted = result.kind == "knots";
  if (knotted || random.chance(0.25)) result.links = random_links(random, result.stack, knotted ? 30 : 3);
  return result;
}

const std::vector<std::string>& strange_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const NamedMaker& maker : all_makers()) names.emplace_back(maker.kind);
    return names;
  }();
  return kinds;
}

}  // namespace odontoscope::test
