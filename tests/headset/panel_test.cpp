// The panel in the room and the menu button, by numbers: where it stands, what a ray meets, whose trigger it is.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <random>

#include "tests/headset/visiting.h"

namespace odontoscope::testing_support {
namespace {

TEST(RoomPanel, StandsBesideThePersonTiltedToTheEyes) {
  const Pose head{{0.5, 1.2, -2}, glm::angleAxis(1.1, glm::dvec3(0, 1, 0)) * glm::angleAxis(-0.3, glm::dvec3(1, 0, 0))};
  for (const double side : {-1.0, 1.0}) {
    const RoomPanel panel = place_panel(head, side);
    const glm::dvec3 way = panel.pose.position - head.position;
    EXPECT_NEAR(glm::length(way), panel_distance, 1e-12);
    EXPECT_LT(way.y, 0);
    EXPECT_GT(side * glm::dot(way, heading_of(head) * glm::dvec3(1, 0, 0)), 0.2);
    // It faces the eyes, and its upper edge is level.
    EXPECT_LT(glm::length(panel.pose.turn * glm::dvec3(0, 0, 1) + glm::normalize(way)), 1e-12);
    EXPECT_NEAR((panel.pose.turn * glm::dvec3(1, 0, 0)).y, 0, 1e-12);
    EXPECT_TRUE(within_sight(panel, head));
    EXPECT_FALSE(within_sight(panel, {head.position, head.turn * glm::angleAxis(3.0, glm::dvec3(0, 1, 0))}));
    EXPECT_FALSE(
        within_sight(panel, {head.position + 1.5 * way, head.turn}));  // it is behind that head, and turned away
  }
}

TEST(RoomPanel, KeepsItsAngleWhereThereIsLessRoomButNeverMakesTheEyesSquint) {
  const Pose head{{0, 1.6, 0}, {1, 0, 0, 0}};
  const RoomPanel usual = place_panel(head, 1), near = place_panel(head, 1, 0.5), nearest = place_panel(head, 1, 0.01),
                  far = place_panel(head, 1, 30);
  EXPECT_NEAR(near.size.y / 0.5, usual.size.y / panel_distance, 1e-12);
  EXPECT_NEAR(glm::length(nearest.pose.position - head.position), least_panel_distance, 1e-12);
  EXPECT_EQ(far, usual);
}

TEST(RoomPanel, ARayMeetsItWhereItsPlaceIs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-0.3, 1.3), about(-0.3, 0.3);
  const Pose head{{0, 1.6, 0}, glm::angleAxis(0.6, glm::dvec3(0, 1, 0))};
  const RoomPanel panel = place_panel(head, -1);
  for (int i = 0; i < 200; ++i) {
    const double x = share(random), y = share(random), a = about(random), b = about(random), c = about(random);
    const glm::dvec3 from = head.position + glm::dvec3(a, b, c), place = place_of(panel, {x, y});
    const auto aimed = aimed_at(panel, pointing_at(place, from).aim);
    ASSERT_TRUE(aimed);
    EXPECT_LT(glm::length(aimed->at - glm::dvec2(x, y)), 1e-9);
    EXPECT_NEAR(aimed->distance, glm::length(place - from), 1e-9);
    EXPECT_EQ(aimed->on_it(), x >= 0 && x <= 1 && y >= 0 && y <= 1);
    EXPECT_FALSE(aimed_at(panel, pointing_at(from, place - 0.1 * glm::normalize(from - place)).aim)) << "from behind";
  }
  // The first corner is the reader's upper left.
  const glm::dvec3 corner = glm::conjugate(head.turn) * (place_of(panel, {0, 0}) - panel.pose.position);
  EXPECT_LT(corner.x, 0);
  EXPECT_GT(corner.y, 0);
}

class PanelInVisit : public VisitingBalls {
 protected:
  void SetUp() override { step(); }
  void press_menu(std::size_t hand) {
    input.hands[hand].menu = true;
    step(5);
    input.hands[hand].menu = false;
    step();
  }
  void point(std::size_t hand, const glm::dvec2& at) {
    const HandInput before = input.hands[hand];
    input.hands[hand] =
        pointing_at(place_of(*visit.panel, at), input.head.position + glm::dvec3(hand == 0 ? -0.2 : 0.2, -0.35, 0));
    input.hands[hand].trigger = before.trigger;
    input.hands[hand].grab = before.grab;
    step();
  }
  void enter() {
    visit.pending_actions.push_back(VisitAction::enter);
    seconds(2.2 * rules.fade_seconds);
    ASSERT_TRUE(visit.cavity);
  }
};

TEST_F(PanelInVisit, IsThereAtFirstAndStaysInTheWorld) {
  ASSERT_TRUE(visit.panel);
  const RoomPanel panel = *visit.panel;
  input.head.position += glm::dvec3(0.1, 0, 0.1);
  input.head.turn = glm::angleAxis(0.4, glm::dvec3(0, 1, 0));
  step(20);
  EXPECT_EQ(*visit.panel, panel);
  input.recentred = true;  // everything comes before the person again
  step();
  EXPECT_EQ(*visit.panel, place_panel(input.head, 1));
}

TEST_F(PanelInVisit, MenuPutsItAwayAndFetchesItOnTheHandsSide) {
  press_menu(1);
  EXPECT_FALSE(visit.panel);
  EXPECT_EQ(visit.stage.magnification, usual_magnification);  // a press is not a hold
  for (const std::size_t hand : {0u, 1u}) {
    press_menu(hand);
    ASSERT_TRUE(visit.panel);
    EXPECT_EQ(*visit.panel, place_panel(input.head, hand == 0 ? -1 : 1));
    // Out of sight it is fetched rather than put away.
    input.head.turn = glm::angleAxis(2.5, glm::dvec3(0, 1, 0)) * input.head.turn;
    press_menu(hand);
    ASSERT_TRUE(visit.panel);
    EXPECT_TRUE(within_sight(*visit.panel, input.head));
    press_menu(hand);
    EXPECT_FALSE(visit.panel);
  }
}

TEST_F(PanelInVisit, HeldMenuDoesNotAlsoMoveThePanel) {
  const auto panel = visit.panel;
  input.hands[0].menu = true;
  seconds(rules.menu_seconds + 0.2);
  input.hands[0].menu = false;
  step(2);
  EXPECT_EQ(visit.stage.magnification, 1);
  EXPECT_EQ(visit.panel, panel);
}

TEST_F(PanelInVisit, ARayOnItIsItsMouseAndMeetsNothingElse) {
  // Before the tooth, so that the ray would go on to the pulp.
  const glm::dvec3 centre = to_room(visit.stage, balls.model.bounds_mm.centre()),
                   hand = input.head.position + glm::dvec3(0.2, -0.35, 0);
  const RoomPanel panel{{0.5 * (hand + centre), {1, 0, 0, 0}}};
  visit.panel.reset();
  input.hands[1] = pointing_at(centre, hand);
  step();
  ASSERT_TRUE(visit.hands.pointed[1]);
  EXPECT_EQ(visit.hands.pointed[1]->structure, "pulp");
  visit.panel = panel;
  point(1, {0.5, 0.5});
  ASSERT_TRUE(visit.hands.on_panel[1]);
  EXPECT_LT(glm::length(visit.hands.on_panel[1]->at - glm::dvec2(0.5, 0.5)), 1e-9);
  EXPECT_FALSE(visit.hands.pointed[1]);
  EXPECT_EQ(panel_hand(visit), 1u);
  input.hands[1].trigger = 1;
  seconds(1);
  EXPECT_FALSE(visit.cavity);
  EXPECT_TRUE(visit.hands.pressing[1]);
  EXPECT_FALSE(visit.marks.named);
  // What began on it ends on it: a slider goes on beside the panel, and nothing behind it is meant.
  point(1, {1.3, 0.4});
  ASSERT_TRUE(visit.hands.on_panel[1]);
  EXPECT_TRUE(visit.hands.pressing[1]);
  input.hands[1].trigger = 0;
  step();
  EXPECT_FALSE(visit.hands.on_panel[1]);
  // A trigger that is pulled elsewhere and led over the panel presses nothing there.
  input.hands[1].trigger = 1;
  step();
  point(1, {0.5, 0.5});
  EXPECT_TRUE(visit.hands.on_panel[1]);
  EXPECT_FALSE(visit.hands.pressing[1]);
}

TEST_F(PanelInVisit, ThePressingHandIsTheMouse) {
  point(1, {0.2, 0.2});
  point(0, {0.8, 0.8});
  EXPECT_EQ(panel_hand(visit), 1u);
  input.hands[0].trigger = 1;
  step();
  EXPECT_EQ(panel_hand(visit), 0u);
  visit.panel.reset();
  step();
  EXPECT_FALSE(panel_hand(visit));
}

TEST_F(PanelInVisit, AGrabOnItCarriesItAndNotTheTooth) {
  const Stage stage = visit.stage;
  const RoomPanel panel = *visit.panel;
  point(1, {0.5, 0.5});
  input.hands[1].grab = 1;
  step();
  EXPECT_EQ(visit.hands.held[1], Visit::Held::panel);
  input.hands[1].grip.position += glm::dvec3(0.1, 0.2, 0);
  input.hands[1].aim.position += glm::dvec3(0.1, 0.2, 0);
  step();
  EXPECT_LT(glm::length(visit.panel->pose.position - panel.pose.position - glm::dvec3(0.1, 0.2, 0)), 1e-12);
  input.hands[1].grab = 0;
  step();
  EXPECT_EQ(visit.hands.held[1], Visit::Held::nothing);
  input.hands[1].grip.position += glm::dvec3(0.1, 0.2, 0);
  step();
  EXPECT_LT(glm::length(visit.panel->pose.position - panel.pose.position - glm::dvec3(0.1, 0.2, 0)), 1e-12);
  EXPECT_EQ(visit.stage, stage);
}

TEST_F(PanelInVisit, InsideItIsBeforeTheWallAndATriggerOnItDoesNotGlide) {
  enter();
  // As near to the wall as one can get, looking at it.
  input.hands[1] = pointing_at(input.head.position + input.head.ahead(), input.head.position);
  input.hands[1].trigger = 1;
  seconds(6);
  input.hands[1] = person().hands[1];
  seconds(1);
  press_menu(1);
  press_menu(1);
  ASSERT_TRUE(visit.panel);
  const double distance = glm::length(visit.panel->pose.position - input.head.position);
  EXPECT_LT(distance, panel_distance - 0.05) << "there is no room for it";
  EXPECT_GE(distance, least_panel_distance - 1e-12);
  point(1, {0.5, 0.5});
  const glm::dvec3 eye = visit.eye_mm;
  input.hands[1].trigger = 1;
  seconds(1);
  EXPECT_TRUE(visit.hands.pressing[1]);
  EXPECT_LT(glm::length(visit.eye_mm - eye), 1e-6);
}

TEST_F(PanelInVisit, AStickOverItScrollsItAndLeavesTheToothAlone) {
  point(1, {0.5, 0.5});
  const Stage stage = visit.stage;
  input.hands[1].stick = {1, 1};
  step(20);
  EXPECT_EQ(visit.stage, stage);
}

TEST_F(PanelInVisit, ActionsAreDoneOnce) {
  visit.pending_actions = {VisitAction::toggle_section};
  step(2);
  ASSERT_TRUE(visit.scene.section);
  EXPECT_EQ(visit.scene.section->normal, AnatomicalFrame{}.buccal);
  visit.pending_actions = {VisitAction::flip_section};
  step(2);
  EXPECT_EQ(visit.scene.section->normal, -AnatomicalFrame{}.buccal);
  visit.pending_actions = {VisitAction::toggle_section};
  step();
  EXPECT_FALSE(visit.scene.section);
  visit.pending_actions = {VisitAction::toggle_section};
  step();
  EXPECT_EQ(visit.scene.section->normal, -AnatomicalFrame{}.buccal) << "off and on again changes nothing";
  visit.pending_actions = {VisitAction::change_size};
  step();
  EXPECT_EQ(visit.stage.magnification, 1);
  enter();
  visit.pending_actions = {VisitAction::change_size};
  const double inside = visit.stage.magnification;
  step();
  EXPECT_EQ(visit.stage.magnification, inside);
  visit.pending_actions = {VisitAction::leave};
  seconds(2.2 * rules.fade_seconds);
  EXPECT_FALSE(visit.cavity);
  visit.pending_actions = {VisitAction::put_panel_away, VisitAction::leave_headset};
  step();
  EXPECT_FALSE(visit.panel);
  EXPECT_TRUE(visit.leaving);
}

TEST_F(PanelInVisit, WithOneButtonTheTriggerPressesOnItAndGrabsBesideIt) {
  input.hands[1].can_grab = false;
  point(1, {0.5, 0.5});
  input.hands[1].can_grab = false;
  input.hands[1].trigger = 1;
  step(2);
  EXPECT_TRUE(visit.hands.pressing[1]);
  EXPECT_EQ(visit.hands.held[1], Visit::Held::nothing);
}

}  // namespace
}  // namespace odontoscope::testing_support
