// The tree of boxes against asking every box.

#include "recon/mesh/box_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace odontoscope {
namespace {

using Tree = BoxTree<std::array<float, 3>>;
using Place = std::array<double, 3>;

std::vector<Tree::Bounds> scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&](float most) { return most * static_cast<float>(random() % 1024) / 1024; };
  std::vector<Tree::Bounds> boxes(count);
  for (auto& [low, high] : boxes)
    for (int axis = 0; axis < 3; ++axis) high[axis] = (low[axis] = number(10)) + number(axis == 1 ? 0 : 1);
  return boxes;
}

double squared_distance(const Tree::Bounds& box, const Place& place) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double off = std::max({box.low[axis] - place[axis], place[axis] - box.high[axis], 0.0});
    sum += off * off;
  }
  return sum;
}

TEST(BoxTree, FindsTheNearestOfAll) {
  for (const std::size_t count : {1u, 4u, 5u, 9u, 300u}) {
    const std::vector<Tree::Bounds> boxes = scattered(count, 7);
    const Tree tree(boxes);
    std::vector<std::uint32_t> numbers = tree.order();
    std::sort(numbers.begin(), numbers.end());
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(numbers[i], i);
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
      const auto number = [&] { return static_cast<double>(random() % 15) - 2; };
      const Place place = {number(), number(), number()};
      double least = std::numeric_limits<double>::infinity(), found = least;
      for (const auto& box : boxes) least = std::min(least, squared_distance(box, place));
      std::size_t asked = 0;
      tree.nearest_first(place, found, 0, [&](std::uint32_t first, std::uint32_t end) {
        asked += end - first;
        for (; first < end; ++first) found = std::min(found, squared_distance(boxes[tree.order()[first]], place));
      });
      ASSERT_EQ(found, least);
      if (count == 300) {
        ASSERT_LT(asked, 200u);
      }
    }
  }
}

TEST(BoxTree, LooksNoFartherThanAsked) {
  const Tree tree(scattered(100, 1));
  double within = 1;
  tree.nearest_first(Place{100, 100, 100}, within, 0, [](std::uint32_t, std::uint32_t) { FAIL(); });
  double enough = 400;
  int asked = 0;
  tree.nearest_first(Place{5, 5, 5}, enough, 399, [&](std::uint32_t, std::uint32_t) {
    ++asked;
    enough = 399;
  });
  EXPECT_EQ(asked, 1);
}

TEST(BoxTree, ALineAsksAllThatItMayMeetNearestFirst) {
  std::vector<Tree::Bounds> boxes;
  for (float x = 0; x < 64; ++x) boxes.push_back({{x, 0, 0}, {x, 1, 1}});
  const Tree tree(boxes);
  const auto right_half = [](const auto&, const auto& high) { return high[0] >= 32; };
  for (const double way : {1.0, -1.0}) {
    std::vector<std::uint32_t> met;
    tree.along(Place{way, 0, 0}, right_half, [&](std::uint32_t first, std::uint32_t end) {
      met.insert(met.end(), tree.order().begin() + first, tree.order().begin() + end);
      return true;
    });
    EXPECT_EQ(met.size(), 32u);
    EXPECT_TRUE(way > 0 ? met.front() < met.back() : met.front() > met.back());
  }
  int asked = 0;
  tree.along(Place{1, 0, 0}, right_half, [&](std::uint32_t, std::uint32_t) { return ++asked < 2; });
  EXPECT_EQ(asked, 2);
}

TEST(BoxTree, OfNothingIsEmpty) {
  const Tree tree(std::vector<Tree::Bounds>{});
  EXPECT_TRUE(tree.empty());
  double far = 1;
  tree.nearest_first(Place{}, far, 0, [](std::uint32_t, std::uint32_t) { FAIL(); });
}

TEST(BoxTree, MakingItCanBeStopped) {
  struct Stop : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  EXPECT_THROW(Tree(scattered(5000, 2), [](std::uint32_t) { throw Stop("enough"); }), Stop);
}

}  // namespace
}  // namespace odontoscope
