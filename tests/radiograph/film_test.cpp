// What a film shows.
#include "recon/radiograph/film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/radiograph/solids.h"

namespace odontoscope::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Film, IsBlackWhereNothingIsSwallowedAndWhiteAtItsLatitude) {
  const FilmMap map{5, 1, {-1, 0, 2, 4, 9}};
  EXPECT_EQ(greys(map, {}), (Bytes{0, 0, 128, 255, 255}));
  EXPECT_EQ(greys(map, {.inverted = true}), (Bytes{255, 255, 128, 0, 0}));
}

TEST(Film, IsDarkerForLongerExposure) {
  const FilmMap map{3, 1, {0, 2, 4}};
  EXPECT_EQ(greys(map, {.times = std::exp(1.0)}), (Bytes{0, 64, 191}));
  EXPECT_EQ(greys(map, {.times = std::exp(-1.0)}), (Bytes{64, 191, 255}));
}

TEST(Film, HasItsFirstPixelAtTheTopLeft) {
  const FilmView view = film_behind(5, 4, 2, 0.5);
  const Point3 first = view.pixel_centre(0, 0);
  EXPECT_DOUBLE_EQ(first.x, -0.75);
  EXPECT_DOUBLE_EQ(first.y, 5);
  EXPECT_DOUBLE_EQ(first.z, 0.25);
  EXPECT_DOUBLE_EQ(view.towards_viewer().y, -1);
}

TEST(Film, IsMetByRaysFromTheFocus) {
  const FilmView view = with_focus(film_behind(5, 4, 2, 0.5), {1, -20, 3});
  const FilmRay ray = ray_to(view, 3, 1);
  EXPECT_NEAR(ray.end.x - ray.length * ray.direction.x, 1, 1e-12);
  EXPECT_NEAR(ray.end.y - ray.length * ray.direction.y, -20, 1e-12);
  EXPECT_NEAR(ray.end.z - ray.length * ray.direction.z, 3, 1e-12);
}

}  // namespace
}  // namespace odontoscope::test
