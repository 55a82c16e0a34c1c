// Lengths inside solids, against chords computed from other things than faces.
#include "recon/radiograph/length_inside.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <numeric>

#include "recon/core/error.h"
#include "recon/delaunay/reconstruct.h"
#include "tests/radiograph/solids.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

FilmMap lengths(const std::vector<SurfaceMesh>& surfaces, const FilmView& view) {
  std::vector<const SurfaceMesh*> pointers;
  for (const SurfaceMesh& surface : surfaces) pointers.push_back(&surface);
  return length_inside(pointers, view);
}

double sum(const FilmMap& map) { return std::accumulate(map.values.begin(), map.values.end(), 0.0); }

/// The largest difference to `chord(ray)` over all pixels.
template <class Chord>
double worst(const FilmMap& map, const FilmView& view, Chord chord) {
  double most = 0;
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column)
      most = std::max(most, std::abs(map.at(column, row) - chord(ray_to(view, column, row))));
  return most;
}

// Pixels' centres lie on edges, on corners and on the diagonals of the block's sides.
TEST(LengthInside, OfABlockOnTheGridBelongsToEachPixelOnce) {
  FilmView view = film_behind(5, 16, 16, 1);
  const FilmMap map = lengths({block({-2.5, -1, -3.5}, {3.5, 2, 2.5})}, view);
  int inside = 0;
  for (const double value : map.values) {
    EXPECT_TRUE(value == 0 || value == 3) << value;
    inside += value == 3;
  }
  EXPECT_EQ(inside, 36);  // 6 x 6: of the pixels on the border those on two sides
}

TEST(LengthInside, OfABallIsItsChord) {
  const Point3 centre{0.4, 1, -0.3};
  const SurfaceMesh mesh = ball(centre, 3, 384, 256);
  const auto chord = [&](const FilmRay& ray) { return chord_of_ball(ray, centre, 3); };
  // A facet of 3 mm * 2 pi / 384 lies 0.0004 mm within the ball, which at the rim is a chord of 2 sqrt(2 * 3 * 0.0004)
  // = 0.1 mm.
  for (const FilmView& view :
       {aslant(film_behind(5, 101, 99, 0.1)), with_focus(film_behind(5, 101, 99, 0.1), {1, -30, 2})}) {
    const FilmMap map = lengths({mesh}, view);
    EXPECT_LT(worst(map, view, chord), 0.1);
    double off = 0;
    int deep = 0;
    for (int row = 0; row < map.height; ++row)
      for (int column = 0; column < map.width; ++column) {
        const double right = chord(ray_to(view, column, row));
        if (right < 2) continue;
        ++deep;
        off = std::max(off, std::abs(map.at(column, row) - right));
      }
    EXPECT_GT(deep, 1000);
    EXPECT_LT(off, 0.003);
  }
}

TEST(LengthInside, IsThatThroughTheTetrahedra) {
  for (const ContourStack& stack : {annulus_over_disc_with_two_holes(), drifting_canal(), two_over_two_crosswise()}) {
    const Reconstruction made = reconstruct(stack);
    const Solid& solid = made.solids.at(0);
    double size = 0;
    for (const Point3& point : solid.surface.points)
      size = std::max({size, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    for (FilmView view : {aslant(film_behind(2 * size, 41, 37, size / 17)),
                          with_focus(film_behind(2 * size, 41, 37, size / 12), {0.3 * size, -9 * size, 0.7 * size})}) {
      const FilmMap map = lengths({solid.surface}, view);
      EXPECT_GT(sum(map), 0);
      const double off = worst(map, view, [&](const FilmRay& ray) {
        double through = 0;
        for (const Tetrahedron& corners : solid.tetrahedra.tetrahedra)
          through += chord_of_tetrahedron(ray, solid.tetrahedra.points, corners);
        return through;
      });
      EXPECT_LT(off, 1e-4 * size);
    }
  }
}

TEST(LengthInside, LeavesCavitiesOut) {
  const FilmView view = aslant(film_behind(9, 60, 60, 0.2));
  const FilmMap full = lengths({block({-4, -4, -4}, {4, 4, 4})}, view),
                hollow = lengths({block({-4, -4, -4}, {4, 4, 4}), turned_inside_out(ball({0, 0, 0}, 2))}, view),
                body = lengths({ball({0, 0, 0}, 2)}, view);
  for (std::size_t i = 0; i < full.values.size(); ++i)
    EXPECT_NEAR(hollow.values[i], full.values[i] - body.values[i], 1e-12);
}

// What no ray may see: a crack. A ball of a million narrow faces, pixels coarser than they.
TEST(LengthInside, NeverLeaks) {
  const SurfaceMesh mesh = ball({0.01, 0, 0.02}, 3, 700, 500);
  for (const FilmView& view : {film_behind(5, 90, 90, 0.1), with_focus(film_behind(5, 90, 90, 0.1), {0, -25, 0})}) {
    const FilmMap map = lengths({mesh}, view);
    for (const double value : map.values) {
      EXPECT_GT(value, -1e-9);
      EXPECT_LT(value, 6.001);
    }
  }
}

// With the focus twice as far from the film as what it shines through, a shadow is twice as wide.
TEST(LengthInside, OfAConeBeamIsMagnified) {
  const SurfaceMesh plate = block({-1, 0, -1}, {1, 0.001, 1});
  const FilmView view = with_focus(film_behind(10, 200, 200, 0.05), {0, -10, 0});
  const FilmMap map = lengths({plate}, view);
  EXPECT_NEAR(
      static_cast<double>(std::count_if(map.values.begin(), map.values.end(), [](double value) { return value > 0; })) *
          0.05 * 0.05,
      16, 0.35);
  EXPECT_NEAR(map.at(100, 100), 0.001, 1e-6);
}

// SLOB: swing the tube, and what lies nearer to it than another moves the other way.
TEST(LengthInside, ShowsOnWhichSideOfAnotherAThingLies) {
  const SurfaceMesh buccal = ball({0, -3, 0}, 0.5), lingual = ball({0, 3, 0}, 0.5);
  const auto middle = [](const FilmMap& map) {
    double moment = 0, mass = 0;
    for (int row = 0; row < map.height; ++row)
      for (int column = 0; column < map.width; ++column) {
        moment += column * map.at(column, row);
        mass += map.at(column, row);
      }
    return moment / mass;
  };
  const double angle = 0.35;
  FilmView view = film_behind(5, 240, 60, 0.05);
  view.towards_tube = {std::sin(angle), -std::cos(angle), 0};  // to the right
  EXPECT_NEAR(0.05 * (middle(lengths({lingual}, view)) - middle(lengths({buccal}, view))), 6 * std::tan(angle), 1e-3);
}

TEST(LengthInside, IsTheSameOnOneThread) {
  const SurfaceMesh mesh = ball({0, 0, 0}, 3);
  const FilmView view = aslant(film_behind(5, 120, 110, 0.07));
  const FilmMap many = lengths({mesh}, view);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(lengths({mesh}, view).values, many.values);
}

TEST(LengthInside, RefusesAFocusWithinTheSolid) {
  const std::vector<SurfaceMesh> solid{block({-1, -1, -1}, {1, 1, 1})};
  EXPECT_THROW(lengths(solid, with_focus(film_behind(5, 10, 10, 1), {0, 0, 0})), UsageError);
  EXPECT_THROW(lengths(solid, with_focus(film_behind(5, 10, 10, 1), {0, -1, 0})), UsageError);
}

TEST(LengthInside, RefusesPixelsTooSmallToCountIn) {
  EXPECT_THROW(lengths({block({-1, -1, -1}, {1, 1, 1})}, film_behind(5, 10, 10, 1e-7)), UsageError);
}

TEST(LengthInside, OfWhatIsBesideTheFilmIsNothing) {
  for (const Point3 aside : {Point3{30, 0, 0}, {-30, 0, 0}, {0, 0, 30}, {0, 0, -30}}) {
    const FilmMap map = lengths({ball(aside, 2, 12, 8)}, film_behind(5, 32, 32, 0.5));
    EXPECT_EQ(sum(map), 0);
  }
}

}  // namespace
}  // namespace odontoscope::test
