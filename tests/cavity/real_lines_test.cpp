// Centre lines of the sample teeth, whose canals are known, and of a CT molar.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "recon/cavity/centre_lines.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/sample/sample_tooth.h"
#include "recon/volume/volume_contours.h"
#include "tests/cavity/fine_lines.h"
#include "tests/cavity/section_oracle.h"

namespace odontoscope {
namespace {

Cavity void_of_solid(const ContourStack& stack, const std::string& structure) {
  const Reconstruction made = reconstruct(stack);
  for (const Solid& solid : made.solids)
    if (solid.structure == structure) return cavities_of(solid.structure, solid.surface, solid.report).at(0);
  throw InternalError("no such structure");
}

double to_polyline(const Point3& p, const std::vector<Point3>& line) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Direction way = line[i] - line[i - 1];
    const double t = std::clamp(dot(p - line[i - 1], way) / dot(way, way), 0.0, 1.0);
    nearest = std::min(nearest, length(p - line[i - 1] + -t * way));
  }
  return nearest;
}

/// The least share of the best possible width within three radii in the cross-section, over every few points from the
/// orifice on.
double least_share(const Cavity& cavity, const CentreLine& line, std::size_t stride) {
  double least = 1;
  for (std::size_t i = line.orifice; i + 1 < line.points.size(); i += stride) {
    const CentrePoint& p = line.points[i];
    const Direction along = line.points[i + 1].at - line.points[i - 1].at;
    const double best =
        test::widest_in_section(cavity.wall, p.at, {along.x, along.y, along.z}, p.radius / 6, 3 * p.radius);
    EXPECT_NEAR(test::brute_distance(cavity.wall, p.at), p.radius, 1e-9);
    least = std::min(least, p.radius / best);
    EXPECT_GE(p.radius, 0.9 * best) << line.name << ", " << p.along << " along, at " << p.at.x << " " << p.at.y << " "
                                    << p.at.z;
  }
  return least;
}

class SampleLines : public ::testing::TestWithParam<ToothKind> {};

TEST_P(SampleLines, FollowTheCanalsThatAreKnown) {
  const SampleFacts facts = sample_facts(GetParam());
  const Cavity cavity = void_of_solid(sample_tooth(GetParam()), "dentine");
  const CentreLines lines = centre_lines(cavity);
  EXPECT_TRUE(lines.has_chamber);
  ASSERT_EQ(lines.canals.size(), facts.canals.size());
  EXPECT_EQ(lines.horns.size(), facts.horns.size());
  EXPECT_TRUE(lines.others.empty() && lines.loops.empty());
  constexpr double slices = 0.25;
  for (const CanalFact& fact : facts.canals) {
    const auto line =
        std::min_element(lines.canals.begin(), lines.canals.end(), [&](const CentreLine& a, const CentreLine& b) {
          return length(a.end - fact.axis.front()) < length(b.end - fact.axis.front());
        });
    EXPECT_LT(length(line->end - fact.axis.front()), 1.5 * slices) << fact.name;
    const CentreLine& fine = test::ending_at(test::fine_lines(facts.kind).canals, fact.axis.front());
    if (facts.kind != ToothKind::incisor) {
      EXPECT_NEAR(line->points[line->orifice].at.z, fine.points[fine.orifice].at.z, slices) << fact.name;
    }
    std::vector<Point3> axis;
    for (const CentrePoint& point : fine.points) axis.push_back(point.at);
    for (std::size_t i = line->orifice; i < line->points.size(); ++i)
      if (line->points[i].at.z < fact.high_z - 1 && line->points[i].at.z > fact.low_z + slices) {
        EXPECT_LT(to_polyline(line->points[i].at, axis), 0.12) << fact.name << " at " << line->points[i].at.z;
      }
    RecordProperty(fact.name, std::to_string(least_share(cavity, *line, 5)));
  }
}

INSTANTIATE_TEST_SUITE_P(Teeth, SampleLines,
                         ::testing::Values(ToothKind::molar, ToothKind::premolar, ToothKind::incisor),
                         [](const auto& tooth) { return std::string(name(tooth.param)); });

TEST(SampleLines, AreTheSameEachTime) {
  const Cavity cavity = void_of_solid(sample_tooth(ToothKind::incisor), "dentine");
  const CentreLines one = centre_lines(cavity), two = centre_lines(cavity);
  ASSERT_EQ(one.canals.size(), two.canals.size());
  for (std::size_t i = 0; i < one.canals.size(); ++i) {
    ASSERT_EQ(one.canals[i].points.size(), two.canals[i].points.size());
    for (std::size_t k = 0; k < one.canals[i].points.size(); ++k)
      EXPECT_EQ(one.canals[i].points[k].at, two.canals[i].points[k].at);
  }
}

TEST(CtMolarLines, ReachTheEndsOfAllThreeCanals) {
  const std::string file = std::string(ODONTOSCOPE_DATA) + "/ct_molar/tooth.nrrd";
  if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file))
    GTEST_SKIP() << "ct_molar/tooth.nrrd is not there; give its folder as -DODONTOSCOPE_DATA=...";
  VolumeContourOptions options;
  options.isos = {{120, "tooth"}};
  options.trace.min_area = 4;
  const ContourStack stack = contours_from_volume(file, options).stack;
  const Cavity cavity = void_of_solid(stack, "tooth");
  const CentreLines lines = centre_lines(cavity);
  ASSERT_EQ(lines.canals.size(), 3u);
  EXPECT_EQ(lines.horns.size(), 2u);
  // The lowest holes of the three canals in the contours, as counted by hand from the list of all holes: a slice is a
  // voxel.
  const std::vector<Point3> lowest = {{34.0, 69.5, 26}, {75.9, 64.8, 34}, {72.1, 76.3, 39}};
  constexpr double voxel = 1;
  for (const Point3& end : lowest) {
    double nearest = 1e9;
    for (const CentreLine& line : lines.canals) nearest = std::min(nearest, length(line.points.back().at - end));
    EXPECT_LE(nearest, voxel) << "of the end at z = " << end.z;
  }
  for (const CentreLine& line : lines.canals) {
    EXPECT_LE(length(line.end - line.points.back().at), voxel) << line.name;
    EXPECT_NEAR(line.points[line.orifice].at.z, 80.5, 3) << line.name;  // the chamber's floor lies between 78 and 84
    RecordProperty(line.name, std::to_string(least_share(cavity, line, 5)));
  }
}

}  // namespace
}  // namespace odontoscope
