// Contours of label maps: valid, right about every pixel, the same wall for both of two neighbours, never overlapping.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/label_contours.h"
#include "tests/support/random_numbers.h"
#include "tests/volume/volumes.h"

namespace odontoscope::test {
namespace {

std::string name(int label) { return std::string(1, char('a' + label)); }

std::vector<LabelLevel> all_labels(const Volume& volume) {
  std::vector<LabelLevel> levels;
  for (const float value : std::set<float>(volume.values.begin(), volume.values.end())) {
    levels.push_back({static_cast<std::int64_t>(value), name(int(value))});
  }
  return levels;
}

TEST(LabelContours, AreValidRightAndDisjointForAnyMap) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    RandomNumbers random(seed);
    const Volume volume =
        noise(seed, {std::size_t(random.whole(2, 9)), std::size_t(random.whole(2, 9)), 3}, random.whole(2, 5));
    ContourStack stack;
    try {
      stack = label_contours(volume, all_labels(volume)).stack;
    } catch (const InputError& error) {
      FAIL() << error.what();
    }
    for (const LabelLevel& level : all_labels(volume)) {
      ASSERT_EQ(faults(only(stack, level.structure)), "") << "seed " << seed;
    }
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
      const Slice& slice = stack.slices[k];
      for (std::size_t n = 0; n < volume.pixels_per_slice(); ++n) {
        const Point2 centre{double(n % volume.size[0]), double(n / volume.size[0])};
        for (const LabelLevel& level : all_labels(volume)) {
          ASSERT_EQ(covers(slice, level.structure, centre), volume.slice(k)[n] == static_cast<float>(level.label))
              << "seed " << seed;
        }
      }
      for (int n = 0; n < 200; ++n) {
        const Point2 at{random.between(-1, 9), random.between(-1, 9)};
        int covering = 0;
        for (const LabelLevel& level : all_labels(volume)) covering += covers(slice, level.structure, at) ? 1 : 0;
        ASSERT_LE(covering, 1) << "seed " << seed;
      }
    }
  }
}

TEST(LabelContours, ShareTheWallBetweenTwo) {
  const Volume volume = volume_of_rows({"11222", "11222", "11122", "11122"});
  const ContourStack stack = label_contours(volume, {{1, "a"}, {2, "b"}}).stack;
  const Slice& slice = stack.slices[0];
  ASSERT_EQ(slice.contours.size(), 2u);
  std::vector<Point2> shared;
  for (const Point2 p : slice.contours[0].points) {
    const auto& other = slice.contours[1].points;
    if (std::find(other.begin(), other.end(), p) != other.end()) shared.push_back(p);
  }
  EXPECT_EQ(shared.size(), 7u);  // four rows, the step between, and the wall's ends on the border
  // All but the corners of the image, cut off by 1/8 each.
  EXPECT_DOUBLE_EQ(region_area(slice, "a") + region_area(slice, "b"), 20 - 4.0 / 8);
}

double area_of_all(const ContourStack& stack) {
  std::set<std::string> structures;
  for (const Contour& contour : stack.slices[0].contours) structures.insert(contour.structure);
  double sum = 0;
  for (const std::string& structure : structures) sum += region_area(stack.slices[0], structure);
  return sum;
}

TEST(LabelContours, LeaveNothingWhereThreeOrFourMeet) {
  const std::vector<LabelLevel> four{{1, "a"}, {2, "b"}, {3, "c"}, {4, "d"}};
  const auto of = [&](const std::vector<std::string>& rows, std::size_t labels) {
    return label_contours(volume_of_rows(rows), {four.begin(), four.begin() + static_cast<std::ptrdiff_t>(labels)})
        .stack;
  };
  constexpr double corners = 4.0 / 8;  // of the image
  EXPECT_DOUBLE_EQ(area_of_all(of({"12", "34"}, 4)), 4 - corners);
  EXPECT_DOUBLE_EQ(area_of_all(of({"12", "33"}, 3)), 4 - corners);
  EXPECT_DOUBLE_EQ(area_of_all(of({"13", "23"}, 3)), 4 - corners);
  EXPECT_DOUBLE_EQ(area_of_all(of({"12", "31"}, 3)), 4 - corners);
  EXPECT_DOUBLE_EQ(area_of_all(of({"21", "13"}, 3)), 4 - corners);
  // Of the pair that is cut off each gets its diamond alone; of the other two each half of what is between as well.
  const ContourStack four_meet = of({"12", "34"}, 4);
  for (const char* structure : {"a", "d"})
    EXPECT_DOUBLE_EQ(region_area(four_meet.slices[0], structure), 1 - 1.0 / 8 - 1.0 / 8) << structure;
  for (const char* structure : {"b", "c"})
    EXPECT_DOUBLE_EQ(region_area(four_meet.slices[0], structure), 1 - 1.0 / 8 + 1.0 / 8) << structure;
}

TEST(LabelContours, LeaveASmallVoidWhereTwoTakeTurns) {
  const ContourStack stack = label_contours(volume_of_rows({"12", "21"}), {{1, "a"}, {2, "b"}}).stack;
  EXPECT_DOUBLE_EQ(area_of_all(stack), 4 - 4.0 / 8 - 0.5);
}

TEST(LabelContours, DoNotJoinAcrossACorner) {
  const ContourStack stack = label_contours(volume_of_rows({"0000", "0700", "0070", "0000"}), {{7, "a"}}).stack;
  EXPECT_EQ(stack.slices[0].contours.size(), 2u);
}

TEST(LabelContours, OfALabelThatFillsTheVolumeRunAlongTheBorder) {
  const ContourStack stack = label_contours(volume_of_rows({"111", "111"}), {{1, "a"}}).stack;
  EXPECT_EQ(faults(stack), "");
  EXPECT_DOUBLE_EQ(region_area(stack.slices[0], "a"), 6 - 4.0 / 8);
}

TEST(LabelContours, RefuseALabelThatIsNotThereAndNameSomeThatAre) {
  const Volume volume = volume_of_rows({"011", "022"});
  try {
    label_contours(volume, {{5, "a"}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.cause(), "label-not-found");
    EXPECT_NE(std::string(error.what()).find("0, 1, 2"), std::string::npos) << error.what();
  }
  EXPECT_THROW(label_contours(volume, {{limits::largest_label + 1, "a"}}), UsageError);
}

}  // namespace
}  // namespace odontoscope::test
