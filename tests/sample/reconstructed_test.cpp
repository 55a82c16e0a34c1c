// The sample teeth as the DT engine makes them: the topology that sample_tooth.h promises.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/input/validate.h"
#include "recon/mesh/plane_section.h"
#include "recon/partition/reconstruct_structures.h"
#include "tests/sample/made_once.h"
#include "tests/sample/stack_queries.h"

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

/// As it comes unasked; made once.
const MadeOfStructures& partition_of(ToothKind kind) {
  static std::map<ToothKind, MadeOfStructures> known;
  const auto [made, fresh] = known.try_emplace(kind);
  if (fresh) made->second = reconstruct_structures(made_once(kind));
  return made->second;
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
  const MadeOfStructures& made = partition_of(GetParam());
  ASSERT_TRUE(made.reconstruction.complex) << made.no_partition;
  EXPECT_TRUE(made.reconstruction.attention.empty());
  EXPECT_EQ(shells(solid(made.reconstruction, "enamel")), ball);
  EXPECT_EQ(shells(solid(made.reconstruction, "dentine")), hollow_ball);
  EXPECT_EQ(shells(solid(made.reconstruction, "pulp")), ball);
}

/// Area of what a solid's surface holds at a height round a place: of the innermost loop about it.
double area_around(const SurfaceMesh& surface, Point3 at) {
  double least = 0;
  for (const std::vector<Point2>& loop : section_loops(surface, at.z))
    if (inside({at.x, at.y}, loop) && (least == 0 || std::abs(area(loop)) < least)) least = std::abs(area(loop));
  return least;
}

double field_around(const ContourStack& fine, Point3 at) {
  for (const Contour* contour : contours(slice_at(fine, at.z), "pulp", true))
    if (inside({at.x, at.y}, contour->points)) return area(contour->points);
  return 0;
}

// Chamber, floor and canals below it: as wide as in slices so close that they show the field.
TEST_P(ReconstructedSample, OrificesAndFloorAreAsWideAsInTheField) {
  const SampleFacts facts = sample_facts(GetParam());
  const MadeOfStructures& made = partition_of(GetParam());
  const SurfaceMesh& pulp = solid(made.reconstruction, "pulp").surface;
  const ContourStack& fine = made_once(GetParam(), 0.1);
  for (const CanalFact& canal : facts.canals) {
    const Point3& below = *(canal.axis.end() - 2);
    // Beside the step itself, whose height slices tell to their spacing.
    for (const double beside : {-0.5, -0.3, -0.15, 0.2, 0.4}) {
      const double z = slice_at(fine, facts.chamber_low_z + beside).z;
      const double share = std::min(1.0, (z - below.z) / (canal.axis.back().z - below.z));
      const Point3 at{below.x + share * (canal.axis.back().x - below.x),
                      below.y + share * (canal.axis.back().y - below.y), z};
      const double field = field_around(fine, at);
      ASSERT_GT(field, 0) << canal.name << beside;
      EXPECT_NEAR(area_around(pulp, at) / field, 1, 0.06) << canal.name << " " << beside << " mm from the floor";
    }
  }
}

TEST_P(ReconstructedSample, OpenApicesLetThePulpMeetTheOutside) {
  const ContourStack open = sample_tooth(GetParam(), {.open_apex = true});
  const MadeOfStructures made = reconstruct_structures(open);
  ASSERT_TRUE(made.reconstruction.complex) << made.no_partition;
  const std::size_t canals = sample_facts(GetParam()).canals.size();
  EXPECT_EQ(shells(solid(made.reconstruction, "dentine")),
            std::vector<std::string>{"external of genus " + std::to_string(canals - 1)});
  EXPECT_EQ(shells(solid(made.reconstruction, "pulp")), ball);
  EXPECT_EQ(shells(solid(made.reconstruction, "enamel")), ball);
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
  const Reconstruction& made = partition_of(GetParam()).reconstruction;
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
