// Otsu's thresholds part what is apart, and a label map is told from an image.

#include "recon/volume/thresholds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_numbers.h"
#include "tests/volume/volumes.h"

namespace odontoscope::test {
namespace {

/// Values round each of the centres, spread by up to `spread`, as many voxels each.
Volume classes_round(const std::vector<double>& centres, double spread, double scale = 1) {
  RandomNumbers random(7);
  return volume_of({20, 20, 10}, [&](std::size_t i, std::size_t, std::size_t) {
    const double centre = centres[i * centres.size() / 20];
    return scale * (centre + std::round(spread * (random.whole(-100, 100) / 100.0)));
  });
}

std::vector<double> thresholds_of(const Volume& volume, std::size_t classes) {
  return otsu_thresholds(histogram_of(volume, validate_volume(volume)), classes);
}

TEST(Thresholds, PartClassesThatAreApart) {
  for (const double scale : {1.0, 0.001, 40.0}) {
    for (const std::vector<double>& centres :
         std::vector<std::vector<double>>{{20, 80}, {20, 80, 160}, {18, 77, 163, 234}, {0, 60, 120, 180, 240}}) {
      const std::vector<double> found = thresholds_of(classes_round(centres, 10, scale), centres.size());
      ASSERT_EQ(found.size(), centres.size() - 1);
      for (std::size_t n = 0; n < found.size(); ++n) {
        EXPECT_GT(found[n], scale * (centres[n] + 10)) << scale;
        EXPECT_LE(found[n], scale * (centres[n + 1] - 10)) << scale;
      }
    }
  }
}

/// All pairs of thresholds of a small histogram, tried one by one.
TEST(Thresholds, AreTheBestOfAll) {
  RandomNumbers random(3);
  const Volume volume = volume_of(
      {30, 30, 4}, [&](std::size_t, std::size_t, std::size_t) { return random.whole(0, 12) * random.whole(0, 3); });
  const auto between = [&](double a, double b) {
    double best = 0;
    for (const auto& [low, high] : {std::pair{-1e9, a}, {a, b}, {b, 1e9}}) {
      double n = 0, sum = 0;
      for (const float v : volume.values)
        if (v >= low && v < high) n += 1, sum += v;
      best += n > 0 ? sum * sum / n : 0;
    }
    return best;
  };
  double best = 0;
  for (int a = 1; a < 36; ++a)
    for (int b = a + 1; b <= 36; ++b) best = std::max(best, between(a, b));
  const std::vector<double> found = thresholds_of(volume, 3);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(between(found[0], found[1]), best, 1e-9 * best);
}

TEST(Thresholds, AreNotMovedByMetal) {
  Volume volume = classes_round({0, 1000}, 100);
  volume.values[5] = 30000;
  const std::vector<double> found = thresholds_of(volume, 2);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0], 100);
  EXPECT_LT(found[0], 900);
}

TEST(Thresholds, AreFewerWhereThereAreFewerValues) {
  EXPECT_EQ(thresholds_of(volume_of({3, 3, 3}, [](std::size_t i, std::size_t, std::size_t) { return i; }), 5).size(),
            2u);
  EXPECT_TRUE(thresholds_of(volume_of({3, 3, 3}, [](std::size_t, std::size_t, std::size_t) { return 7; }), 2).empty());
}

TEST(LabelMap, IsToldFromAnImage) {
  EXPECT_TRUE(looks_like_labels(noise(1, {9, 9, 9}, 4)));
  EXPECT_TRUE(
      looks_like_labels(volume_of({4, 4, 4}, [](std::size_t i, std::size_t, std::size_t) { return i < 2 ? 0 : 255; })));
  EXPECT_FALSE(looks_like_labels(noise(1, {20, 20, 20}, 200)));
  EXPECT_FALSE(
      looks_like_labels(volume_of({4, 4, 4}, [](std::size_t i, std::size_t, std::size_t) { return double(i) - 1; })));
  EXPECT_FALSE(
      looks_like_labels(volume_of({4, 4, 4}, [](std::size_t i, std::size_t, std::size_t) { return double(i) / 2; })));
}

TEST(HistogramLines, AreAsManyAsAskedForAndBearTheMarks) {
  const Volume volume = classes_round({20, 80}, 10);
  const std::vector<std::string> lines = histogram_lines(histogram_of(volume, validate_volume(volume)), {50}, 16);
  EXPECT_LE(lines.size(), 16u);
  EXPECT_EQ(
      std::count_if(lines.begin(), lines.end(), [](const std::string& line) { return line.find("< 50") != line.npos; }),
      1);
}

}  // namespace
}  // namespace odontoscope::test
