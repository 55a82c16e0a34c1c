// How far virtual slices are from shapes that are known between the slices.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "recon/between/blend.h"
#include "tests/between/slabs.h"

namespace odontoscope::test {
namespace {

constexpr std::array quarters{0.25, 0.5, 0.75};

/// A solid of which sections are known.
struct Solid {
  std::function<Outline(double)> section;
  std::function<bool(Point2, double)> holds;
};

/// Mean distance between blended and true section over the quarters of the slab from z to z + height: area in the wrong
/// material over the length of the contours.
double mean_error(const Solid& solid, double z, double height, bool with_neighbours) {
  const Outline before = solid.section(z - height), lower = solid.section(z), upper = solid.section(z + height),
                after = solid.section(z + 2 * height);
  between::Surroundings s;
  s.lower = &lower, s.upper = &upper;
  s.z_lower = z, s.z_upper = z + height;
  if (with_neighbours) s.before = &before, s.after = &after, s.z_before = z - height, s.z_after = z + 2 * height;
  for (std::size_t n = 0; n < lower.size(); ++n) (area({lower[n]}) > 0 ? s.material : s.voids).push_back({n, n});
  const std::vector<Outline> made = between::blend(s, quarters);
  double wrong = 0, length = 0;
  for (std::size_t n = 0; n < quarters.size(); ++n) {
    const double at = z + quarters[n] * height;
    wrong += area_in_wrong(
        made[n], [&](Point2 p) { return solid.holds(p, at); }, {-5, -5}, 10, 1000);
    for (const Ring& ring : solid.section(at)) {
      for (std::size_t k = 0; k < ring.size(); ++k)
        length += std::hypot(ring[k].x - ring[(k + 1) % ring.size()].x, ring[k].y - ring[(k + 1) % ring.size()].y);
    }
  }
  return wrong / length;
}

Ring fine_circle(double radius, Point2 centre = {}) { return regular_polygon(400, radius, centre); }

Solid cone() {
  return {[](double z) { return Outline{fine_circle(3 - z)}; },
          [](Point2 p, double z) { return std::hypot(p.x, p.y) < 3 - z; }};
}

Solid sphere() {
  return {[](double z) { return Outline{fine_circle(std::sqrt(9 - z * z))}; },
          [](Point2 p, double z) { return p.x * p.x + p.y * p.y + z * z < 9; }};
}

Solid torus() {
  const auto half = [](double z) { return std::sqrt(1 - z * z); };
  return {[half](double z) {
            return Outline{fine_circle(3 + half(z)), hole(fine_circle(3 - half(z)))};
          },
          [](Point2 p, double z) { return std::pow(std::hypot(p.x, p.y) - 3, 2) + z * z < 1; }};
}

Solid slanted_tube() {
  const auto centre = [](double z) { return Point2{1.5 * z, -0.5 * z}; };
  return {[centre](double z) {
            return Outline{fine_circle(0.6, centre(z)), hole(fine_circle(0.4, centre(z)))};
          },
          [centre](Point2 p, double z) {
            const double r = std::hypot(p.x - centre(z).x, p.y - centre(z).y);
            return r < 0.6 && r > 0.4;
          }};
}

TEST(BlendAccuracy, IsWithinTheThinningWhereShapesChangeEvenly) {
  EXPECT_LT(mean_error(cone(), 0.5, 0.5, true), 0.004);
  EXPECT_LT(mean_error(cone(), 0.5, 0.5, false), 0.004);
  EXPECT_LT(mean_error(slanted_tube(), 0, 0.5, true), 0.004);
  EXPECT_LT(mean_error(slanted_tube(), 0, 0.5, false), 0.004);
}

TEST(BlendAccuracy, GainsFromNeighboursWhereShapesCurve) {
  const double sphere_error = mean_error(sphere(), 1.0, 0.5, true),
               sphere_linear = mean_error(sphere(), 1.0, 0.5, false);
  EXPECT_LT(sphere_error, 0.004);
  EXPECT_LT(sphere_error, 0.5 * sphere_linear);
  const double torus_error = mean_error(torus(), -0.15, 0.3, true),
               torus_linear = mean_error(torus(), -0.15, 0.3, false);
  EXPECT_LT(torus_error, 0.004);
  EXPECT_LT(torus_error, 0.5 * torus_linear);
  RecordProperty("sphere", std::to_string(sphere_error) + " cubic, " + std::to_string(sphere_linear) + " linear");
  RecordProperty("torus", std::to_string(torus_error) + " cubic, " + std::to_string(torus_linear) + " linear");
  std::printf("mean distance, mm: sphere %.5f (linear %.5f), torus %.5f (%.5f), cone %.5f, tube %.5f\n", sphere_error,
              sphere_linear, torus_error, torus_linear, mean_error(cone(), 0.5, 0.5, true),
              mean_error(slanted_tube(), 0, 0.5, true));
}

}  // namespace
}  // namespace odontoscope::test
