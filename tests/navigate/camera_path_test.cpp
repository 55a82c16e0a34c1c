// A tour as keys of a camera: what a player sees between them is what the tour has there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "engine/navigate/tour_camera_path.h"
#include "recon/cavity/centre_lines.h"
#include "tests/navigate/cavities.h"

namespace odontoscope {
namespace {

glm::dvec3 vector(const Direction& d) { return {d.x, d.y, d.z}; }
glm::dvec3 vector(const Point3& p) { return {p.x, p.y, p.z}; }

glm::dquat turn(const CameraKey& key) {
  return glm::quat_cast(
      glm::dmat3(glm::cross(vector(key.view_direction), vector(key.up)), vector(key.up), -vector(key.view_direction)));
}

/// As a player of glTF's LINEAR has it.
struct Played {
  glm::dvec3 at, view_direction, up;
};
Played played(const CameraPath& path, double seconds) {
  std::size_t i = 0;
  while (i + 2 < path.keys.size() && path.keys[i + 1].seconds <= seconds) ++i;
  const CameraKey &a = path.keys[i], &b = path.keys[i + 1];
  const double share = (seconds - a.seconds) / (b.seconds - a.seconds);
  const glm::dquat between = glm::slerp(turn(a), turn(b), share);
  return {glm::mix(vector(a.at), vector(b.at), share), between * glm::dvec3(0, 0, -1), between * glm::dvec3(0, 1, 0)};
}

struct Errors {
  double place = 0;     // shares of the clearance
  double view_deg = 0;  // of the line of sight and of up
  double near = 1e9;    // least of what is left between the near plane and the tour's own
};
Errors errors(const Tour& tour) {
  const CameraPath path = camera_path(tour, "canal", 30);
  Errors most;
  const auto apart = [](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
  };
  for (double t = 0; t <= tour.seconds(); t += 0.0137) {
    const TourInstant wanted = tour.at(t);
    const Played now = played(path, t);
    most.place = std::max(most.place, glm::length(now.at - wanted.camera.position) / wanted.clearance);
    most.view_deg = std::max({most.view_deg, apart(now.view_direction, wanted.camera.target - wanted.camera.position),
                              apart(now.up, wanted.camera.up)});
    most.near = std::min(most.near, wanted.camera.near_mm - path.near_mm);
  }
  return most;
}

void expect_bounds(const Tour& tour, const std::string& what) {
  const Errors most = errors(tour);
  EXPECT_LT(most.place, 0.01) << what;
  EXPECT_LT(most.view_deg, 0.2) << what;
  EXPECT_GT(most.near, -1e-4) << what;  // lower by a little between keys
}

TEST(CameraPath, FollowsTheToursOfTheMolars) {
  for (const SurfaceMesh* pulp : {&test::sample_molar_pulp(), test::ct_molar_pulp()}) {
    if (!pulp) continue;
    const CentreLines lines = centre_lines({"pulp", *pulp, 1});
    ASSERT_EQ(lines.canals.size(), 3u);
    for (const CentreLine& canal : lines.canals) {
      expect_bounds(Tour(canal), canal.name);
      expect_bounds(Tour(canal, {.back = true}), canal.name + " back");
    }
  }
}

TEST(CameraPath, BeginsAndEndsAsTheTourDoes) {
  CentreLine line;
  for (int i = 0; i <= 40; ++i) line.points.push_back({{0, 0, -0.1 * i}, 0.4, 0.1 * i});
  const Tour tour(line);
  const CameraPath path = camera_path(tour, "canal 1", 25);
  EXPECT_EQ(path.name, "canal 1");
  EXPECT_EQ(path.far_mm, 25);
  EXPECT_EQ(path.field_of_view_deg, 80);
  EXPECT_EQ(path.keys.front().seconds, 0);
  EXPECT_EQ(path.keys.back().seconds, tour.seconds());
  EXPECT_EQ(vector(path.keys.back().at), tour.at(tour.seconds()).camera.position);
  for (std::size_t i = 1; i < path.keys.size(); ++i) EXPECT_GT(path.keys[i].seconds, path.keys[i - 1].seconds);
  EXPECT_NEAR(path.keys[1].seconds, 1 / camera_keys_per_second, 0.01);
}

}  // namespace
}  // namespace odontoscope
