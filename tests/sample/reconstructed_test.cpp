// The sample teeth as the DT engine makes them: the topology that sample_tooth.h promises.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/input/validate.h"
#include "recon/partition/reconstruct_structures.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::test {
namespace {

class ReconstructedSample : public testing::TestWithParam<ToothKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ReconstructedSample,
                         testing::Values(ToothKind::molar, ToothKind::premolar, ToothKind::incisor),
                         [](const auto& kind) { return name(kind.param); });

const Solid& solid(const Reconstruction& made, const std::string& structure) {
  const auto found =
      std::find_if(made.solids.begin(), made.solids.end(), [&](const Solid& s) { return s.structure == structure; });
  if (found == made.solids.end()) throw std::runtime_error("no solid " + structure);
  return *found;
}

std::vector<std::string> shells(const Solid& solid) {
  std::vector<std::string> words;
  for (const Shell& shell : solid.report.shells) {
    const char* kind = shell.kind == Shell::Kind::external ? "external"
                       : shell.kind == Shell::Kind::cavity ? "cavity"
                                                           : "open";
    words.push_back(std::string(kind) + " of genus " + std::to_string(shell.genus));
  }
  return words;
}

const std::vector<std::string> ball{"external of genus 0"}, hollow_ball{"external of genus 0", "cavity of genus 0"};

TEST_P(ReconstructedSample, HasThePromisedTopology) {
  const Reconstruction made = reconstruct(sample_tooth(GetParam()));
  EXPECT_TRUE(made.certified);
  EXPECT_EQ(shells(solid(made, "enamel")), ball);
  EXPECT_EQ(shells(solid(made, "dentine")), hollow_ball);
  EXPECT_EQ(shells(solid(made, "pulp")), ball);
}

TEST_P(ReconstructedSample, IsAPartitionUnasked) {
  const MadeOfStructures made = reconstruct_structures(sample_tooth(GetParam()));
  ASSERT_TRUE(made.reconstruction.complex) << made.no_partition;
  EXPECT_TRUE(made.reconstruction.attention.empty());
  EXPECT_EQ(shells(solid(made.reconstruction, "enamel")), ball);
  EXPECT_EQ(shells(solid(made.reconstruction, "dentine")), hollow_ball);
  EXPECT_EQ(shells(solid(made.reconstruction, "pulp")), ball);
}

TEST_P(ReconstructedSample, ThePulpStaysInOnePieceAtTheWidestAndAFineSpacing) {
  for (const double spacing : {0.35, 0.1}) {
    const Reconstruction made = reconstruct(sample_tooth(GetParam(), {.slice_spacing = spacing}));
    EXPECT_EQ(shells(solid(made, "pulp")), ball) << spacing;
    EXPECT_EQ(made.counts.isolated_regions, 0u) << spacing;
  }
}

TEST_P(ReconstructedSample, PulpMakesTheCavityOfFilledDentine) {
  const ContourStack filled = sample_tooth(GetParam(), {.walls = SampleWalls::apart, .hollow_dentine = false});
  const Reconstruction made = reconstruct(together(filled, {"dentine", "pulp"}));
  EXPECT_EQ(shells(solid(made, "dentine+pulp")), hollow_ball);
}

// Published volumes differ by tooth and age; this guards the order of magnitude and the unit.
TEST_P(ReconstructedSample, VolumesAreThoseOfTeeth) {
  const Reconstruction made = reconstruct_structures(sample_tooth(GetParam())).reconstruction;
  const double enamel = solid(made, "enamel").report.shells[0].volume,
               pulp = solid(made, "pulp").report.shells[0].volume;
  const auto& dentine = solid(made, "dentine").report.shells;
  const double cavity = -dentine[1].volume, whole = enamel + dentine[0].volume;
  EXPECT_GT(whole, 400);
  EXPECT_LT(whole, 1300);
  EXPECT_GT(enamel / whole, 0.1);
  EXPECT_LT(enamel / whole, 0.35);
  EXPECT_NEAR(cavity, pulp, 1e-9 * pulp);
}

}  // namespace
}  // namespace odontoscope::test
