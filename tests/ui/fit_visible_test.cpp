// What is hidden needs no room in the picture.

#include "engine/scene/fit_visible.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

double distance_of(const Camera& camera) { return glm::length(camera.position - camera.target); }

TEST(FitVisible, ComesNearerTheLessIsShown) {
  const Model model = toy_tooth().model;
  const auto fitted = [&](const std::vector<std::string>& hidden) {
    return fit_without(hidden, NamedView::buccal, model, 1.2, Camera::Projection::perspective);
  };
  const Camera whole = fit(NamedView::buccal, model, 1.2);
  EXPECT_EQ(fitted({}), whole);
  EXPECT_LT(distance_of(fitted({"enamel"})), 0.95 * distance_of(whole));
  EXPECT_LT(distance_of(fitted({"enamel", "dentine"})), 0.5 * distance_of(whole));
  EXPECT_EQ(fitted({"enamel", "dentine", "pulp"}), whole) << "nothing is left to fit";
  Scene scene = toy_tooth().scene;
  scene.look_of("enamel")->visible = false;
  EXPECT_EQ(hidden_in(scene), (std::vector<std::string>{"enamel"}));
}

class FitVisibleInTheViewer : public ViewerTest {};

TEST_F(FitVisibleInTheViewer, FitIsOfWhatIsShown) {
  viewer_with_tooth();
  type(U'f');
  frames(60);
  const double whole = distance_of(viewer().state().scene.camera);
  viewer().state().scene.look_of("enamel")->visible = false;
  viewer().state().scene.look_of("dentine")->visible = false;
  type(U'f');
  frames(60);
  EXPECT_LT(distance_of(viewer().state().scene.camera), 0.6 * whole);
}

}  // namespace
}  // namespace odontoscope::testing_support
