// The tree finds what a plain loop over all triangles finds.

#include "engine/measure/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stop_token>

#include "tests/render/shapes.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::testing_support {
namespace {

glm::dvec3 corner(const ModelPart& part, std::size_t triangle, int k) {
  return glm::dvec3(part.positions[part.indices[3 * triangle + static_cast<std::size_t>(k)]]);
}

/// Distances of all crossings by Cramer's rule.
std::vector<double> crossings_by_hand(const ModelPart& part, const TreeRay& ray) {
  std::vector<double> found;
  for (std::size_t t = 0; t < part.indices.size() / 3; ++t) {
    const glm::dvec3 a = corner(part, t, 0), u = corner(part, t, 1) - a, v = corner(part, t, 2) - a;
    const glm::dvec3 p = glm::cross(ray.direction, v);
    const double det = glm::dot(u, p);
    if (det == 0) continue;
    const glm::dvec3 s = ray.origin - a, q = glm::cross(s, u);
    const double x = glm::dot(s, p) / det, y = glm::dot(ray.direction, q) / det, distance = glm::dot(v, q) / det;
    if (x >= 0 && y >= 0 && x + y <= 1 && distance >= ray.from) found.push_back(distance);
  }
  std::sort(found.begin(), found.end());
  return found;
}

class Rays {
 public:
  glm::dvec3 place(double size) { return {number(size), number(size), number(size)}; }
  TreeRay ray(double size) {
    TreeRay ray{place(size), glm::normalize(place(1))};
    return ray;
  }

 private:
  double number(double size) { return random_.between(-size, size); }
  test::RandomNumbers random_{7};
};

TEST(TriangleTree, FindsTheCrossingsThatALoopFinds) {
  const Model model = make_model({{"ring", ring({})}});
  const TriangleTree tree(model);
  Rays rays;
  std::size_t hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const TreeRay ray = rays.ray(0.006);
    const std::vector<double> expected = crossings_by_hand(model.parts[0], ray);
    std::vector<double> found;
    tree.each(ray, [&](const Crossing& crossing) { found.push_back(crossing.distance); });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), expected.size()) << i;
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12);
    const auto nearest = tree.nearest(ray, [](const Crossing&) { return true; });
    ASSERT_EQ(nearest.has_value(), !expected.empty());
    if (nearest) {
      EXPECT_NEAR(nearest->distance, expected.front(), 1e-12);
    }
    hits += expected.size();
  }
  EXPECT_GT(hits, 500u);
}

TEST(TriangleTree, ClosedSurfacesArePassedInAsOftenAsOutThroughEdgesAndVertices) {
  // Every ray runs through a vertex or along a row of edges of the box, whose coordinates float holds exactly.
  const Model model = make_model({{"box", box({-1024, -1024, -1024}, {1024, 1024, 1024})}});
  const TriangleTree tree(model);
  const double side = model.parts[0].positions[0].x;
  for (const glm::dvec3& direction :
       {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(1, 1, 0)),
        glm::normalize(glm::dvec3(1, 1, 1)), glm::normalize(glm::dvec3(-1, 1, -1))})
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          TreeRay ray{glm::dvec3(x, y, z) * std::abs(side), direction, -100};
          int around = 0;
          tree.each(ray, [&](const Crossing& crossing) { around += crossing.front ? 1 : -1; });
          EXPECT_EQ(around, 0);
        }
}

TEST(TriangleTree, KnowsFrontFromBack) {
  const TriangleTree tree(make_model({{"ball", ball({{}, 5})}}));
  const auto any = [](const Crossing&) { return true; };
  EXPECT_TRUE(tree.nearest({{0.1, 0.0001, 0.0002}, {-1, 0, 0}}, any)->front);
  EXPECT_FALSE(tree.nearest({{0, 0.0001, 0.0002}, {-1, 0, 0}}, any)->front);
}

TEST(TriangleTree, FindsTheNearestPointThatALoopFinds) {
  const Model model = make_model({{"ring", ring({.radius = 4, .tube = 1.5, .around = 20, .across = 9})}});
  const TriangleTree tree(model);
  Rays rays;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 place = rays.place(0.008);
    // No nearer than the nearest vertex, no farther; and exactly the distance of the best of many points on the
    // triangle found.
    double vertex = 1;
    for (const glm::vec3& p : model.parts[0].positions) vertex = std::min(vertex, glm::distance(glm::dvec3(p), place));
    const auto nearest = tree.nearest_point(place, [](std::uint32_t) { return true; });
    ASSERT_TRUE(nearest);
    EXPECT_LE(nearest->distance, vertex);
    double least = 1;
    constexpr int steps = 24;
    for (std::size_t t = 0; t < model.parts[0].indices.size() / 3; ++t)
      for (int u = 0; u <= steps; ++u)
        for (int v = 0; u + v <= steps; ++v) {
          const double x = double(u) / steps, y = double(v) / steps;
          const glm::dvec3 p = (1 - x - y) * corner(model.parts[0], t, 0) + x * corner(model.parts[0], t, 1) +
                               y * corner(model.parts[0], t, 2);
          least = std::min(least, glm::distance(p, place));
        }
    EXPECT_LE(nearest->distance, least + 1e-12);
    EXPECT_GE(nearest->distance, least - 6e-5) << "a grid of a 24th of an edge of 1.3 mm";
  }
}

TEST(TriangleTree, CanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(TriangleTree(small_molar(), Progress{{}, stop.get_token()}), Cancelled);
}

TEST(TriangleTree, OfAnEmptyModelFindsNothing) {
  const TriangleTree tree;
  EXPECT_FALSE(tree.nearest({}, [](const Crossing&) { return true; }));
  EXPECT_FALSE(tree.nearest_point({}, [](std::uint32_t) { return true; }));
}

}  // namespace
}  // namespace odontoscope::testing_support
