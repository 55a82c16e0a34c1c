// One key leads into the pulp, wherever one is and whatever is open; and what is said where it cannot.

#include <glm/geometric.hpp>

#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

class EnteringTest : public FlightTest {
 protected:
  void expect_in_pulp() {
    ASSERT_TRUE(fly().on);
    ASSERT_TRUE(fly().cavity);
    const FlightSpace& pulp = spaces().cavities.at(*fly().cavity);
    EXPECT_EQ(pulp.walls.locate(fly().flight.eye), Walls::Side::inside);
    EXPECT_GE(pulp.walls.nearest(fly().flight.eye).distance, spaces().rules.clearance);
  }
  std::string last_notice() { return viewer().state().notices.empty() ? "" : viewer().state().notices.back().words; }
};

TEST_F(EnteringTest, WorksWithASectionOnAndBringsItBack) {
  viewer_with_tooth();
  type(U's');
  type(U'2');
  frames(40);
  const Scene before = viewer().state().scene;
  ASSERT_TRUE(before.section);
  type(U'c');
  fade();
  expect_in_pulp();
  expect_closed_in();
  type(U'c');
  fade();
  EXPECT_EQ(viewer().state().scene, before);
}

TEST_F(EnteringTest, WorksWhileMeasuringAndWithHiddenStructures) {
  viewer_with_tooth();
  type(U'm');
  for (Look& look : viewer().state().scene.looks) look.visible = false;
  type(U'c');
  fade();
  expect_in_pulp();
  expect_closed_in();
  EXPECT_EQ(mode<MeasureMode>().tool(), Tool::look);
}

TEST_F(EnteringTest, AKeyThatIsHeldRepeatsAndEntersOnce) {
  viewer_with_tooth();
  const Camera before = viewer().state().scene.camera;
  viewer().handle(TextTyped{U'c'});
  frame(0.1);
  viewer().handle(TextTyped{U'c'});  // in the middle of the dive
  frame(0.1);
  fade();
  expect_in_pulp();
  type(U'c');
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_LT(glm::length(viewer().state().scene.camera.position - before.position), 1e-9)
      << "back to the middle of the dive, not to where one was";
}

TEST_F(EnteringTest, UnderTheListOfKeysItWorksAfterItIsClosedAndADialogKeepsItsLetters) {
  viewer_with_tooth();
  viewer().state().trouble = "Something to read";
  frames(2);
  type(U'c');
  fade();
  EXPECT_FALSE(fly().on) << "flown off behind a message";
  press_key(Key::enter);
  EXPECT_TRUE(viewer().state().trouble.empty());
  type(U'?');
  EXPECT_TRUE(mode<HelpMode>().dialog_open());
  press_key(Key::enter);
  EXPECT_FALSE(mode<HelpMode>().dialog_open());
  type(U'c');
  fade();
  expect_in_pulp();
}

TEST_F(EnteringTest, KeyboardsWithoutLatinLettersGoByThePlaceOfTheKey) {
  viewer_with_tooth();
  viewer().handle(KeyChanged{Key::other, true, {}, 'c'});
  viewer().handle(TextTyped{U'\x441'});  // Cyrillic es, where c is
  viewer().handle(KeyChanged{Key::other, false, {}, 'c'});
  frame();
  fade();
  expect_in_pulp();
  viewer().handle(KeyChanged{Key::other, true, {}, 'c'});
  viewer().handle(TextTyped{U'\x3c8'});  // Greek psi
  frame();
  fade();
  EXPECT_FALSE(fly().on);
}

TEST_F(EnteringTest, FromTheMiddleOfARideItLeadsOut) {
  viewer_with(sample_tooth_loaded());
  const Scene before = viewer().state().scene;
  type(U'c');
  fade();
  type(U't');
  fade();
  ASSERT_TRUE(fly().ride);
  type(U'c');
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_EQ(viewer().state().scene, before);
}

TEST_F(EnteringTest, DbModeIsThereAgainAfterwards) {
  viewer_with(sample_tooth_loaded());
  for (Look& look : viewer().state().scene.looks) look.opacity = 1;
  mode<CompareMode>().state().wanted.grid = 16;
  type(U'd');
  ASSERT_TRUE(mode<CompareMode>().state().on);
  type(U'c');
  fade();
  expect_in_pulp();
  EXPECT_FALSE(mode<CompareMode>().state().on);
  type(U'c');
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_TRUE(mode<CompareMode>().state().on);
}

TEST_F(EnteringTest, WithoutACavityItSaysWhatToDo) {
  LoadedModel solid = toy_tooth();
  auto none = std::make_shared<FlightSpaces>(*solid.flight);
  none->cavities.clear();
  solid.flight = none;
  viewer_with(solid);
  for (int i = 0; i < 3; ++i) type(U'c');
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_NE(last_notice().find("fly around (A)"), std::string::npos) << last_notice();
  EXPECT_EQ(viewer().state().notices.size(), 1u) << "the same words three times";
  keep_picture("no-cavity");
  type(U'a');
  fade();
  EXPECT_TRUE(fly().on) << "what it told to do works";

  solid.certificate.verdict = Certificate::Verdict::wanting;
  viewer_with(solid);
  type(U'c');
  EXPECT_NE(last_notice().find("not closed"), std::string::npos) << last_notice();
}

TEST_F(EnteringTest, WithoutAModelItSaysSo) {
  make_viewer();
  frame();
  type(U'c');
  EXPECT_NE(last_notice().find("Open a model"), std::string::npos);
}

}  // namespace
}  // namespace odontoscope::testing_support
