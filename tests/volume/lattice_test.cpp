// Contours at decimal spacings lie where whole numbers say, point for point, and hardly beside where the file says.

#include "recon/volume/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/core/limits.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/label_contours.h"
#include "tests/support/random_numbers.h"
#include "tests/volume/volumes.h"

namespace odontoscope::test {
namespace {

constexpr double half_steps = 2147483648.0;  // 2^31 a millimetre

/// A slanted canal through a cone, a few voxels of it wrong: what a segmented tooth looks like.
Volume toothlike(RandomNumbers& random) {
  return volume_of({12, 11, 5}, [&](std::size_t i, std::size_t j, std::size_t k) {
    const double from_axis = std::hypot(double(i) - 5.5 + 0.4 * double(k), double(j) - 5.0);
    const bool dentine = from_axis < 5 - 0.3 * double(k), pulp = from_axis < 1.2 + 0.1 * double(k);
    if (random.chance(0.04)) return 0.0;
    return pulp ? 2.0 : dentine ? 1.0 : 0.0;
  });
}

void give_decimal_place(Volume& volume, RandomNumbers& random) {
  constexpr double spacings[] = {0.2, 0.15, 0.075, 0.1, 0.35};
  for (double& spacing : volume.spacing) spacing = spacings[random.whole(0, 4)];
  volume.origin = {random.whole(-4000, 4000) / 100.0, random.whole(-40000, 40000) / 1000.0,
                   random.whole(-99, 99) / 10.0};
}

struct WholeNumbers {
  long origin[3], spacing[3];
  explicit WholeNumbers(const Volume& volume) {
    const double origins[] = {volume.origin.x, volume.origin.y, volume.origin.z};
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = 2 * std::lround(origins[axis] * half_steps / 2);
      spacing[axis] = std::lround(volume.spacing[axis] * half_steps / 2);
    }
  }
};

TEST(Lattice, OfLabelMapsIsTheScaledLatticeOfWholeNumbersPointForPoint) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomNumbers random(seed);
    Volume volume = seed % 2 == 0 ? noise(seed, {7, 8, 4}, 3) : toothlike(random);
    volume.spacing = {4, 4, 4};  // so that quarters are whole, too
    const ContourStack whole = label_contours(volume, {{1, "a"}, {2, "b"}}).stack;
    give_decimal_place(volume, random);
    const ContourStack scaled = label_contours(volume, {{1, "a"}, {2, "b"}}).stack;
    const WholeNumbers lattice(volume);
    ASSERT_EQ(whole.slices.size(), scaled.slices.size());
    for (std::size_t s = 0; s < whole.slices.size(); ++s) {
      const Slice &expected = whole.slices[s], &slice = scaled.slices[s];
      ASSERT_EQ(slice.z * half_steps, double(lattice.origin[2]) + expected.z / 2 * double(lattice.spacing[2]));
      ASSERT_EQ(expected.contours.size(), slice.contours.size());
      for (std::size_t c = 0; c < slice.contours.size(); ++c) {
        ASSERT_EQ(expected.contours[c].points.size(), slice.contours[c].points.size());
        for (std::size_t p = 0; p < slice.contours[c].points.size(); ++p) {
          const Point2 at = slice.contours[c].points[p], number = expected.contours[c].points[p];
          ASSERT_EQ(at.x * half_steps, double(lattice.origin[0]) + number.x / 2 * double(lattice.spacing[0]))
              << "seed " << seed;
          ASSERT_EQ(at.y * half_steps, double(lattice.origin[1]) + number.y / 2 * double(lattice.spacing[1]))
              << "seed " << seed;
        }
      }
    }
  }
}

TEST(Lattice, HoldsIsoContoursWithinHalfAStepOfTheInterpolatedPlaceAndBetweenTheirPixels) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomNumbers random(seed);
    Volume volume = volume_of({7, 7, 2}, [&](std::size_t, std::size_t, std::size_t) { return random.between(0, 9); });
    const ContourStack whole = iso_contours(volume, {{4.5, "a"}}).stack;
    give_decimal_place(volume, random);
    const ContourStack placed = iso_contours(volume, {{4.5, "a"}}).stack;
    const double far = Lattice(volume).largest_shift() + 1 / half_steps;
    for (std::size_t s = 0; s < whole.slices.size(); ++s) {
      for (std::size_t c = 0; c < whole.slices[s].contours.size(); ++c) {
        for (std::size_t p = 0; p < whole.slices[s].contours[c].points.size(); ++p) {
          const Point2 at = placed.slices[s].contours[c].points[p], number = whole.slices[s].contours[c].points[p];
          ASSERT_EQ(std::fmod(at.x * half_steps, 1), 0);
          ASSERT_EQ(std::fmod(at.y * half_steps, 1), 0);
          ASSERT_NEAR(at.x, volume.origin.x + number.x * volume.spacing[0], far) << "seed " << seed;
          ASSERT_NEAR(at.y, volume.origin.y + number.y * volume.spacing[1], far) << "seed " << seed;
        }
      }
    }
    ASSERT_EQ(faults(placed), "");
  }
}

TEST(Lattice, LeavesDyadicSpacingsAlone) {
  Volume volume = noise(1, {5, 6, 7}, 2);
  volume.spacing = {0.25, 0.125, 0.5};
  volume.origin = {-17.75, 3, 1000.5};
  const Lattice lattice(volume);
  EXPECT_EQ(lattice.largest_shift(), 0);
  EXPECT_EQ(lattice.x(3), -17);
  EXPECT_EQ(lattice.z(6), 1003.5);
}

TEST(Lattice, SaysHowFarVoxelsMoveAndKeepsWithinHalfAStepEach) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomNumbers random(seed);
    Volume volume;
    volume.size = {std::size_t(random.whole(1, 2000)), 2, 2};
    const double spacing = std::pow(10, random.between(-6, 2));
    volume.spacing = {spacing, 1, 1};
    volume.origin = {random.between(-100, 100), 0, 0};
    const Lattice lattice(volume);
    double largest = 0;
    for (const std::size_t i : {std::size_t{0}, volume.size[0] - 1}) {
      largest = std::max(largest, std::abs(lattice.x(std::ptrdiff_t(i)) - (volume.origin.x + double(i) * spacing)));
    }
    constexpr double rounding = 1e-10;  // of the test's own sum, in coordinates up to 2e5
    EXPECT_NEAR(lattice.largest_shift(), largest, rounding) << "seed " << seed;
    EXPECT_LE(largest, double(volume.size[0] + 1) * lattice.step() / 2 + rounding);
    EXPECT_LE(lattice.step(), limits::lattice_step);
    EXPECT_LT(lattice.step(), spacing / 100'000);
    EXPECT_LT(lattice.x(0), lattice.x_between(0, 1e-9));
    EXPECT_LT(lattice.x_between(0, 1 - 1e-9), lattice.x(1));
  }
}

}  // namespace
}  // namespace odontoscope::test
