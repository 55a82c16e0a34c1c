// Led along a canal by script: how fast, how near to walls, and that nothing but the head turns the view.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>

#include "engine/headset/billboards.h"
#include "engine/navigate/labels.h"
#include "tests/headset/visiting.h"

namespace odontoscope::testing_support {
namespace {

class HeadsetTour : public VisitingMolar {
 protected:
  void SetUp() override {
    ASSERT_GE(cavity.lines.canals.size(), 2u);
    input.hands = {};  // nothing to point with: picking takes longer than all the rest
    step();
  }
  void begin(std::size_t line) {
    visit.tour.asked = line;
    step(static_cast<int>(std::ceil(rules.fade_seconds / tick)) + 2);
    ASSERT_TRUE(visit.tour.ride);
    ASSERT_EQ(visit.tour.ride->line, line);
  }
  void pull(std::size_t hand = 1) {
    input.hands[hand].tracked = true;
    input.hands[hand].aim.turn = glm::angleAxis(1.5, glm::dvec3(0, 1, 0));
    step();
    input.hands[hand].trigger = 1;
    step();
    input.hands[hand] = {};
    step();
  }
  double pace() const { return glm::length(visit.velocity) / mm_per_metre(visit.stage); }
};

TEST_F(HeadsetTour, LeadsToTheCanalsEndWithoutTurningTheView) {
  input.head.turn = glm::angleAxis(0.8, glm::dvec3(0, 1, 0)) * glm::angleAxis(-0.4, glm::dvec3(1, 0, 0));
  for (std::size_t line = 0; line < cavity.lines.canals.size(); ++line) {
    begin(line);
    const Track& track = visit.tour.ride->track;
    // Laid so that it leads ahead and somewhat down.
    const glm::dvec3 ahead = glm::normalize(visit.stage.turn * (track.points.back().at - track.points.front().at));
    const glm::dvec3 level = heading_of(input.head) * glm::dvec3(0, 0, -1);
    EXPECT_NEAR(glm::degrees(std::asin(-ahead.y)), rules.tour_down_deg, 1e-6);
    EXPECT_NEAR(glm::dot(glm::normalize(glm::dvec3(ahead.x, 0, ahead.z)), level), 1, 1e-9);
    const glm::dquat turn = visit.stage.turn;
    const double magnification = visit.stage.magnification;
    double fastest = 0, least_wall = 1e9, farthest_off = 0;
    int frames = 0;
    for (; visit.tour.ride->playing && frames < 90 * 120; ++frames) {
      step();
      fastest = std::max(fastest, pace());
      least_wall = std::min(least_wall, wall_metres());
      farthest_off = std::max(farthest_off, glm::length(to_room(visit.stage, visit.eye_mm) - input.head.position));
      ASSERT_EQ(visit.stage.turn, turn);
      ASSERT_EQ(visit.stage.magnification, magnification);
    }
    EXPECT_FALSE(visit.tour.ride->playing) << "it never arrives";
    EXPECT_LE(fastest, rules.most_speed * 1.001);
    EXPECT_GT(fastest, 0.2);
    EXPECT_GE(least_wall, rules.clearance);
    EXPECT_LT(farthest_off, 1e-9);
    EXPECT_NEAR(visit.tour.ride->along, visit.tour.ride->track.points.back().along, 1e-9);
    // Nearly all of the canal: what is left out is narrower than the head's ball there.
    EXPECT_GT(visit.tour.ride->along, 0.8 * cavity.lines.canals[line].points.back().along);
    std::printf(
        "measured: canal %zu, %.1f mm in %.0f s, at most %.2f m/s, walls at least %.2f m off, %.0f times enlarged\n",
        line + 1, visit.tour.ride->along, frames * tick, fastest, least_wall, magnification);
    EXPECT_LT(visit.seen.vignette, 1);
  }
}

TEST_F(HeadsetTour, ATriggerStopsItAndGoesOnAndAtTheEndLeadsBack) {
  begin(0);
  step(200);
  EXPECT_GT(visit.seen.vignette, 0.02);
  pull();
  EXPECT_FALSE(visit.tour.ride->playing);
  step(90);
  EXPECT_LT(pace(), 1e-3);
  const double along = visit.tour.ride->along;
  step(30);
  EXPECT_NEAR(visit.tour.ride->along, along, 1e-4);
  pull(0);  // either hand
  EXPECT_TRUE(visit.tour.ride->playing);
  step(90);
  EXPECT_GT(visit.tour.ride->along, along + 0.01);
  visit.tour.ride->along = visit.tour.ride->track.points.back().along;
  step(2);
  ASSERT_FALSE(visit.tour.ride->playing);
  pull();
  const double end = visit.tour.ride->along;
  step(90);
  EXPECT_LT(visit.tour.ride->along, end);
  // A stick says which way.
  input.hands[0].tracked = true;
  input.hands[0].stick = {0, 1};
  step(90);
  EXPECT_FALSE(visit.tour.ride->back);
}

TEST_F(HeadsetTour, TheHeadLeansAsInAnyRoomAndNotThroughTheWall) {
  begin(0);
  step(300);
  pull();
  step(200);
  const Stage stage = visit.stage;
  input.head.position += glm::dvec3(0.03, 0.02, -0.03);
  input.head.turn = glm::angleAxis(0.5, glm::dvec3(0, 1, 0));
  step();
  EXPECT_LT(glm::length(visit.stage.place - stage.place), 1e-5) << "the world moved with the head";
  EXPECT_LT(glm::length(to_room(visit.stage, visit.eye_mm) - input.head.position), 1e-9);
  input.head.position += glm::dvec3(5, 0, 0);
  step();
  EXPECT_EQ(cavity.walls.locate(visit.eye_mm), Walls::Side::inside);
  EXPECT_GE(wall_metres(), rules.clearance);
  pull();
  for (int i = 0; i < 600; ++i) {
    step();
    ASSERT_GE(wall_metres(), rules.clearance);
  }
}

TEST_F(HeadsetTour, ComesAsFarAtAnyFrameRate) {
  begin(1);
  Visit slow = visit;
  step(200, tick);
  const double fast = visit.tour.ride->along;
  visit = slow;
  step(50, 4 * tick);
  EXPECT_NEAR(visit.tour.ride->along, fast, 0.01 * fast);
}

TEST_F(HeadsetTour, OneCanGlideOnFromItTakeAnotherAndGoOut) {
  const Stage outside = visit.stage;
  begin(0);
  step(200);
  visit.pending_actions = {VisitAction::end_tour};
  step();
  EXPECT_FALSE(visit.tour.ride);
  const glm::dvec3 eye = visit.eye_mm;
  input.hands[0].tracked = true;
  input.hands[0].stick = {0, 1};
  for (int i = 0; i < 200; ++i) {
    step();
    ASSERT_GE(wall_metres(), rules.clearance * (1 - 1e-6));
  }
  EXPECT_GT(glm::length(visit.eye_mm - eye), 0.01);
  input.hands[0] = {};
  begin(1);
  visit.pending_actions = {VisitAction::leave};
  step(80);
  EXPECT_FALSE(visit.cavity);
  EXPECT_FALSE(visit.tour.ride);
  EXPECT_EQ(visit.stage, outside);
  visit.tour.asked = 999;  // nothing to be led along: inside all the same, and no crash
  step(80);
  EXPECT_FALSE(visit.tour.ride);
}

TEST_F(HeadsetTour, NamesOfCanalsAreSeenButNotThroughWalls) {
  visit.pending_actions = {VisitAction::enter};
  step(80);
  ASSERT_TRUE(visit.cavity);
  const std::vector<FlightLabel> labels = labels_inside(cavity);
  ASSERT_GT(labels.size(), 4u);
  const auto written = [&] {
    std::set<std::string> words;
    for (const Billboard& billboard : billboards(visit, input, world)) words.insert(billboard.words);
    return words;
  };
  visit.chosen.on_wall = WallNumber::none;
  const auto in_chamber = written();
  EXPECT_FALSE(in_chamber.empty());
  EXPECT_LT(in_chamber.size(), labels.size());
  for (const FlightLabel& label : labels) {
    const glm::dvec3 way = label.at - visit.eye_mm;
    if (!in_chamber.contains(label.words)) continue;
    EXPECT_GT(cavity.walls.free_distance(visit.eye_mm, glm::normalize(way)),
              glm::length(way) - 0.31 * mm_per_metre(visit.stage))
        << label.words;
  }
  visit.chosen.labels = false;
  EXPECT_TRUE(written().empty());
  visit.chosen.on_wall = WallNumber::depth;
  for (const std::string& words : written()) EXPECT_TRUE(words.ends_with(" mm")) << words;
  EXPECT_TRUE(scene_of(visit, world).wall_depth);
  visit.chosen.on_wall = WallNumber::thickness;
  EXPECT_TRUE(scene_of(visit, world).wall_thickness);
  EXPECT_FALSE(scene_of(visit, world).wall_depth);
  visit.cavity.reset();
  EXPECT_FALSE(scene_of(visit, world).wall_thickness) << "outside the panel has a switch of its own";
  visit.cavity = 0;
  visit.chosen.on_wall = WallNumber::none;
  visit.chosen.labels = true;
  // In one canal, far from the chamber, another one's names are gone.
  begin(0);
  visit.tour.ride->along = visit.tour.ride->track.points.back().along;
  step(2);
  for (const std::string& words : written())
    EXPECT_EQ(words.find(cavity.lines.canals[1].name), std::string::npos) << words;
}

}  // namespace
}  // namespace odontoscope::testing_support
