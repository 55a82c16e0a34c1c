#include "tests/support/variants.h"

#include <algorithm>

#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

ContourStack mapped(ContourStack stack, auto point, auto height) {
  for (Slice& slice : stack.slices) {
    slice.z = height(slice.z);
    for (Contour& contour : slice.contours)
      for (Point2& p : contour.points) p = point(p);
  }
  return stack;
}

constexpr auto same_height = [](double z) { return z; };

}  // namespace

ContourStack rotated(ContourStack stack) {
  return mapped(
      std::move(stack),
      [](Point2 p) {
        return Point2{-p.y, p.x};
      },
      same_height);
}

ContourStack mirrored(ContourStack stack) {
  return mapped(
      std::move(stack),
      [](Point2 p) {
        return Point2{-p.x, p.y};
      },
      same_height);
}

ContourStack reversed(ContourStack stack) {
  return mapped(
      std::move(stack), [](Point2 p) { return p; }, [](double z) { return -z; });
}

ContourStack permuted(ContourStack stack, std::uint64_t seed) {
  RandomNumbers random(seed);
  random.shuffle(stack.slices);
  for (Slice& slice : stack.slices) {
    random.shuffle(slice.contours);
    for (Contour& contour : slice.contours) {
      std::rotate(contour.points.begin(), contour.points.begin() + random.below(int(contour.points.size())),
                  contour.points.end());
      if (random.chance(0.5)) std::reverse(contour.points.begin(), contour.points.end());
    }
  }
  return stack;
}

ContourStack doubled(ContourStack stack) {
  return mapped(
      std::move(stack),
      [](Point2 p) {
        return Point2{2 * p.x, 2 * p.y};
      },
      [](double z) { return 2 * z; });
}

std::vector<Variant> variants_of(const ContourStack& stack, std::uint64_t seed) {
  return {{"rotated by 90 degrees", rotated(stack), false},
          {"mirrored", mirrored(stack), false},
          {"z reversed", reversed(stack), false},
          {"permuted", permuted(stack, seed), true},
          {"doubled", doubled(stack), true}};
}

}  // namespace odontoscope::test
