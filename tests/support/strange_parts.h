#pragma once
// What the makers of strange stacks share. A maker draws one stack of about `points` points, which may break the rules
// of contour_stack.h now and then: strange_stack draws again.

#include <vector>

#include "recon/input/contour_stack.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;
using StrangeMaker = ContourStack (*)(RandomNumbers& random, int points);

struct NamedMaker {
  const char* kind;
  StrangeMaker make;
};

/// Mathematics libraries differ in the last bit of a cosine; rounding to a grid far finer than any feature hides that.
double settled(double value);

/// n points on a circle, the first at `angle`, each radius by `radius_at(i)`.
template <class RadiusAt>
Ring ring_around(Point2 centre, int n, double angle, RadiusAt radius_at);
Ring regular(Point2 centre, int n, double angle, double radius);
Ring box_of(Point2 low, Point2 high);
Ring moved(Ring ring, Point2 by);
Ring scaled(Ring ring, double by);
Ring turned(const Ring& ring, double angle);

/// One of the given values.
template <class T, std::size_t n>
T one_of(RandomNumbers& random, const T (&values)[n]) {
  return values[random.below(int(n))];
}

/// 10^-k for a k between the two, whole numbers.
double small(RandomNumbers& random, int largest_k, int smallest_k);
/// The double `steps` units in the last place away.
double steps_from(double value, int steps);

/// Adds the ring unless it breaks a rule or meets one that is there.
bool add_if_it_fits(Rings& rings, const Ring& ring);

/// Slices at random distances from 0.03 to 3, one structure.
ContourStack stacked(RandomNumbers& random, const std::vector<Rings>& slices);

const std::vector<NamedMaker>& outline_makers();
const std::vector<NamedMaker>& number_makers();
const std::vector<NamedMaker>& crowd_makers();
const std::vector<NamedMaker>& label_makers();
const std::vector<NamedMaker>& attack_makers();
const std::vector<NamedMaker>& ploy_makers();
const std::vector<NamedMaker>& trifle_makers();
const std::vector<NamedMaker>& assault_makers();

}  // namespace odontoscope::test

#include <cmath>
#include <numbers>

template <class RadiusAt>
odontoscope::test::Ring odontoscope::test::ring_around(Point2 centre, int n, double angle, RadiusAt radius_at) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double at = angle + 2 * std::numbers::pi * i / n, radius = radius_at(i);
    ring.push_back({settled(centre.x + radius * std::cos(at)), settled(centre.y + radius * std::sin(at))});
  }
  return ring;
}
