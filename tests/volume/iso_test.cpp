// Iso-contours: valid for any volume, right about every pixel, exact where the answer is known.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/iso_contours.h"
#include "tests/support/plane_check.h"
#include "tests/support/random_numbers.h"
#include "tests/volume/volumes.h"

namespace odontoscope::test {
namespace {

TracedContours traced(const Volume& volume, double threshold, double min_area = 0) {
  return iso_contours(volume, {{threshold, "tooth"}}, {min_area});
}

std::string cause_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.cause();
  } catch (const UsageError&) {
    return "usage";
  }
  return "none";
}

/// Every pixel's centre is covered just where its value is at least the threshold.
void expect_right_at_pixels(const Volume& volume, const ContourStack& stack, double threshold) {
  for (std::size_t k = 0; k < volume.size[2]; ++k) {
    const Slice* slice = slice_at(stack, volume.origin.z + static_cast<double>(k) * volume.spacing[2]);
    for (std::size_t n = 0; n < volume.pixels_per_slice(); ++n) {
      const Point2 centre{volume.origin.x + static_cast<double>(n % volume.size[0]) * volume.spacing[0],
                          volume.origin.y + static_cast<double>(n / volume.size[0]) * volume.spacing[1]};
      ASSERT_EQ(slice != nullptr && covers(*slice, "tooth", centre), volume.slice(k)[n] >= threshold)
          << "slice " << k << " pixel " << n;
    }
  }
}

void expect_orientation_tells_depth(const ContourStack& stack) {
  for (const Slice& slice : stack.slices) {
    std::vector<std::vector<Point2>> rings;
    for (const Contour& contour : slice.contours) rings.push_back(contour.points);
    for (std::size_t n = 0; n < rings.size(); ++n) {
      ASSERT_EQ(area_sign(rings[n]) > 0, depth_of(rings, n) % 2 == 0) << "contour " << n << " at z " << slice.z;
    }
  }
}

TEST(IsoContours, AreValidAndRightForAnyImageOfFewGreyLevels) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    RandomNumbers random(seed);
    const int levels = random.whole(2, 5);
    const Volume volume = noise(seed, {std::size_t(random.whole(1, 9)), std::size_t(random.whole(1, 9)), 3}, levels);
    const double threshold = random.chance(0.7) ? random.whole(1, levels - 1) : random.between(0.01, levels - 1.01);
    TracedContours contours;
    try {
      contours = traced(volume, threshold);
    } catch (const InputError& error) {
      ASSERT_TRUE(error.cause() == "nothing-crosses-iso" || error.cause() == "single-slice") << error.what();
      continue;
    }
    ASSERT_EQ(faults(contours.stack), "") << "seed " << seed;
    expect_right_at_pixels(volume, contours.stack, threshold);
    expect_orientation_tells_depth(contours.stack);
  }
}

TEST(IsoContours, AreValidOnFloatingPointNoiseFarFromTheOriginAndOnTinyVoxels) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomNumbers random(seed);
    Volume volume = volume_of({8, 7, 2}, [&](std::size_t, std::size_t, std::size_t) { return random.between(-1, 1); });
    volume.spacing = {limits::smallest_spacing, limits::smallest_spacing * 3, 1};
    volume.origin = {9e5, -9e5, 12};
    ASSERT_EQ(faults(traced(volume, 0.01).stack), "") << "seed " << seed;
  }
}

TEST(IsoContours, OfACheckerboardWithEqualDiagonalsJoinWhatIsInside) {
  const Volume volume =
      volume_of({6, 6, 2}, [](std::size_t i, std::size_t j, std::size_t) { return (i + j) % 2 == 0 ? 1 : 0; });
  // At the middle value the saddles are just at the threshold, which counts as inside: one region, and a hole round
  // every inner 0.
  const ContourStack joined = traced(volume, 0.5).stack;
  EXPECT_EQ(faults(joined), "");
  EXPECT_EQ(joined.slices[0].contours.size(), 1u + 8u);
  // Just above it every 1 stands alone.
  const ContourStack apart = traced(volume, 0.51).stack;
  EXPECT_EQ(faults(apart), "");
  EXPECT_EQ(apart.slices[0].contours.size(), 18u);
}

TEST(IsoContours, PassAPixelEqualToTheThresholdAtTheMargin) {
  const ContourStack stack = traced(volume_of_rows({"000", "050", "000"}), 5).stack;
  const double m = limits::grid_vertex_margin;
  ASSERT_EQ(stack.slices[0].contours.size(), 1u);
  const std::vector<Point2> expected{{1 + m, 1}, {1, 1 + m}, {1 - m, 1}, {1, 1 - m}};
  EXPECT_EQ(stack.slices[0].contours[0].points, expected);
}

TEST(IsoContours, CrossAnEdgeWhereInterpolationMeetsTheThreshold) {
  Volume volume = volume_of({5, 4, 2}, [](std::size_t i, std::size_t, std::size_t) { return 10.0 * double(i); });
  volume.spacing = {0.5, 2, 3};
  volume.origin = {100, 200, 300};
  const ContourStack stack = traced(volume, 23).stack;
  EXPECT_EQ(stack.slices[0].z, 300);
  EXPECT_EQ(stack.slices[1].z, 303);
  ASSERT_EQ(stack.slices[0].contours.size(), 1u);
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  for (const Point2 p : stack.slices[0].contours[0].points) {
    left = std::min(left, p.x), right = std::max(right, p.x), bottom = std::min(bottom, p.y), top = std::max(top, p.y);
  }
  EXPECT_NEAR(left, 100 + 2.3 * 0.5, limits::lattice_step / 4);  // the nearest point of the lattice
  // The image ends half a pixel outside its outermost centres.
  EXPECT_DOUBLE_EQ(right, 100 + 4.5 * 0.5);
  EXPECT_DOUBLE_EQ(bottom, 200 - 0.5 * 2);
  EXPECT_DOUBLE_EQ(top, 200 + 3.5 * 2);
}

TEST(IsoContours, FollowARoundThing) {
  constexpr double radius = 12.3, cx = 20.2, cy = 19.7;
  const Volume volume = volume_of({40, 40, 2}, [](std::size_t i, std::size_t j, std::size_t) {
    return radius - std::hypot(double(i) - cx, double(j) - cy);
  });
  const ContourStack stack = traced(volume, 0).stack;
  ASSERT_EQ(stack.slices[0].contours.size(), 1u);
  // Linear interpolation along an edge of length 1 across a circle errs by less than 1/8r; beside it only the margin
  // moves a point.
  for (const Point2 p : stack.slices[0].contours[0].points) {
    EXPECT_NEAR(std::hypot(p.x - cx, p.y - cy), radius, 1 / (8 * radius) + limits::grid_vertex_margin);
  }
}

TEST(IsoContours, TellASaddleAboveTheThresholdFromOneBelow) {
  // (a b - c d) / (a + b - c - d) of the middle cell: 9 * 9 / 18 = 4.5.
  const Volume volume = volume_of_rows({"0000", "0900", "0090", "0000"});
  EXPECT_EQ(traced(volume, 4.4).stack.slices[0].contours.size(), 1u);
  EXPECT_EQ(traced(volume, 4.6).stack.slices[0].contours.size(), 2u);
}

TEST(IsoContours, OfAHigherThresholdLieWithinThoseOfALower) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomNumbers random(seed);
    const Volume volume = noise(seed, {9, 9, 2}, 7);
    const ContourStack stack = iso_contours(volume, {{2, "low"}, {4.5, "high"}}).stack;
    for (const Slice& slice : stack.slices) {
      for (int n = 0; n < 300; ++n) {
        const Point2 at{random.between(-1, 9), random.between(-1, 9)};
        ASSERT_TRUE(!covers(slice, "high", at) || covers(slice, "low", at)) << "seed " << seed;
      }
    }
  }
}

TEST(IsoContours, DoNotDependOnHowTheImageLies) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Volume volume = noise(seed, {7, 7, 2}, 6);
    const auto turned = [&](const std::function<std::size_t(std::size_t, std::size_t)>& from) {
      return traced(volume_of({7, 7, 2},
                              [&](std::size_t i, std::size_t j, std::size_t k) { return volume.slice(k)[from(i, j)]; }),
                    3);
    };
    const TracedContours original = traced(volume, 3);
    const TracedContours mirrored = turned([](std::size_t i, std::size_t j) { return 7 * j + (6 - i); });
    const TracedContours rotated = turned([](std::size_t i, std::size_t j) { return 7 * i + (6 - j); });
    for (const TracedContours* other : {&mirrored, &rotated}) {
      ASSERT_EQ(other->levels[0].contours, original.levels[0].contours) << "seed " << seed;
      ASSERT_EQ(other->levels[0].points, original.levels[0].points) << "seed " << seed;
      for (std::size_t s = 0; s < original.stack.slices.size(); ++s) {
        ASSERT_NEAR(region_area(other->stack.slices[s], "tooth"), region_area(original.stack.slices[s], "tooth"), 1e-9);
      }
    }
  }
}

TEST(IsoContours, DoNotDependOnTheNumberOfThreads) {
  const Volume volume = noise(7, {40, 40, 60}, 9);
  const auto points_with = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<Point2> points;
    const ContourStack stack = traced(volume, 5).stack;
    for (const Slice& slice : stack.slices) {
      for (const Contour& contour : slice.contours)
        points.insert(points.end(), contour.points.begin(), contour.points.end());
    }
    return points;
  };
  EXPECT_EQ(points_with(1), points_with(4));
}

TEST(IsoContours, BelowTheSmallestAreaGoWithAllThatIsInThem) {
  // A block of 5 x 5 with a hole of 3 x 3 and an island of 1; a block of 2 x 2 with nothing in it.
  const Volume volume = volume_of_rows(
      {"0000000000", "0999990000", "0900090990", "0909090990", "0900090000", "0999990000", "0000000000"});
  const auto contours = [&](double min_area) { return traced(volume, 5, min_area); };
  EXPECT_EQ(contours(0).stack.slices[0].contours.size(), 4u);
  const TracedContours without_island = contours(1.5);
  EXPECT_EQ(without_island.stack.slices[0].contours.size(), 3u);
  EXPECT_EQ(without_island.levels[0].dropped, 2u);  // one in each of two slices
  EXPECT_EQ(contours(5).stack.slices[0].contours.size(), 2u);
  EXPECT_EQ(contours(12).stack.slices[0].contours.size(), 1u);
  EXPECT_EQ(cause_of([&] { contours(40); }), "min-area-drops-all");
}

TEST(IsoContours, KeepEmptySlicesInBetweenAndNoneAtTheEnds) {
  const Volume volume = volume_of({3, 3, 9}, [](std::size_t i, std::size_t j, std::size_t k) {
    return i == 1 && j == 1 && (k == 2 || k == 3 || k == 6) ? 9 : 0;
  });
  const ContourStack stack = traced(volume, 5).stack;
  ASSERT_EQ(stack.slices.size(), 5u);
  EXPECT_EQ(stack.slices.front().z, 2);
  EXPECT_TRUE(stack.slices[2].contours.empty());
  EXPECT_TRUE(stack.slices[3].contours.empty());
  EXPECT_EQ(stack.slices.back().z, 6);
}

TEST(IsoContours, RefuseWhatMakesNoSense) {
  const Volume volume = volume_of_rows({"123", "456", "789"});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cause_of([&] { traced(volume, 9.5); }), "nothing-crosses-iso");
  EXPECT_EQ(cause_of([&] { traced(volume, 1); }), "nothing-crosses-iso");  // every voxel is at least 1
  EXPECT_EQ(cause_of([&] { traced(volume, 9); }), "none");
  EXPECT_EQ(cause_of([&] { traced(volume, nan); }), "usage");
  EXPECT_EQ(cause_of([&] { traced(volume, 5, -1); }), "usage");
  EXPECT_EQ(cause_of([&] { traced(volume, 5, nan); }), "usage");
  EXPECT_EQ(cause_of([&] { iso_contours(volume, {}); }), "usage");
  EXPECT_EQ(cause_of([&] { iso_contours(volume, {{5, "a"}, {6, "a"}}); }), "usage");
  Volume broken = volume;
  broken.values[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(cause_of([&] { traced(broken, 5); }), "not-finite");
  broken = volume;
  broken.values.pop_back();
  EXPECT_EQ(cause_of([&] { traced(broken, 5); }), "wrong-voxel-count");
  broken = volume;
  broken.spacing[1] = 0;
  EXPECT_EQ(cause_of([&] { traced(broken, 5); }), "bad-spacing");
  broken = volume;
  broken.origin.x = 2e6;
  EXPECT_EQ(cause_of([&] { traced(broken, 5); }), "too-large");
  const Volume one_slice = volume_of({3, 3, 3}, [](std::size_t, std::size_t, std::size_t k) { return k == 1 ? 9 : 0; });
  EXPECT_EQ(cause_of([&] { traced(one_slice, 5); }), "single-slice");
}

TEST(IsoContours, SayTheRangeOfAVolumeThatNothingCrosses) {
  try {
    traced(volume_of_rows({"123", "456", "789"}), 12);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("from 1 to 9"), std::string::npos) << error.what();
  }
}

TEST(IsoContours, GiveUpOnTooManyContours) {
  const Volume volume =
      volume_of({220, 220, 2}, [](std::size_t i, std::size_t j, std::size_t) { return i % 2 + j % 2 == 2 ? 9 : 0; });
  EXPECT_EQ(cause_of([&] { traced(volume, 5); }), "too-many-contours");
}

TEST(IsoContours, StopWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(iso_contours(noise(1, {9, 9, 9}, 4), {{2}}, {}, {{}, source.get_token()}), Cancelled);
}

}  // namespace
}  // namespace odontoscope::test
