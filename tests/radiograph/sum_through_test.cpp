// Sums through voxels, against fields whose integrals are known and against plain sampling.
#include "recon/radiograph/sum_through.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <functional>

#include "tests/radiograph/solids.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

Volume volume_of(std::array<std::size_t, 3> size,
                 const std::function<double(std::size_t, std::size_t, std::size_t)>& value) {
  Volume volume;
  volume.size = size;
  volume.spacing = {0.5, 0.7, 1.1};
  volume.origin = {-1.2, 0.3, 2};
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) volume.values.push_back(static_cast<float>(value(i, j, k)));
  return volume;
}

Point3 middle_of(const Volume& volume) {
  const auto at = [&](double origin, std::size_t axis) {
    return origin + 0.5 * static_cast<double>(volume.size[axis] - 1) * volume.spacing[axis];
  };
  return {at(volume.origin.x, 0), at(volume.origin.y, 1), at(volume.origin.z, 2)};
}

FilmRay random_ray(const Volume& volume, RandomNumbers& random) {
  const Point3 middle = middle_of(volume);
  const auto near = [&](double place) { return place + random.between(-2, 2); };
  const Point3 way{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  const double length = std::sqrt(dot(way, way));
  const Point3 direction{way.x / length, way.y / length, way.z / length},
      through{near(middle.x), near(middle.y), near(middle.z)};
  return {{through.x + 20 * direction.x, through.y + 20 * direction.y, through.z + 20 * direction.z}, direction, 100};
}

/// The value at a place, from the definition; nothing beyond the outermost voxels.
double value_at(const Volume& volume, Point3 place, double zero) {
  const double in[3] = {(place.x - volume.origin.x) / volume.spacing[0],
                        (place.y - volume.origin.y) / volume.spacing[1],
                        (place.z - volume.origin.z) / volume.spacing[2]};
  double value = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (in[axis] < -0.5 || in[axis] > static_cast<double>(volume.size[static_cast<std::size_t>(axis)]) - 0.5) return 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t index[3];
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double last = static_cast<double>(volume.size[axis] - 1), inside = std::clamp(in[axis], 0.0, last),
                   low = std::floor(inside);
      const bool upper = corner >> axis & 1u;
      weight *= upper ? inside - low : 1 - (inside - low);
      index[axis] = static_cast<std::size_t>(std::min(low + (upper ? 1 : 0), last));
    }
    value +=
        weight * static_cast<double>(volume.values[(index[2] * volume.size[1] + index[1]) * volume.size[0] + index[0]]);
  }
  return value - zero;
}

double sampled(const Volume& volume, const FilmRay& ray, double zero, int samples = 200'000) {
  double sum = 0;
  const double from = 0, to = 40;
  for (int i = 0; i < samples; ++i) {
    const double back = from + (to - from) * (i + 0.5) / samples;
    sum += value_at(
        volume,
        {ray.end.x - back * ray.direction.x, ray.end.y - back * ray.direction.y, ray.end.z - back * ray.direction.z},
        zero);
  }
  return sum * (to - from) / samples;
}

TEST(SumThrough, OfNoiseIsThatOfFineSampling) {
  RandomNumbers random(7);
  const Volume volume = volume_of({6, 5, 4}, [&](auto...) { return random.between(-100, 300); });
  double largest = 0;
  for (int i = 0; i < 30; ++i) {
    const FilmRay ray = random_ray(volume, random);
    const double sum = sum_along(volume, 20, ray);
    largest = std::max(largest, std::abs(sum));
    EXPECT_NEAR(sum, sampled(volume, ray, 20), 0.1)
        << i;  // sampling misses the two ends by a step of 0.0002 mm times 300
  }
  EXPECT_GT(largest, 100);
}

// The value is a product x * y * z of places: a polynomial of third degree along any ray, the highest that a cell can
// hold.
TEST(SumThrough, OfAPolynomialIsExact) {
  const Volume volume =
      volume_of({5, 6, 7}, [](std::size_t i, std::size_t j, std::size_t k) { return static_cast<double>(i * j * k); });
  FilmRay ray{{-1.2 + 0.5 * 4, 0.3 + 0.7 * 5, 2 + 1.1 * 6}, {}, 0};  // the far corner, from the near one
  const Point3 way{2, 3.5, 6.6};
  const double length = std::sqrt(dot(way, way));
  ray.direction = {way.x / length, way.y / length, way.z / length};
  ray.length = length;
  // i = 4 s, j = 5 s, k = 6 s; and half a voxel beyond the corner, where the value stays 120, up to the first side that
  // is met: the film lies at s = 1, the volume ends at i = 4.5.
  EXPECT_NEAR(sum_along(volume, 0, ray), length * 120.0 / 4 + 120 * length * 0.5 / 6, 1e-4 * 120 * length);
}

TEST(SumThrough, OfOneValueIsTheLengthOfTheWayTimesIt) {
  const Volume volume = volume_of({4, 4, 4}, [](auto...) { return 7; });
  const Point3 middle = middle_of(volume);
  const FilmRay along_x{{90, middle.y, middle.z}, {1, 0, 0}, 1000},
      along_z{{middle.x, middle.y, -90}, {0, 0, -1}, 1000};
  EXPECT_NEAR(sum_along(volume, 5, along_x), 2 * 4 * 0.5, 1e-12);
  EXPECT_NEAR(sum_along(volume, 5, along_z), 2 * 4 * 1.1, 1e-12);
}

TEST(SumThrough, BeginsAtTheFocus) {
  const Volume volume = volume_of({4, 4, 4}, [](auto...) { return 1; });
  const Point3 middle = middle_of(volume);
  EXPECT_NEAR(sum_along(volume, 0, {{90, middle.y, middle.z}, {1, 0, 0}, 90 - middle.x}), 1,
              1e-12);  // from the middle on
}

TEST(SumThrough, OfAVolumeOneVoxelThickCountsItWhole) {
  const Volume volume =
      volume_of({3, 1, 3}, [](std::size_t i, std::size_t, std::size_t) { return static_cast<double>(i); });
  const Point3 middle = middle_of(volume);
  EXPECT_NEAR(sum_along(volume, 0, {{middle.x, 50, middle.z}, {0, 1, 0}, 100}), 0.7, 1e-12);
}

TEST(SumThrough, IsNothingBesideTheVolume) {
  const Volume volume = volume_of({3, 3, 3}, [](auto...) { return 5; });
  const Point3 middle = middle_of(volume);
  EXPECT_EQ(sum_along(volume, 0, {{middle.x + 10, 50, middle.z}, {0, 1, 0}, 100}), 0);
  EXPECT_EQ(sum_along(volume, 0, {{50, middle.y + 10, middle.z}, {0.8, 0, 0.6}, 100}), 0);
}

TEST(SumThrough, IsTheSameOnOneThread) {
  RandomNumbers random(3);
  const Volume volume = volume_of({9, 8, 7}, [&](auto...) { return random.unit(); });
  FilmView view = with_focus(film_behind(20, 50, 40, 0.3), {0, -20, 4});
  const FilmMap many = sum_through(volume, 0, view);
  EXPECT_GT(*std::max_element(many.values.begin(), many.values.end()), 1);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(sum_through(volume, 0, view).values, many.values);
}

}  // namespace
}  // namespace odontoscope::test
