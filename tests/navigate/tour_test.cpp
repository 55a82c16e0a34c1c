// Tours: constant apparent speed, bounded turns and jerk, no roll, never through the wall.

#include "engine/navigate/tour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

/// A screw round the z axis, downwards, that narrows from one width to another.
CentreLine screw(double turns, double radius, double pitch, double wide, double narrow, std::size_t points = 300) {
  CentreLine line;
  double along = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(points - 1), angle = 6.283185307179586 * turns * t;
    const Point3 at{radius * std::cos(angle), radius * std::sin(angle), -pitch * turns * t};
    if (i > 0) along += length(at - line.points.back().at);
    line.points.push_back({at, wide + t * (narrow - wide), along});
  }
  line.end = line.points.back().at;
  return line;
}

/// Straight, then a sharp corner, then straight: nothing that a centre line should have.
CentreLine corner() {
  CentreLine line;
  for (int i = 0; i <= 40; ++i) line.points.push_back({{0, 0, -0.1 * i}, 0.4, 0.1 * i});
  for (int i = 1; i <= 40; ++i) line.points.push_back({{0.1 * i, 0, -4}, 0.4, 4 + 0.1 * i});
  line.end = line.points.back().at;
  return line;
}

glm::dvec3 view_direction(const Camera& camera) { return glm::normalize(camera.target - camera.position); }

/// By finite differences over the tour, at another rate than its own.
struct Measured {
  double turn_deg_s = 0, jerk = 0, roll_deg_s = 0;
};
Measured measured(const Tour& tour) {
  const double step = 1.0 / 97;
  Measured most;
  for (double t = 0; t + 3 * step < tour.seconds(); t += step) {
    const TourInstant a = tour.at(t), b = tour.at(t + step), c = tour.at(t + 2 * step), d = tour.at(t + 3 * step);
    const glm::dvec3 u = view_direction(a.camera), v = view_direction(b.camera);
    most.turn_deg_s =
        std::max(most.turn_deg_s, glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v))) / step);
    const glm::dvec3 third = d.camera.position - 3.0 * c.camera.position + 3.0 * b.camera.position - a.camera.position;
    most.jerk = std::max(most.jerk, glm::length(third) / (step * step * step) / std::min(a.width, d.width));
    // Roll: what is left of the turn of `up` round the line of view_direction.
    const glm::dvec3 rate = glm::cross(a.camera.up, b.camera.up) / step;
    const glm::dvec3 middle = glm::normalize(u + v), swing = glm::cross(u, v) / step;
    most.roll_deg_s =
        std::max(most.roll_deg_s, std::abs(glm::degrees(glm::dot(rate, middle) - glm::dot(swing, middle))));
  }
  return most;
}

void expect_bounds(const Tour& tour) {
  const Measured most = measured(tour);
  EXPECT_LE(most.turn_deg_s, Tour::largest_turn_deg_s);
  EXPECT_LE(most.jerk, Tour::largest_jerk);
  EXPECT_LE(most.roll_deg_s, 0.5);
}

TEST(Tour, KeepsItsBoundsOnCurvesAndCorners) {
  expect_bounds(Tour(screw(3, 1, 2, 0.5, 0.1)));
  expect_bounds(Tour(screw(3, 1, 2, 0.5, 0.1), {.back = true}));
  expect_bounds(Tour(corner()));
  expect_bounds(Tour(corner(), {.radii_per_second = 20}));
  expect_bounds(Tour(screw(0.01, 1, 500, 0.5, 0.5)));
}

TEST(Tour, LeadsFromStartToEndAndBack) {
  const CentreLine line = screw(1, 2, 6, 0.6, 0.3);
  const auto place = [](const Point3& p) { return glm::dvec3(p.x, p.y, p.z); };
  const Tour there(line), back(line, {.back = true});
  EXPECT_NEAR(glm::length(there.at(0).camera.position - place(line.points.front().at)), 0, 1e-6);
  EXPECT_NEAR(glm::length(there.at(there.seconds()).camera.position - place(line.points.back().at)), 0, 1e-6);
  EXPECT_NEAR(glm::length(back.at(0).camera.position - place(line.points.back().at)), 0, 1e-6);
  EXPECT_EQ(there.at(-5).camera, there.at(0).camera);
  EXPECT_EQ(there.at(1e9).camera, there.at(there.seconds()).camera);
  EXPECT_NEAR(there.at(there.seconds()).along, line.points.back().along, 1e-6);
  EXPECT_NEAR(back.at(0).along, line.points.back().along, 1e-6);
  // Both look where they go.
  for (const Tour* tour : {&there, &back})
    for (double t = 0.3 * tour->seconds(); t < 0.7 * tour->seconds(); t += 0.5)
      EXPECT_GT(glm::dot(view_direction(tour->at(t).camera),
                         glm::normalize(tour->at(t + 0.1).camera.position - tour->at(t).camera.position)),
                0.8);
}

TEST(Tour, HasConstantApparentSpeedWhereTheWayIsStraight) {
  const CentreLine line = screw(0.01, 1, 2000, 1, 0.5);
  const double wanted = 2;
  const Tour tour(line, {.radii_per_second = wanted});
  for (double t = 0.2 * tour.seconds(); t < 0.8 * tour.seconds(); t += 0.37) {
    const TourInstant a = tour.at(t), b = tour.at(t + 0.01);
    const double apparent = glm::length(b.camera.position - a.camera.position) / 0.01 / a.width;
    EXPECT_NEAR(apparent, wanted, 0.02 * wanted);
  }
}

TEST(Tour, StaysOnItsLineAndTheNearPlaneOffTheWall) {
  const CentreLine line = screw(2, 1.5, 3, 0.5, 0.2);
  const Tour tour(line);
  for (double t = 0; t <= tour.seconds(); t += 0.11) {
    const TourInstant now = tour.at(t);
    double off = 1e9;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const glm::dvec3 a(line.points[i - 1].at.x, line.points[i - 1].at.y, line.points[i - 1].at.z),
          b(line.points[i].at.x, line.points[i].at.y, line.points[i].at.z);
      const double s = glm::clamp(glm::dot(now.camera.position - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
      off = std::min(off, glm::length(now.camera.position - a - s * (b - a)));
    }
    EXPECT_LT(off, 0.02 * now.clearance);
    // The farthest corner of the near plane, in the widest picture.
    const double slope = std::tan(glm::radians(now.camera.field_of_view_deg) / 2);
    EXPECT_LT(now.camera.near_mm * std::sqrt(1 + slope * slope * (1 + 2.4 * 2.4)) + off, now.clearance);
    EXPECT_GT(now.camera.near_mm, 0);
    validate(now.camera, "tour");
  }
}

/// A line as rough as the wall of a scan makes it.
TEST(Tour, IsNotSlowedByALittleRoughness) {
  CentreLine smooth = screw(1, 3, 8, 0.5, 0.5), rough = smooth;
  for (std::size_t i = 0; i < rough.points.size(); ++i)
    rough.points[i].at.x += 0.01 * std::sin(12.9898 * static_cast<double>(i * i));
  const Tour even(smooth), shaken(rough);
  expect_bounds(shaken);
  EXPECT_LT(shaken.seconds(), 1.3 * even.seconds());
}

TEST(Tour, OfTheShortestLineIsOne) {
  CentreLine line;
  line.points = {{{0, 0, 0}, 1, 0}, {{0, 0, -1e-3}, 1, 1e-3}};
  const Tour tour(line);
  EXPECT_GT(tour.seconds(), 0);
  validate(tour.at(0.5 * tour.seconds()).camera, "tour");
  EXPECT_THROW(Tour(line, {.radii_per_second = 0}), UsageError);
}

}  // namespace
}  // namespace odontoscope
