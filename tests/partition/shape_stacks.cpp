// Blobs, shells and crossings of several structures.

#include <algorithm>
#include <cmath>

#include "tests/partition/partition_stacks.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

Ring blob(RandomNumbers& random, int points, Point2 centre, double radius) {
  const double rough = random.between(0, 0.5);
  return ring_around(centre, std::max(3, points), random.between(0, 6.28),
                     [&](int) { return radius * (1 - rough * random.unit()); });
}

Point2 somewhere(RandomNumbers& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach)};
}

/// Each within the one before; whole or with the hole for the next cut out of it, its border shared.
ContourStack nested(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), labels = random.whole(2, 5), each = std::max(3, points / count / labels);
  const double drift = random.between(0, 0.8);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices) {
    const Point2 centre = somewhere(random, drift);
    for (int label = 1; label <= labels; ++label) {
      const double radius = 0.6 * label, angle = random.between(0, 1);
      const Ring ring = regular(centre, each, angle, radius);
      add_ring(slice, label, ring);
      if (label < labels && random.chance(0.5)) add_ring(slice, label + 1, ring);
    }
  }
  return stack_slices(random, slices);
}

/// Anything anywhere.
ContourStack crossing(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), labels = random.whole(2, 5), rings = std::max(labels, points / count / 6);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices)
    for (int r = 0; r < rings; ++r) {
      const double radius = random.between(0.3, 2);
      add_ring(slice, r % labels + 1, blob(random, random.whole(3, 9), somewhere(random, 2), radius));
    }
  return stack_slices(random, slices);
}

/// Combs of thin teeth, crosswise.
ContourStack combs(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), teeth = std::clamp(points / count / 10, 1, 20);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices) {
    const Point2 by = random.chance(0.5) ? Point2{} : somewhere(random, 0.3);
    for (int label = 1; label <= 2; ++label) {
      Ring comb{{-1, -0.5}, {double(teeth), -0.5}};
      const double width = random.between(0.05, 0.9);
      for (int i = teeth - 1; i >= 0; --i)
        for (Point2 p : {Point2{i + width / 2, 0.0}, Point2{i + width / 2, double(teeth)},
                         Point2{i - width / 2, double(teeth)}, Point2{i - width / 2, 0.0}})
          comb.push_back(p);
      comb.push_back({-1, 0});
      if (label == 2)
        for (Point2& p : comb) p = {p.y, p.x};
      add_ring(slice, label, moved(comb, by));
    }
    if (random.chance(0.3)) add_ring(slice, 3, blob(random, 6, {teeth / 2.0, teeth / 2.0}, teeth / 2.0));
  }
  return stack_slices(random, slices);
}

/// Enamel over dentine: a shell that drifts by more than its thickness.
ContourStack drifting_shell(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), each = std::max(4, points / count / 3);
  const double thin = random.chance(0.5) ? random.between(0.05, 0.3) : small(random, 2, 6);
  const double turn_by = random.chance(0.5) ? 0 : random.between(0, 1);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  const Point2 step{thin * random.between(-4, 4), thin * random.between(-4, 4)};
  for (int k = 0; k < count; ++k) {
    Slice& slice = slices[std::size_t(k)];
    const Point2 centre{k * step.x, k * step.y};
    const Ring inner = regular(centre, each, turn_by * k, 2), outer = regular(centre, each, turn_by * k, 2 + thin);
    add_ring(slice, 1, outer);
    if (random.chance(0.5)) add_ring(slice, 1, inner);
    add_ring(slice, 2, inner);
    if (random.chance(0.5)) add_ring(slice, 3, regular(centre, std::max(3, each / 2), 0, random.between(0.1, 1)));
    if (random.chance(0.2)) slice.contours.erase(slice.contours.begin());
  }
  return stack_slices(random, slices);
}

/// Long thin triangles and bars of all structures through each other.
ContourStack slivers(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), rings = std::max(2, points / count / 4), labels = random.whole(2, 5);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices)
    for (int r = 0; r < rings; ++r) {
      const double thin = small(random, 1, 9), x = random.between(-1, 1);
      const Ring sliver =
          random.chance(0.5) ? Ring{{-3, x}, {3, x + thin}, {-3, x + 2 * thin}} : box_of({-3, x}, {3, x + thin});
      add_ring(slice, r % labels + 1, random.chance(0.5) ? turned(sliver, random.between(0, 6.28)) : sliver);
    }
  return stack_slices(random, slices);
}

/// One structure's contours given to another, too; and one covered wholly.
ContourStack identical(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), each = std::max(3, points / count / 4);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices) {
    const Ring ring = blob(random, each, somewhere(random, 0.5), 2);
    add_ring(slice, 1, ring);
    if (random.chance(0.8)) add_ring(slice, 2, random.chance(0.7) ? ring : scaled(ring, random.between(0.5, 1.5)));
    if (random.chance(0.5)) add_ring(slice, 3, scaled(ring, 0.5));
    if (random.chance(0.3)) add_ring(slice, 2, scaled(ring, 0.3));
  }
  return stack_slices(random, slices);
}

/// A canal that narrows, drifts and leaves through the side or the end.
ContourStack apex(RandomNumbers& random, int points) {
  const int count = random.whole(3, 5), each = std::max(3, points / count / 3);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  const Point2 step = somewhere(random, 0.7);
  for (int k = 0; k < count; ++k) {
    Slice& slice = slices[std::size_t(k)];
    const double root = 2 - 1.8 * k / (count - 1), canal = 0.8 - 0.6 * k / (count - 1);
    if (k + 1 < count || random.chance(0.5)) add_ring(slice, 1, regular({0, 0}, each, 0.1 * k, root));
    add_ring(slice, 2, regular({k * step.x, k * step.y}, std::max(3, each), 0, canal));
    if (random.chance(0.4)) add_ring(slice, 3, regular({0, 0}, each, 0, root + 0.3));
  }
  return stack_slices(random, slices);
}

/// Stars and arms, turned from slice to slice.
ContourStack stars(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), labels = random.whole(2, 4), spikes = std::max(2, points / count / labels / 2);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices)
    for (int label = 1; label <= labels; ++label) {
      const double tip = random.between(1, 3), notch = tip * random.between(0.02, 0.9);
      const Point2 centre = random.chance(0.6) ? Point2{} : somewhere(random, 1);
      add_ring(slice, label,
               ring_around(centre, 2 * spikes, random.between(0, 3), [&](int i) { return i % 2 ? tip : notch; }));
    }
  return stack_slices(random, slices);
}

}  // namespace

const std::vector<NamedPartitionMaker>& shape_makers() {
  static const std::vector<NamedPartitionMaker> makers{
      {"nested", nested},   {"crossing", crossing},   {"combs", combs}, {"drifting-shell", drifting_shell},
      {"slivers", slivers}, {"identical", identical}, {"apex", apex},   {"stars", stars}};
  return makers;
}

}  // namespace odontoscope::test
