// Lengths on an X-ray film, by hand.
#include "engine/measure/film_length.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace odontoscope::test {
namespace {

const glm::dvec3 centre{1, 2, 10};
/// Looks along -y at the centre, from 100 mm.
const Camera parallel{Camera::Projection::parallel, {1, 102, 10}, centre, {0, 0, 1}, 24, 20};
const Camera tube{Camera::Projection::perspective, {1, 102, 10}, centre, {0, 0, 1}, 24, 20};

TEST(LengthOnFilm, OfWhatLiesInItsPlaneIsItsOwn) {
  const std::array line{glm::dvec3(0, 2, 4), glm::dvec3(0, 2, 10), glm::dvec3(4, 2, 13)};
  EXPECT_NEAR(length_of(line), 11, 1e-12);
  EXPECT_NEAR(length_on_film(line, parallel, centre), 11, 1e-12);
  EXPECT_NEAR(length_on_film(line, tube, centre), 11, 1e-12);
}

TEST(LengthOnFilm, OfWhatLeansIsShorter) {
  const std::array line{glm::dvec3(1, 2, 10), glm::dvec3(1, 6, 7)};  // 3 down, 4 towards the tube
  EXPECT_NEAR(length_of(line), 5, 1e-12);
  EXPECT_NEAR(length_on_film(line, parallel, centre), 3, 1e-12);
  EXPECT_NEAR(length_on_film(line, tube, centre), 3 * 100 / 96.0, 1e-12);
}

TEST(LengthOnFilm, OfWhatIsNearerToTheTubeIsLarger) {
  const std::array line{glm::dvec3(0, 52, 10), glm::dvec3(2, 52, 10)};
  EXPECT_NEAR(length_on_film(line, parallel, centre), 2, 1e-12);
  EXPECT_NEAR(length_on_film(line, tube, centre), 4, 1e-12);
}

TEST(LengthOnFilm, LeavesOutWhatIsBehindTheTube) {
  const std::array line{glm::dvec3(0, 2, 10), glm::dvec3(0, 2, 12), glm::dvec3(0, 200, 12)};
  EXPECT_NEAR(length_on_film(line, tube, centre), 2, 1e-12);
}

}  // namespace
}  // namespace odontoscope::test
