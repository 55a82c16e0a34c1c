// Rides along canals in the viewer, and where one is told to be.

#include "engine/navigate/screen.h"
#include "engine/viewer/fly/fly_annotations.h"
#include "engine/viewer/look/annotations.h"
#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

TEST_F(FlightTest, ARideLeadsAlongACanalAndStopsAtItsEnd) {
  viewer_with(sample_tooth_loaded());
  type(U'c');
  fade();
  type(U'1');
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_TRUE(fly().ride->playing);
  const FlightSpace& pulp = spaces().cavities.at(0);
  EXPECT_NE(where_in_words(mode<FlyMode>().state(), viewer().state()).find("pulp chamber"), std::string::npos);
  press_key(Key::space);
  EXPECT_FALSE(fly().ride->playing);
  frames(90);
  const double stopped = fly().ride->along;
  frames(5);
  EXPECT_EQ(fly().ride->along, stopped);
  EXPECT_GT(viewer().wait_timeout(), 0.1) << "nothing moves, so nothing is drawn";
  press_key(Key::end);
  EXPECT_EQ(fly().ride->along, fly().ride->track.points.back().along);
  EXPECT_GE(pulp.walls.nearest(fly().flight.eye).distance, spaces().rules.clearance);
  ASSERT_TRUE(fly().place);
  EXPECT_GT(fly().place->depth, 0);
  EXPECT_NE(measured_in_words(mode<FlyMode>().state(), viewer().state()).find("to the apex"), std::string::npos);
  type(U'r');
  frames(40);
  EXPECT_LT(fly().ride->along, fly().ride->track.points.back().along);
  hold('w', 0.1);  // flying ends the ride where it is
  EXPECT_FALSE(fly().ride);
  EXPECT_EQ(pulp.walls.locate(fly().flight.eye), Walls::Side::inside);
  type(U'9');
  EXPECT_FALSE(fly().ride) << "there are not so many";
}

TEST_F(FlightTest, ReducedMotionLeavesTheRideToThePerson) {
  viewer_with(sample_tooth_loaded(), {.settings = {.comfort = {.reduced_motion = true}}});
  type(U'c');
  fade();
  type(U't');
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_FALSE(fly().ride->playing);
  const double start = fly().ride->along;
  type(U'.');
  EXPECT_GT(fly().ride->along, start);
}

TEST_F(FlightTest, AClickOnACanalsNameBeginsTheRide) {
  viewer_with(sample_tooth_loaded());
  size_ = {960, 640};
  type(U'c');
  fade();
  const FlightSpace& pulp = spaces().cavities.at(0);
  const FlightLabel* orifice = nullptr;
  for (const FlightLabel& label : fly().labels)
    if (label.line == 1u && label.words.find("apex") == std::string::npos) orifice = &label;
  ASSERT_NE(orifice, nullptr);
  const Track track = track_of(*rideable(pulp.lines)[1], spaces().rules.clearance);
  fly().flight = flight_on(track, track.orifice - 2 * place_on(track, track.orifice).radius);
  frames(3);
  const auto seen = seen_labels(fly().labels, viewer().state().scene.camera, viewer().panes().front().area.aspect(),
                                pulp.walls, 3 * spaces().rules.clearance);
  ASSERT_FALSE(seen.empty());
  for (const SeenLabel& label : seen) {
    if (&fly().labels[label.label] != orifice) continue;
    const glm::dvec2 pixel = pixel_of(viewer().panes().front().area, label.place);
    click(pixel.x + 20, pixel.y);
    fade();
    if (!fly().ride) click(pixel.x - 20, pixel.y);  // to the left where the compass is to the right
  }
  fade();
  ASSERT_TRUE(fly().ride);
  EXPECT_EQ(fly().ride->line, 1u);
}

}  // namespace
}  // namespace odontoscope::testing_support
