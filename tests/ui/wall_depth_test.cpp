// A canal's wall tells how deep one is.

#include "engine/navigate/wall_depth.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "engine/picture/image_difference.h"
#include "tests/ui/flight_fixture.h"

namespace odontoscope::testing_support {
namespace {

/// A straight tube down the z axis, and its line, the orifice `orifice` mm from the top.
CentreLines straight_line(double length, double orifice, double step) {
  CentreLines lines;
  CentreLine& canal = lines.canals.emplace_back();
  canal.name = "canal 1";
  for (double along = 0; along < length - 0.1; along += step) canal.points.push_back({{0, 0, -along}, 0.5, along, 0.5});
  canal.orifice = static_cast<std::size_t>(std::lround(orifice / step));
  canal.end = {0, 0, -length};
  return lines;
}

Model tube(double length) {
  Model model;
  ModelPart& part = model.parts.emplace_back();
  part.structure = part.solid = "pulp";
  for (int ring = 0; ring <= 200; ++ring)
    for (int around = 0; around < 24; ++around) {
      const double angle = glm::two_pi<double>() * around / 24;
      part.positions.push_back(
          glm::vec3(metres_per_mm * glm::dvec3(0.5 * std::cos(angle), 0.5 * std::sin(angle), -length * ring / 200)));
    }
  return model;
}

TEST(WallDepth, IsTheLengthBelowTheOrifice) {
  const CentreLines lines = straight_line(16, 3, 0.1);
  Model model = tube(16);
  const std::string pulp = "pulp";
  mark_wall_depths(model, {{&pulp, &lines}});
  const ModelPart& part = model.parts[0];
  ASSERT_EQ(part.depths_mm.size(), part.positions.size());
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    const double below = -part.positions[i].z / metres_per_mm - 3;
    EXPECT_NEAR(part.depths_mm[i], std::max(below, -1.0), 1e-4);
  }
  EXPECT_EQ(model.depth_step_mm, 1);
}

TEST(WallDepth, LeavesHornsAndOtherStructuresAlone) {
  CentreLines lines = straight_line(16, 3, 0.1);
  lines.horns.push_back(lines.canals[0]);
  lines.canals.clear();
  lines.horns[0].orifice = 0;
  Model model = tube(16);
  const std::string pulp = "pulp", other = "dentine";
  mark_wall_depths(model, {{&other, &lines}});
  EXPECT_TRUE(model.parts[0].depths_mm.empty());
  mark_wall_depths(model, {{&pulp, &lines}});
  for (const float depth : model.parts[0].depths_mm) EXPECT_EQ(depth, above_orifice);
}

TEST(WallDepth, OfATubeWithoutAChamberCountsFromItsBeginning) {
  CentreLines lines = straight_line(16, 0, 0.1);
  lines.has_chamber = false;
  Model model = tube(16);
  const std::string pulp = "pulp";
  mark_wall_depths(model, {{&pulp, &lines}});
  for (std::size_t i = 0; i < model.parts[0].positions.size(); ++i)
    EXPECT_NEAR(model.parts[0].depths_mm[i], -model.parts[0].positions[i].z / metres_per_mm, 1e-4);
}

TEST(WallDepth, HasFewRingsHoweverLargeTheNumbers) {
  EXPECT_EQ(depth_step_mm(14), 1);
  EXPECT_EQ(depth_step_mm(25), 1);
  EXPECT_EQ(depth_step_mm(58), 5);
  EXPECT_EQ(depth_step_mm(200), 10);
  EXPECT_EQ(depth_step_mm(700), 50);
  EXPECT_LT(depth_step_mm(1e300), 1e8);
}

class DepthInFlight : public FlightTest {};

TEST_F(DepthInFlight, IsSeenAndCanBeSwitchedOff) {
  viewer_with(sample_tooth_loaded());
  type(U'1');  // outside: a view
  type(U'c');
  fade();
  type(U'1');
  fade();
  press_key(Key::space);
  fly().ride->along = 0.5 * fly().ride->track.points.back().along;
  frames(40, 0.05);  // until it has come to rest
  ASSERT_TRUE(viewer().state().scene.wall_depth);
  const Image with = picture();
  keep_picture("wall-depth");
  type(U'g');
  frames(3, 1e-6);
  ASSERT_TRUE(viewer().state().scene.wall_thickness);
  const Image thickness = picture();
  keep_picture("wall-thickness");
  EXPECT_FALSE(compare(with, thickness, {4, 0.3}).within_tolerance);
  type(U'g');
  frames(3, 1e-6);
  EXPECT_FALSE(viewer().state().scene.wall_depth);
  EXPECT_FALSE(viewer().state().scene.wall_thickness);
  EXPECT_FALSE(compare(with, picture(), {4, 0.3}).within_tolerance);
  EXPECT_FALSE(compare(thickness, picture(), {4, 0.3}).within_tolerance);
  type(U'g');
  frames(3, 1e-6);
  EXPECT_TRUE(compare(with, picture(), {4, 0.02}).within_tolerance);
  type(U'c');
  fade();
  EXPECT_FALSE(viewer().state().scene.wall_depth) << "outside nothing is coloured";
}

TEST_F(DepthInFlight, ThicknessIsSeenFromOutsideToo) {
  viewer_with(sample_tooth_loaded());
  viewer().state().scene.look_of("enamel")->visible = false;
  viewer().state().scene.look_of("dentine")->visible = false;
  frames(3, 1e-6);
  const Image before = picture();
  type(U'i');
  frames(3, 1e-6);
  EXPECT_TRUE(viewer().state().scene.wall_thickness);
  EXPECT_FALSE(compare(before, picture(), {4, 0.02}).within_tolerance);
  keep_picture("wall-thickness-outside");
  type(U'i');
  frames(3, 1e-6);
  EXPECT_TRUE(compare(before, picture(), {4, 0.001}).within_tolerance);
}

TEST_F(DepthInFlight, OfWhatHasNoOutsideTheViewerSaysSo) {
  viewer_with(toy_tooth());
  type(U'i');
  frames(1, 1e-6);
  EXPECT_FALSE(viewer().state().scene.wall_thickness);
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("no thickness"), std::string::npos);
}

TEST_F(DepthInFlight, NumbersLieOnTheWallAtTheirDepth) {
  viewer_with(sample_tooth_loaded());
  const FlightSpace& space = spaces().cavities[0];
  const auto labels = depth_labels(space, 1);
  EXPECT_GE(labels.size(), 30u);  // three canals of 12 to 14 mm
  for (const FlightLabel& label : labels) {
    EXPECT_LT(space.walls.nearest(label.at).distance, 1e-6) << label.words;
    EXPECT_EQ(label.number, WallNumber::depth);
    EXPECT_FALSE(label.line);
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
