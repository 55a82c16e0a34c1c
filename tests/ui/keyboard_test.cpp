// The viewer without a mouse: Tab goes through the panels, arrows change sliders, Enter presses, Escape goes back to
// the picture.

#include <glm/geometric.hpp>
#include <set>

#include "engine/viewer/actions.h"
#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

class KeyboardTest : public FlightTest {
 protected:
  void SetUp() override {
    FlightTest::SetUp();
    if (!IsSkipped()) viewer_with_tooth();
  }
  const Interface& interface() { return viewer().interface(); }
  Scene& scene() { return viewer().state().scene; }
  bool on(const Interface::Place& place) { return interface().on_control(place.id); }
  /// Tab, until the keyboard is on this control.
  bool tab_to(const std::string& label, const std::vector<std::string>& inside = {},
              const std::string& window = "panel") {
    const unsigned wanted = control_id(label, inside, window);
    for (int i = 0; i < 200; ++i) {
      press_key(Key::tab);
      if (interface().on_control(wanted)) return true;
    }
    return false;
  }
};

TEST_F(KeyboardTest, TabReachesEveryControlOfThePanelAndShiftTabGoesBack) {
  std::set<unsigned> reached, there;
  unsigned first = 0;
  std::size_t steps = 0;
  for (; steps < 300; ++steps) {
    press_key(Key::tab);
    for (const Interface::Place& place : interface().places) {
      there.insert(place.id);
      if (!on(place)) continue;
      reached.insert(place.id);
      EXPECT_GE(place.top, -1) << "out of sight";
      EXPECT_LE(place.bottom, static_cast<float>(size_.height) + 1) << "out of sight";
    }
    if (steps == 0)
      first = *reached.begin();
    else if (interface().on_control(first))
      break;
  }
  EXPECT_GT(reached.size(), 25u);
  EXPECT_EQ(reached, there);
  press_key(Key::tab);
  press_key(Key::tab, {.shift = true});
  EXPECT_TRUE(interface().on_control(first));
}

TEST_F(KeyboardTest, ArrowsMoveASliderAndNotTheCamera) {
  ASSERT_TRUE(tab_to("enamel", {"enamel"}));
  size_ = {960, 640};
  frame();
  keep_picture("keyboard-slider");
  const Camera before = scene().camera;
  const float opacity = scene().look_of("enamel")->opacity;
  for (int i = 0; i < 3; ++i) press_key(Key::right);
  EXPECT_NEAR(scene().look_of("enamel")->opacity, opacity + 0.03, 1e-5);
  press_key(Key::left);
  EXPECT_NEAR(scene().look_of("enamel")->opacity, opacity + 0.02, 1e-5);
  EXPECT_TRUE(interface().on_control(control_id("enamel", {"enamel"}))) << "it went to the neighbour";
  press_key(Key::enter);  // presses nothing there
  EXPECT_NEAR(scene().look_of("enamel")->opacity, opacity + 0.02, 1e-5);
  EXPECT_EQ(scene().camera, before);
  press_key(Key::escape);
  press_key(Key::right);
  EXPECT_NE(scene().camera, before) << "the arrows are the picture's again";
  EXPECT_NEAR(scene().look_of("enamel")->opacity, opacity + 0.02, 1e-5);
}

TEST_F(KeyboardTest, EnterAndSpacePress) {
  ASSERT_TRUE(tab_to("eye", {"pulp"}));
  press_key(Key::enter);
  EXPECT_FALSE(scene().look_of("pulp")->visible);
  press_key(Key::space);
  EXPECT_TRUE(scene().look_of("pulp")->visible);
  ASSERT_TRUE(tab_to("Tint", {"back faces"}));
  press_key(Key::enter);
  EXPECT_EQ(scene().back_faces, BackFaces::tint);
  press_key(Key::left);  // ImGui's own navigation, between neighbours
  press_key(Key::space);
  EXPECT_EQ(scene().back_faces, BackFaces::show);
  ASSERT_TRUE(tab_to("Section"));
  press_key(Key::enter);  // folds it up
  for (const Interface::Place& place : interface().places) EXPECT_NE(place.id, control_id("Cut the model open"));
  press_key(Key::down);
  EXPECT_TRUE(interface().by_keys());
}

TEST_F(KeyboardTest, TheColourPaletteOpensAndCloses) {
  ASSERT_TRUE(tab_to("swatch", {"dentine", "colour"}));
  press_key(Key::enter);
  EXPECT_TRUE(interface().popup_open());
  press_key(Key::escape);
  EXPECT_FALSE(interface().popup_open());
  EXPECT_TRUE(interface().by_keys()) << "back on the panel, not in the picture";
}

TEST_F(KeyboardTest, TabShowsThePanelIfItIsAway) {
  press_key(Key::f9);
  ASSERT_FALSE(viewer().state().settings.panel);
  press_key(Key::tab);
  frame();
  EXPECT_TRUE(viewer().state().settings.panel);
  press_key(Key::tab);
  EXPECT_TRUE(interface().by_keys());
}

TEST_F(KeyboardTest, ANoteIsWrittenWithoutAMouse) {
  ASSERT_TRUE(tab_to("Notes"));
  press_key(Key::enter);  // unfolds it
  ASSERT_TRUE(tab_to("Note this view"));
  press_key(Key::enter);
  NotesState& notes = mode<NotesMode>().notes();
  ASSERT_TRUE(notes.draft);
  frames(3);
  for (const char32_t letter : {U'A', U'b'}) type(letter);
  press_key(Key::tab);  // into the text
  frames(3);
  for (const char32_t letter : {U'c', U'd'}) type(letter);
  ASSERT_TRUE(notes.draft) << "a letter was a command";
  EXPECT_EQ(notes.draft->title, "Ab");
  EXPECT_EQ(notes.draft->text, "cd");
  EXPECT_FALSE(fly().on);
  press_key(Key::tab);  // into the narration
  frames(3);
  type(U'e');
  EXPECT_EQ(notes.draft->narration, "e");
  press_key(Key::tab);
  press_key(Key::enter);
  frames(2);
  ASSERT_EQ(notes.lesson.notes.size(), 1u);
  EXPECT_EQ(notes.lesson.notes[0].title, "Ab");
}

TEST_F(KeyboardTest, ADialogIsAnsweredByTabAndEnter) {
  mode<NotesMode>().notes().unsaved = true;
  EXPECT_FALSE(viewer().may_close());
  frames(2);
  for (int i = 0; i < 3; ++i) {
    press_key(Key::tab);
    ASSERT_TRUE(interface().by_keys());
    for (const Interface::Place& place : interface().places) {
      if (on(place)) {
        EXPECT_EQ(place.window, control_id("", {}, "leaving")) << "the panel lies behind";
      }
    }
  }
  press_key(Key::enter);  // the third: stay
  frames(2);
  EXPECT_FALSE(mode<NotesMode>().notes().leaving);
  EXPECT_FALSE(viewer().state().close);
  EXPECT_FALSE(interface().by_keys()) << "the dialog is gone";
}

TEST_F(KeyboardTest, InFlightThePanelIsReachedAndFlyingGoesOn) {
  type(U'c');
  fade();
  ASSERT_TRUE(tab_to("Speed"));
  const double speed_factor = fly().habits.speed_factor;
  const Flight before = fly().flight;
  press_key(Key::right);
  EXPECT_GT(fly().habits.speed_factor, speed_factor);
  EXPECT_EQ(fly().flight.view_direction, before.view_direction) << "it looked round as well";
  hold('w', 0.2);
  EXPECT_GT(glm::length(fly().flight.eye - before.eye), 0.01);
  press_key(Key::escape);
  EXPECT_TRUE(fly().on) << "the first Esc only leaves the panel";
  ASSERT_TRUE(tab_to("Back to outside (C)"));
  press_key(Key::enter);
  fade();
  EXPECT_FALSE(fly().on);
  EXPECT_FALSE(interface().by_keys());
}

TEST_F(KeyboardTest, LengthsAreMeasuredInTheMiddleOfThePicture) {
  press_key(Key::f9);
  type(U'm');
  press_key(Key::enter);
  ASSERT_EQ(mode<MeasureMode>().measured().ends.size(), 1u);
  press_key(Key::right);
  press_key(Key::enter);
  ASSERT_EQ(mode<MeasureMode>().measured().ends.size(), 2u);
  EXPECT_GT(distance_between_mm(mode<MeasureMode>().measured().ends[0], mode<MeasureMode>().measured().ends[1]), 0.1);
  keep_picture("keyboard-measure");
}

TEST_F(KeyboardTest, AClickEndsIt) {
  press_key(Key::tab);
  ASSERT_TRUE(interface().by_keys());
  click(400, 200);
  EXPECT_FALSE(interface().by_keys());
}

}  // namespace
}  // namespace odontoscope::testing_support
