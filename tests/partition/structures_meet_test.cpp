// When a partition is made unasked.

#include "recon/partition/structures_meet.h"

#include <gtest/gtest.h>

#include "recon/core/progress.h"
#include "recon/partition/reconstruct_structures.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::test {
namespace {

std::vector<Point2> square(double from, double to) { return {{from, from}, {to, from}, {to, to}, {from, to}}; }
std::vector<Point2> hole(double from, double to) { return {{from, from}, {from, to}, {to, to}, {to, from}}; }

ContourStack twice(std::vector<Contour> contours) { return {{{0, contours}, {1, contours}}, ""}; }

TEST(StructuresMeet, WhereOneLiesInAnother) {
  EXPECT_TRUE(structures_meet(twice({{"a", square(0, 4)}, {"b", square(1, 2)}})));
}
TEST(StructuresMeet, WhereTheyShareAWall) {
  EXPECT_TRUE(structures_meet(twice({{"a", square(0, 4)}, {"a", hole(1, 2)}, {"b", square(1, 2)}})));
  EXPECT_TRUE(
      structures_meet(twice({{"a", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {"b", {{1, 0}, {2, 0}, {2, 1}, {1, 1}}}})));
}
TEST(StructuresMeet, NotWhereOneLiesInAHoleOfTheOther) {
  EXPECT_FALSE(structures_meet(twice({{"a", square(0, 4)}, {"a", hole(1, 3)}, {"b", square(1.5, 2)}})));
}
TEST(StructuresMeet, NotBeside) { EXPECT_FALSE(structures_meet(twice({{"a", square(0, 1)}, {"b", square(2, 3)}}))); }
TEST(StructuresMeet, NotOne) { EXPECT_FALSE(structures_meet(twice({{"a", square(0, 4)}, {"a", hole(1, 2)}}))); }
TEST(StructuresMeet, InTheSampleUnlessApart) {
  EXPECT_FALSE(structures_meet(sample_tooth(ToothKind::incisor, {.walls = SampleWalls::apart})));
  EXPECT_TRUE(structures_meet(sample_tooth(ToothKind::incisor)));
  EXPECT_TRUE(structures_meet(sample_tooth(ToothKind::incisor, {.walls = SampleWalls::filled})));
}

TEST(ReconstructStructures, MakesAPartitionOfThoseThatMeet) {
  const MadeOfStructures met = reconstruct_structures(twice({{"a", square(0, 4)}, {"b", square(1, 2)}}));
  EXPECT_TRUE(met.reconstruction.complex);
  EXPECT_TRUE(met.no_partition.empty());
  EXPECT_FALSE(reconstruct_structures(twice({{"a", square(0, 1)}, {"b", square(2, 3)}})).reconstruction.complex);
}

TEST(ReconstructStructures, MakesEachByItselfIfThereAreTooManyForAPartition) {
  std::vector<Contour> many;
  for (int i = 0; i < 70; ++i) many.push_back({"s" + std::to_string(i), square(i, i + 1.5)});
  const MadeOfStructures made = reconstruct_structures(twice(many));
  EXPECT_FALSE(made.reconstruction.complex);
  EXPECT_EQ(made.reconstruction.solids.size(), 70u);
  EXPECT_NE(made.no_partition.find("too-many-structures"), std::string::npos) << made.no_partition;
}

/// How often a stack was validated while this was done.
template <class Work>
int validations(Work work) {
  int begun = 0;
  work(Progress{[&](std::string_view stage, double done) { begun += stage == "validate" && done == 0; }, {}});
  return begun;
}

TEST(ReconstructStructures, ValidatesAStackOnceWhateverBecomesOfIt) {
  std::vector<Contour> many;
  for (int i = 0; i < 70; ++i) many.push_back({"s" + std::to_string(i), square(i, i + 1.5)});
  const ContourStack no_partition = twice(many), partition = twice({{"a", square(0, 4)}, {"b", square(1, 2)}});
  for (const ContourStack& stack : {no_partition, partition}) {
    EXPECT_EQ(validations([&](const Progress& progress) { reconstruct_structures(stack, {}, progress); }), 1);
    const ValidStack valid = validate(stack);
    EXPECT_EQ(validations([&](const Progress& progress) { reconstruct_structures(valid, {}, progress); }), 0);
  }
}

}  // namespace
}  // namespace odontoscope::test
