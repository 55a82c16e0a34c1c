// The X-ray film of a model without a CT: what the panel's controls do, and what is measured on it.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "engine/measure/film_length.h"
#include "engine/picture/image_difference.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

class FilmPanel : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (IsSkipped()) return;
    size_ = {760, 1300};
    viewer_with_tooth();
  }
  ViewerState& state() { return viewer().state(); }
  bool differs(const Image& before) {
    frames(3);
    return compare(picture(), before).share > 0.001;
  }
};

TEST_F(FilmPanel, ShowsTheFilmAndTheSurfacesAgain) {
  const Image surfaces = picture();
  click_control("As an X-ray film shows it");
  EXPECT_TRUE(state().film_of_model());
  EXPECT_TRUE(differs(surfaces));
  keep_picture("film-of-a-model");
  const Image film = picture();
  const auto corner = film.pixel(film.width - 60, film.height - 150),
             middle = film.pixel(
                 static_cast<int>(viewer().panes().front().area.left + viewer().panes().front().area.width / 2),
                 film.height / 2);
  EXPECT_LT(corner[0], 3);  // nothing is in the way there
  EXPECT_GT(middle[0], 60);
  EXPECT_EQ(middle[0], middle[2]);
  const glm::dvec2 latitude = control("White at attenuation");
  click(latitude.x, latitude.y);
  EXPECT_GT(state().scene.volume.latitude, 8);
  EXPECT_TRUE(differs(film));
  Image before = picture();
  click_control("Inverted");
  EXPECT_TRUE(state().scene.volume.inverted);
  EXPECT_TRUE(differs(before));
  click_control("As an X-ray film shows it");
  EXPECT_FALSE(state().film());
  EXPECT_FALSE(differs(surfaces));
}

// Of these only the smallest is smaller than the picture.
TEST_F(FilmPanel, HasTheUsualFilmsUprightAndAcross) {
  click_control("As an X-ray film shows it");
  frames(2);
  const Image whole = picture();
  for (const auto& [size, mm] :
       {std::pair{"1", glm::dvec2(24, 40)}, {"2", {31, 41}}, {"3", {27, 54}}, {"4", {57, 76}}}) {
    click_control(size, {"film"});
    EXPECT_EQ(state().scene.volume.film_mm, mm);
  }
  click_control("0", {"film"});
  EXPECT_EQ(state().scene.volume.film_mm, glm::dvec2(22, 35));
  EXPECT_TRUE(differs(whole));
  keep_picture("film-of-size-0");
  const Image upright = picture();
  click_control("Lies across");
  EXPECT_EQ(state().scene.volume.film_mm, glm::dvec2(35, 22));
  EXPECT_TRUE(differs(upright));
  click_control("1", {"film"});
  EXPECT_EQ(state().scene.volume.film_mm, glm::dvec2(40, 24)) << "another film lies as the one before did";
  click_control("No edge", {"film"});
  EXPECT_EQ(state().scene.volume.film_mm, glm::dvec2(0));
  EXPECT_FALSE(differs(whole));
}

// What is nearer to the tube than the film is enlarged by a cone alone.
TEST_F(FilmPanel, HasAConeAndAParallelBeam) {
  click_control("As an X-ray film shows it");
  frames(2);
  const Image cone = picture();
  const double height = 2 * glm::distance(state().scene.camera.position, state().scene.camera.target) *
                        std::tan(glm::radians(state().scene.camera.field_of_view_deg) / 2);
  click_control("Parallel beam", {"beam"});
  frames(2);
  EXPECT_EQ(state().scene.camera.projection, Camera::Projection::parallel);
  EXPECT_NEAR(state().scene.camera.height_mm, height, 1e-9) << "what lies at the film keeps its size";
  EXPECT_TRUE(differs(cone));
  keep_picture("film-of-a-parallel-beam");
  click_control("Cone beam", {"beam"});
  frames(2);
  EXPECT_EQ(state().scene.camera.projection, Camera::Projection::perspective);
  EXPECT_FALSE(differs(cone));
}

TEST_F(FilmPanel, SwingsTheTubeToTheRightOfBuccal) {
  click_control("As an X-ray film shows it");
  frames(2);
  const glm::dvec2 right = control("Tube swung by");
  click(right.x, right.y);
  frames(2);
  const Camera& camera = state().scene.camera;
  const AnatomicalFrame tooth;
  const glm::dvec3 towards = glm::normalize(camera.position - camera.target);
  EXPECT_NEAR(glm::dot(towards, tooth.occlusal), 0, 1e-9);
  EXPECT_GT(glm::dot(towards, tooth.buccal), 0.7);
  EXPECT_GT(glm::dot(towards, glm::cross(tooth.occlusal, tooth.buccal)), 0.4) << "not by as much as the slider says";
  EXPECT_EQ(camera.target, state().shown->model.bounds_mm.centre());
}

TEST_F(FilmPanel, MeasuresOnTheFilm) {
  click_control("As an X-ray film shows it");
  frames(2);
  Hit from, to;
  from.point_mm = {0, 3, 5};
  to.point_mm = {0, -3, -2};
  mode<MeasureMode>().measured().ends = {from, to};
  frames(3);
  const Image on_film = picture();
  keep_picture("measured-on-film");
  click_control("As an X-ray film shows it");
  EXPECT_TRUE(differs(on_film));
}

TEST_F(FilmPanel, IsNotThereForWhatIsNotClosed) {
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) {
    LoadedModel loaded = toy_tooth();
    loaded.certificate.verdict = Certificate::Verdict::wanting;
    return loaded;
  }});
  frames(2);
  for (const Interface::Place& place : viewer().interface().places)
    EXPECT_NE(place.id, control_id("As an X-ray film shows it"));
}

}  // namespace
}  // namespace odontoscope::testing_support
