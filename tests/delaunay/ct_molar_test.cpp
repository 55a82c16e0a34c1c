// The CT molar, whose voxels tell what is true: one tooth without a handle, one pulp, and specks.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "recon/input/validate.h"
#include "recon/sample/sample_tooth.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"
#include "tests/delaunay/engine_checks.h"
#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

const std::filesystem::path molar_file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";

/// Outer contours counter-clockwise, holes clockwise, slices by ascending z.
const ContourStack& molar_contours() {
  static const ContourStack stack =
      iso_contours(read_volume(molar_file.string()), {{120, "tooth"}}, {.min_area = 4}).stack;
  return stack;
}

/// One reconstruction for all tests here.
const Reconstruction& molar() {
  static const Reconstruction result = certified(molar_contours());
  return result;
}

class CtMolar : public testing::Test {
  void SetUp() override {
    if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(molar_file))
      GTEST_SKIP() << "the CT molar is not there; set the CMake variable ODONTOSCOPE_DATA";
  }
};

TEST_F(CtMolar, IsOneToothWithoutAHandle) {
  const auto& all = molar().solids.at(0).report.shells;
  std::vector<Shell> external;
  std::copy_if(all.begin(), all.end(), std::back_inserter(external),
               [](const Shell& shell) { return shell.kind == Shell::Kind::external; });
  ASSERT_EQ(external.size(), 1u);
  EXPECT_EQ(external[0].genus, 0);
}

TEST_F(CtMolar, HasOnePulpOfTheSizeThatTheVoxelsSay) {
  std::vector<Shell> cavities;
  for (const Shell& shell : molar().solids.at(0).report.shells)
    if (shell.kind == Shell::Kind::cavity) cavities.push_back(shell);
  ASSERT_FALSE(cavities.empty());
  std::sort(cavities.begin(), cavities.end(), [](const Shell& a, const Shell& b) { return a.volume < b.volume; });
  EXPECT_NEAR(-cavities[0].volume, 17432, 17432 * 0.01);  // voxels below the threshold in its place
  EXPECT_LE(cavities[0].genus, 1);                        // "at most one small loop"
  for (std::size_t i = 1; i < cavities.size(); ++i) EXPECT_LT(-cavities[i].volume, 174) << "a speck, one in a hundred";
}

/// How many holes of the slice at z bound the pulp, and how many the outside.
struct Holes {
  int pulp = 0, outside = 0;
};

std::map<double, Holes> holes_by_height() {
  const Solid& solid = molar().solids.at(0);
  const auto& shells = solid.report.shells;
  const auto by_volume = [](const Shell& a, const Shell& b) { return a.volume < b.volume; };
  const std::size_t pulp = std::size_t(std::min_element(shells.begin(), shells.end(), by_volume) - shells.begin());
  std::set<std::array<double, 3>> on_pulp;
  for (std::size_t t = 0; t < solid.surface.triangles.size(); ++t)
    for (PointIndex v : solid.surface.triangles[t])
      if (const Point3 p = solid.surface.points[v]; solid.report.shell_of[t] == pulp) on_pulp.insert({p.x, p.y, p.z});
  std::map<double, Holes> holes;
  for (const Slice& slice : molar_contours().slices)
    for (const Contour& contour : slice.contours) {
      const Point2 p = contour.points[0];
      if (area_sign(contour.points) > 0) continue;
      ++(on_pulp.contains({p.x, p.y, slice.z}) ? holes[slice.z].pulp : holes[slice.z].outside);
    }
  return holes;
}

TEST_F(CtMolar, HasThreeCanalsOpenFromTheChamberDown) {
  const std::map<double, Holes> holes = holes_by_height();
  // A canal ends where its section falls below the least area, so the lowest two appear one after the other.
  for (double z = 39; z <= 77; ++z) EXPECT_EQ(holes.at(z).pulp, 3) << "z = " << z;
  for (double z = 26; z <= 38; ++z) EXPECT_GE(holes.at(z).pulp, 1) << "z = " << z;
  for (double z = 84; z <= 101; ++z) EXPECT_EQ(holes.at(z).pulp, 1) << "chamber, z = " << z;
}

TEST_F(CtMolar, HolesThatOpenOutsideAreNoPulp) {
  // Between the roots, and the crown's pit; every other hole is the pulp's.
  int between_roots = 0, pit = 0;
  for (const auto& [z, here] : holes_by_height()) {
    if (here.outside == 0) continue;
    EXPECT_TRUE((58 <= z && z <= 64) || (138 <= z && z <= 143)) << "z = " << z;
    (z < 100 ? between_roots : pit) += here.outside;
  }
  EXPECT_GE(between_roots, 5);
  EXPECT_GE(pit, 1);
}

TEST_F(CtMolar, HasNoSpikes) { EXPECT_LE(molar().counts.largest_sideways, 1); }

TEST_F(CtMolar, GivesTheSameBytesOnTwoThreads) {
  const auto with = [](int threads) {
    return reconstruct(molar_contours(), {.correspondence = Correspondence::medial, .links = {}, .threads = threads});
  };
  EXPECT_EQ(difference(with(1), with(2)), "");
}

// --- generated teeth, which every machine has ------------------------------------------------------------------------

TEST(SampleTeeth, HaveTheTopologyThatTheyWereMadeWith) {
  for (ToothKind kind : {ToothKind::molar, ToothKind::premolar, ToothKind::incisor}) {
    SCOPED_TRACE(name(kind));
    const Reconstruction result = certified(sample_tooth(kind), {}, {.self_intersections = true});
    EXPECT_EQ(topology_of(result), shells({"enamel external genus 0", "dentine external genus 0",
                                           "dentine cavity genus 0", "pulp external genus 0"}));
    EXPECT_LE(result.counts.largest_sideways, 1);
  }
}

TEST(SampleTeeth, TogetherHaveThePulpAsACavity) {
  const ContourStack filled = sample_tooth(ToothKind::molar, {.walls = SampleWalls::apart, .hollow_dentine = false});
  const Reconstruction result = certified(together(filled, {"dentine", "pulp"}));
  EXPECT_EQ(topology_of(result),
            shells({"enamel external genus 0", "dentine+pulp external genus 0", "dentine+pulp cavity genus 0"}));
}

}  // namespace
}  // namespace odontoscope::test
