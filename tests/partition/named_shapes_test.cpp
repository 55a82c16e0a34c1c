// Awkward shapes and the sample teeth as partitions: what they come out as, and that the judge finds nothing.

#include "tests/partition/named_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "recon/delaunay/verdict.h"
#include "recon/partition/reconstruct_partition.h"
#include "recon/sample/sample_tooth.h"
#include "tests/partition/partition_oracle.h"

namespace odontoscope::test {
namespace {

using Names = std::vector<std::string>;

const Solid& solid(const Reconstruction& made, const std::string& structure) {
  return *std::find_if(made.solids.begin(), made.solids.end(),
                       [&](const Solid& s) { return s.structure == structure; });
}

/// Shells, and the sum of their genera.
std::pair<std::size_t, long> shape_of(const Solid& one) {
  long genus = 0;
  for (const Shell& shell : one.report.shells) genus += shell.genus;
  return {one.report.shells.size(), genus};
}

double volume_of(const Solid& one) {
  double volume = 0;
  for (const Shell& shell : one.report.shells) volume += shell.volume;
  return volume;
}

Reconstruction judged(const ContourStack& stack, const Names& priority) {
  Reconstruction made = reconstruct_partition(stack, {.priority = priority});
  EXPECT_EQ(partition_faults(made, stack, {priority, 0}), Names{});
  return made;
}

std::size_t faces_between(const Reconstruction& made, const std::string& one, const std::string& other) {
  const Names& names = made.complex->structures;
  const auto label = [&](const std::string& name) {
    return name.empty() ? void_label
                        : static_cast<Label>(std::find(names.begin(), names.end(), name) - names.begin() + 1);
  };
  const auto& faces = made.complex->interfaces;
  return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), [&](const InterfaceTriangle& face) {
    return (face.inner == label(one) && face.outer == label(other)) ||
           (face.inner == label(other) && face.outer == label(one));
  }));
}

TEST(Partition, ThreeMaterialsMeetInADriftingLine) {
  const Reconstruction made = judged(three_in_a_drifting_line(), {"a", "b", "c"});
  for (const char* name : {"a", "b", "c"})
    EXPECT_EQ(shape_of(solid(made, name)), std::pair(std::size_t{1}, 0L)) << name;
  EXPECT_GT(faces_between(made, "a", "b"), 0u);
  EXPECT_GT(faces_between(made, "b", "c"), 0u);
  EXPECT_GT(faces_between(made, "a", "c"), 0u);
  EXPECT_EQ(verdict_of(made), Verdict::green);
}

TEST(Partition, OneLabelAppearsBetweenTwoOthersInOneSlice) {
  const Reconstruction made = judged(one_between_two_in_one_slice(), {"between", "left", "right"});
  EXPECT_EQ(shape_of(solid(made, "between")), std::pair(std::size_t{1}, 0L));
  EXPECT_EQ(shape_of(solid(made, "left")), std::pair(std::size_t{1}, 0L));
  EXPECT_EQ(shape_of(solid(made, "right")), std::pair(std::size_t{1}, 0L));
}

TEST(Partition, AShellThatDriftsByMoreThanItsThicknessStaysOneTube) {
  const Reconstruction made = judged(thin_shell_that_drifts(), {"dentine", "enamel"});
  EXPECT_EQ(shape_of(solid(made, "enamel")), std::pair(std::size_t{1}, 1L));
  EXPECT_EQ(shape_of(solid(made, "dentine")), std::pair(std::size_t{1}, 0L));
  EXPECT_EQ(faces_between(made, "dentine", "") > 0, true) << "its two ends";
}

TEST(Partition, ACheckerboardCornerIsParted) {
  const Reconstruction made = judged(checkerboard_corner(), {"a", "b", "c", "d"});
  EXPECT_EQ(made.partition.corners_cut, 3u);
  for (const Solid& one : made.solids) EXPECT_EQ(shape_of(one), std::pair(std::size_t{1}, 0L)) << one.structure;
}

TEST(Partition, ACanalLeavesThroughTheApex) {
  const Reconstruction made = judged(canal_through_the_apex(), {"pulp", "dentine"});
  EXPECT_EQ(shape_of(solid(made, "dentine")), std::pair(std::size_t{1}, 1L));
  EXPECT_EQ(shape_of(solid(made, "pulp")), std::pair(std::size_t{1}, 0L));
  EXPECT_EQ(verdict_of(made), Verdict::green);
}

/// How far places on the margin are off its height, from one height to another.
std::vector<double> margin_errors(const Reconstruction& made, double low, double high) {
  const LabelledComplex& complex = *made.complex;
  std::map<std::array<std::uint32_t, 2>, std::set<std::pair<Label, Label>>> faces_at;
  for (const InterfaceTriangle& face : complex.interfaces)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = face.triangle[k], b = face.triangle[(k + 1) % 3];
      faces_at[{std::min(a, b), std::max(a, b)}].insert({face.inner, face.outer});
    }
  std::vector<double> errors;
  for (const auto& [edge, faces] : faces_at) {
    const Point3 &a = complex.mesh.points[edge[0]], &b = complex.mesh.points[edge[1]];
    if (faces.size() < 3 || std::min(a.z, b.z) < low || std::max(a.z, b.z) > high) continue;
    constexpr int steps = 8;
    for (int i = 0; i < steps; ++i) {
      const double share = (i + 0.5) / steps, angle = std::atan2(a.y + share * (b.y - a.y), a.x + share * (b.x - a.x));
      errors.push_back(a.z + share * (b.z - a.z) - slanting_margin_height(angle));
    }
  }
  return errors;
}

TEST(Partition, AMarginSlopesBetweenSlices) {
  const ContourStack stack = slanting_margin();
  const Reconstruction made = judged(stack, {"dentine", "enamel"});
  EXPECT_EQ(verdict_of(made), Verdict::green);
  const std::vector<double> errors = margin_errors(made, 0.75, 2.25);
  ASSERT_GT(errors.size(), 100u);
  double squares = 0;
  for (const double error : errors) squares += error * error;
  const double off = std::sqrt(squares / static_cast<double>(errors.size()));
  RecordProperty("root_mean_square_mm", std::to_string(off));
  EXPECT_LT(off, 0.045) << "in steps a slice high it would be 0.1 mm and more";
}

TEST(Partition, AStructureThatOthersCoverHasNoSolid) {
  ContourStack stack = canal_through_the_apex();
  for (Slice& slice : stack.slices) slice.contours.push_back({"covered", slice.contours[1].points});
  const Reconstruction made = reconstruct_partition(stack, {.priority = {"pulp", "covered", "dentine"}});
  EXPECT_EQ(made.solids.size(), 2u);
  EXPECT_EQ(made.complex->structures.size(), 3u);
}

class SampleTooth : public testing::TestWithParam<ToothKind> {};

TEST_P(SampleTooth, IsATruePartition) {
  SampleOptions options;
  options.walls = SampleWalls::filled;
  options.slice_spacing = 0.35;
  const Reconstruction made = reconstruct_partition(sample_tooth(GetParam(), options));
  EXPECT_EQ(verdict_of(made), Verdict::green);
  EXPECT_EQ(shape_of(solid(made, "enamel")), std::pair(std::size_t{1}, 0L));
  EXPECT_EQ(shape_of(solid(made, "pulp")), std::pair(std::size_t{1}, 0L));
  EXPECT_EQ(shape_of(solid(made, "dentine")), std::pair(std::size_t{2}, 0L)) << "one shell, one cavity";
  EXPECT_EQ(faces_between(made, "pulp", ""), 0u) << "pulp touches dentine alone";
  EXPECT_EQ(faces_between(made, "pulp", "enamel"), 0u);
  for (const Shell& shell : solid(made, "dentine").report.shells)
    if (shell.kind == Shell::Kind::cavity) EXPECT_NEAR(-shell.volume, volume_of(solid(made, "pulp")), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SampleTooth, testing::Values(ToothKind::molar, ToothKind::premolar, ToothKind::incisor),
                         [](const auto& info) { return std::string(name(info.param)); });

}  // namespace
}  // namespace odontoscope::test
