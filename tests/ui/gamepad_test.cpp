// A gamepad: raw states as GLFW gives them, and what the viewer makes of them.

#include "engine/view/gamepad.h"

#include <glm/geometric.hpp>
#include <limits>

#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

using Pad = PadState;

PadState pushed(std::initializer_list<std::pair<Pad::Axis, float>> axes,
                std::initializer_list<Pad::Button> buttons = {}) {
  PadState state;
  for (const auto& [axis, value] : axes) state.axes[axis] = value;
  for (const Pad::Button button : buttons) state.held[button] = true;
  return state;
}

TEST(Gamepad, AtRestWantsNothingHoweverWorn) {
  EXPECT_FALSE(in_use(gamepad_from({})));
  EXPECT_TRUE(gamepad_from({}).present);
  // As recorded from a pad that lies on the table: sticks off their middles, triggers not quite out.
  EXPECT_FALSE(in_use(gamepad_from(pushed({{Pad::left_x, 0.078f},
                                           {Pad::left_y, -0.11f},
                                           {Pad::right_x, -0.094f},
                                           {Pad::right_y, 0.1f},
                                           {Pad::left_trigger, -0.97f}}))));
  // A driver that has not heard of the triggers yet.
  EXPECT_FALSE(in_use(gamepad_from(pushed({{Pad::left_trigger, 0}, {Pad::right_trigger, 0}}))));
  EXPECT_EQ(gamepad_from(pushed({{Pad::left_trigger, 0}})).rise, 0);
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(in_use(gamepad_from(pushed({{Pad::left_x, none}, {Pad::right_y, none}, {Pad::right_trigger, none}}))));
}

TEST(Gamepad, SticksPointWhereTheyArePushed) {
  const GamepadChanged ahead = gamepad_from(pushed({{Pad::left_y, -1}}));
  EXPECT_DOUBLE_EQ(ahead.move_ahead, 1);
  EXPECT_EQ(ahead.move_right, 0);
  EXPECT_DOUBLE_EQ(gamepad_from(pushed({{Pad::left_x, -1}})).move_right, -1);
  EXPECT_DOUBLE_EQ(gamepad_from(pushed({{Pad::right_y, -1}})).turn_up, 1);
  EXPECT_DOUBLE_EQ(gamepad_from(pushed({{Pad::right_x, 1}})).turn_right, 1);
  const GamepadChanged aslant =
      gamepad_from(pushed({{Pad::left_x, 0.9f}, {Pad::left_y, -0.1f}}));  // the smaller part is kept: no cross is dead
  EXPECT_NEAR(aslant.move_ahead / aslant.move_right, 1.0 / 9, 1e-6);
  const GamepadChanged corner = gamepad_from(pushed({{Pad::left_x, 1}, {Pad::left_y, 1}}));
  EXPECT_NEAR(std::hypot(corner.move_right, corner.move_ahead), 1, 1e-9) << "square sticks are no faster";
  double before = 0;
  for (float push = 0; push <= 1; push += 0.01f) {
    const double speed = gamepad_from(pushed({{Pad::left_x, push}})).move_right;
    EXPECT_GE(speed, before);
    EXPECT_LT(speed - before, 0.03) << "a jump at " << push;
    before = speed;
  }
  EXPECT_DOUBLE_EQ(gamepad_from(pushed({{Pad::right_trigger, 1}})).rise, 1);
  EXPECT_DOUBLE_EQ(gamepad_from(pushed({{Pad::left_trigger, 1}})).rise, -1);
  EXPECT_EQ(gamepad_from(pushed({{Pad::left_trigger, 1}, {Pad::right_trigger, 1}})).rise, 0);
}

TEST(Gamepad, EachButtonIsOneWish) {
  const std::pair<Pad::Button, bool GamepadChanged::*> known[] = {{Pad::a, &GamepadChanged::play},
                                                                  {Pad::b, &GamepadChanged::leave},
                                                                  {Pad::x, &GamepadChanged::pass},
                                                                  {Pad::y, &GamepadChanged::next},
                                                                  {Pad::left_bumper, &GamepadChanged::faster},
                                                                  {Pad::right_bumper, &GamepadChanged::faster},
                                                                  {Pad::start, &GamepadChanged::help},
                                                                  {Pad::back, &GamepadChanged::outdoors},
                                                                  {Pad::dpad_right, &GamepadChanged::next_note},
                                                                  {Pad::dpad_left, &GamepadChanged::previous_note},
                                                                  {Pad::dpad_up, &GamepadChanged::labels},
                                                                  {Pad::dpad_down, &GamepadChanged::pictures}};
  for (const auto& [button, wish] : known) {
    GamepadChanged expected{.present = true};
    expected.*wish = true;
    EXPECT_EQ(gamepad_from(pushed({}, {button})), expected) << button;
  }
  for (const Pad::Button unused : {Pad::guide, Pad::left_thumb, Pad::right_thumb})
    EXPECT_FALSE(in_use(gamepad_from(pushed({}, {unused}))));
}

class GamepadFlightTest : public FlightTest {
 protected:
  void hand(const PadState& state) {
    viewer().handle(gamepad_from(state));
    frame();
  }
  void push_button(Pad::Button button) {
    hand(pushed({}, {button}));
    hand({});
  }
};

TEST_F(GamepadFlightTest, GoesInRidesAndComesOutWithoutKeys) {
  viewer_with(sample_tooth_loaded());
  push_button(Pad::a);
  fade();
  ASSERT_TRUE(fly().on);
  EXPECT_TRUE(viewer().state().pad_in_hand);
  size_ = {960, 640};
  frame();
  keep_picture("gamepad-hints");
  push_button(Pad::y);
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_TRUE(fly().ride->playing);
  push_button(Pad::a);
  EXPECT_FALSE(fly().ride->playing);
  push_button(Pad::dpad_up);
  EXPECT_FALSE(fly().habits.labels);
  push_button(Pad::dpad_down);
  EXPECT_FALSE(fly().habits.inset);
  push_button(Pad::start);
  EXPECT_TRUE(mode<HelpMode>().dialog_open());
  keep_picture("gamepad-list");
  push_button(Pad::b);  // what is open first
  EXPECT_FALSE(mode<HelpMode>().dialog_open());
  EXPECT_TRUE(fly().on);
  push_button(Pad::back);
  fade();
  EXPECT_TRUE(fly().on);
  EXPECT_FALSE(fly().cavity);
  push_button(Pad::a);
  fade();
  EXPECT_TRUE(fly().cavity);
  push_button(Pad::b);
  fade();
  EXPECT_FALSE(fly().on);
  press_key(Key::left);
  EXPECT_FALSE(viewer().state().pad_in_hand);
}

TEST_F(GamepadFlightTest, AButtonThatIsHeldCountsOnce) {
  viewer_with_tooth();
  hand(pushed({}, {Pad::a}));
  fade();
  ASSERT_TRUE(fly().on);
  hand(pushed({{Pad::left_x, 0.5f}}, {Pad::a}));  // still held while something else changes
  frames(3);
  hand({});
  push_button(Pad::b);
  fade();
  EXPECT_FALSE(fly().on);
}

TEST_F(GamepadFlightTest, PulledOutInTheMiddleOfAFlightItStops) {
  viewer_with_tooth();
  type(U'c');
  fade();
  hand(pushed({{Pad::right_x, 1}}));
  frames(20);
  EXPECT_EQ(viewer().wait_timeout(), 0);
  viewer().handle(GamepadChanged{});  // gone, as Window::events tells it
  frames(180);
  EXPECT_GT(viewer().wait_timeout(), 0.1) << "it flies on by itself";
  EXPECT_FALSE(viewer().state().pad_in_hand);
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("gone"), std::string::npos);
  hand(pushed({{Pad::left_y, -1}}));  // and back again
  const glm::dvec3 before = fly().flight.eye;
  frames(20);
  EXPECT_GT(glm::length(fly().flight.eye - before), 0.05);
}

}  // namespace
}  // namespace odontoscope::testing_support
