// How thick walls are, against tubes and boxes whose walls are known.

#include "engine/navigate/thickness_colours.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>
#include <regex>
#include <sstream>

#include "engine/navigate/wall_depth.h"
#include "engine/scene/wall_colours.h"
#include "tests/render/shapes.h"

namespace odontoscope::test {
namespace {

using testing_support::ball;
using testing_support::box;
using testing_support::reversed;

struct Tube {
  double x = 0, radius = 1, low = 0, high = 10;
  int around = 240, rings = 40;
};

/// Closed by flat ends, its sides along z.
SurfaceMesh tube(const Tube& t) {
  SurfaceMesh mesh;
  const auto at = [&](int ring, int i) {
    return static_cast<PointIndex>(2 + ring * t.around + (i + t.around) % t.around);
  };
  mesh.points = {{t.x, 0, t.low}, {t.x, 0, t.high}};
  for (int ring = 0; ring <= t.rings; ++ring)
    for (int i = 0; i < t.around; ++i) {
      const double angle = 2 * std::numbers::pi * i / t.around;
      mesh.points.push_back(
          {t.x + t.radius * std::cos(angle), t.radius * std::sin(angle), t.low + (t.high - t.low) * ring / t.rings});
    }
  for (int i = 0; i < t.around; ++i) {
    mesh.triangles.push_back({0, at(0, i + 1), at(0, i)});
    mesh.triangles.push_back({1, at(t.rings, i), at(t.rings, i + 1)});
    for (int ring = 0; ring < t.rings; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  return mesh;
}

constexpr Tube outer{0, 2, 0, 20}, canal{0.6, 0.5, 4, 16};  // 0.9 mm of wall at the one side, 1.9 at the other

/// A canal that runs beside the middle of its root, and a pulp in it.
std::vector<NamedSurface> root() {
  return {{"dentine", tube(outer)}, {"dentine cavity", reversed(tube(canal)), "dentine", true}, {"pulp", tube(canal)}};
}

/// What the wall of the root is there: to the outer tube's side or its ends.
double truth(const glm::dvec3& place) {
  return std::min({outer.radius - std::hypot(place.x, place.y), place.z - outer.low, outer.high - place.z});
}

glm::dvec3 place_of(const Model& model, const glm::vec3& position) {
  return model.origin_mm + glm::dvec3(position) / metres_per_mm;
}

/// The outer tube's sides are flat between corners.
constexpr double flat = 2 * (1 - 0.999914) + 1e-4;  // radius times 1 - cos(pi / around)

TEST(WallThicknesses, OfATubeAreWhatItsRadiiSay) {
  Model model = make_model(root());
  mark_wall_thicknesses(model);
  EXPECT_TRUE(tells_thickness(model));
  EXPECT_TRUE(model.parts[0].thicknesses_mm.empty()) << "the outside has no thickness of its own";
  for (const std::size_t walled : {std::size_t{1}, std::size_t{2}}) {  // the cavity's wall, and the pulp that fills it
    const ModelPart& part = model.parts[walled];
    ASSERT_EQ(part.thicknesses_mm.size(), part.positions.size());
    double least = 9, most = 0;
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
      const auto mm = static_cast<double>(part.thicknesses_mm[i]);
      ASSERT_NEAR(mm, truth(place_of(model, part.positions[i])), flat);
      least = std::min(least, mm);
      most = std::max(most, mm);
    }
    EXPECT_NEAR(least, 0.9, flat);
    EXPECT_NEAR(most, 1.9, flat);
  }
}

TEST(WallThicknesses, AreTheSameOnAnyNumberOfThreads) {
  Model one = make_model(root()), four = one;
  tbb::task_arena(1).execute([&] { mark_wall_thicknesses(one); });
  tbb::task_arena(4).execute([&] { mark_wall_thicknesses(four); });
  EXPECT_EQ(one.parts[1].thicknesses_mm, four.parts[1].thicknesses_mm);
}

TEST(WallThicknesses, OfABoxAreExact) {
  Model model =
      make_model({{"s", box({0, 0, 0}, {10, 12, 14})}, {"s cavity", reversed(box({1, 3, 2}, {6, 8, 9})), "s", true}});
  mark_wall_thicknesses(model);
  const ModelPart& part = model.parts[1];
  ASSERT_FALSE(part.thicknesses_mm.empty());
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    const glm::dvec3 p = place_of(model, part.positions[i]);
    const double expected = std::min({p.x, p.y, p.z, 10 - p.x, 12 - p.y, 14 - p.z});
    EXPECT_NEAR(part.thicknesses_mm[i], expected, 1e-5);
  }
}

TEST(WallThicknesses, OfWhatHasNoCavityAreUnknown) {
  Model model = make_model({{"dentine", ball({{0, 0, 0}, 5})}, {"pulp", ball({{0, 0, 0}, 2})}});
  mark_wall_thicknesses(model);
  EXPECT_FALSE(tells_thickness(model));
}

TEST(WallThicknesses, TellHowFarTheyAreAndStop) {
  std::stop_source stop;
  double last = 0;
  Model model = make_model(root());
  mark_wall_thicknesses(model, Progress{[&](std::string_view stage, double part) {
                                          EXPECT_EQ(stage, "wall thickness");
                                          last = part;
                                        },
                                        stop.get_token()});
  EXPECT_EQ(last, 1);
  stop.request_stop();
  EXPECT_THROW(mark_wall_thicknesses(model, Progress{{}, stop.get_token()}), Cancelled);
}

TEST(WallThicknesses, StandWhereTheWallIsThinnest) {
  const std::vector<NamedSurface> surfaces = root();
  Model model = make_model(surfaces);
  FlightSpaces spaces = flight_spaces(surfaces, model);
  ASSERT_EQ(spaces.cavities.size(), 1u);
  mark_wall_depths(model, spaces);
  mark_wall_thicknesses(model, spaces);
  const auto labels = thickness_labels(spaces.cavities[0]);
  ASSERT_GE(labels.size(), 8u);  // 12 mm, and none at its ends
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const ThinPlace& place = spaces.cavities[0].thin_places[i];
    EXPECT_NEAR(place.mm, 0.9, 0.02);
    EXPECT_NEAR(place.at.x, 1.1, 0.02) << "towards the root's side that is near";
    EXPECT_EQ(labels[i].number, WallNumber::thickness);
    EXPECT_EQ(labels[i].words.substr(0, 2), "0.");
  }
}

std::vector<double> numbers_of(const std::string& text, const std::string& name) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(name + R"( = vec3\(([0-9.]+), ([0-9.]+), ([0-9.]+)\))"))) return {};
  return {std::stod(found[1]), std::stod(found[2]), std::stod(found[3])};
}

TEST(WallColours, OfLegendsAreTheShaders) {
  std::ifstream file(std::string(ODONTOSCOPE_SHADERS) + "/wall_depth.glsl");
  std::stringstream text;
  text << file.rdbuf();
  // 1500 pixels, 100 a step: in the middle between two lines nothing but hue is seen.
  const Colour own{1, 1, 1};
  const std::vector<ShownColour> bar = thickness_bar(own, 1500);
  const auto at = [&](double steps) { return bar[static_cast<std::size_t>(std::lround(100 * (15 - steps))) - 1]; };
  const auto mixed = [&](const std::string& from, double more, const std::string& to) {
    const std::vector<double> a = numbers_of(text.str(), from), b = numbers_of(text.str(), to);
    glm::vec3 light(0);
    for (int channel = 0; channel < 3; ++channel) {
      const auto c = static_cast<std::size_t>(channel);
      light[channel] = static_cast<float>(0.2 + 0.8 * (a.at(c) + more * (b.at(c) - a.at(c))));
    }
    return encoded(light);
  };
  for (const auto& [steps, colour] : {std::pair{6.5, mixed("depth_amber", 0.5, "depth_teal")},
                                      {11.5, mixed("depth_teal", 0.5, "depth_blue")},
                                      {14.5, mixed("depth_blue", 0, "depth_blue")}}) {
    EXPECT_NEAR(at(steps)[0], 255 * colour.red, 2) << steps;
    EXPECT_NEAR(at(steps)[1], 255 * colour.green, 2) << steps;
    EXPECT_NEAR(at(steps)[2], 255 * colour.blue, 2) << steps;
  }
}

}  // namespace
}  // namespace odontoscope::test
