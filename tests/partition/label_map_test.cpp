// Label maps as partitions: where three labels meet nothing is left between them, in the slices and between them.

#include <gtest/gtest.h>

#include <cmath>

#include "recon/partition/reconstruct_partition.h"
#include "recon/volume/label_contours.h"
#include "tests/partition/partition_oracle.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {
namespace {

template <class LabelAt>
Volume map_of(std::array<std::size_t, 3> size, LabelAt label) {
  Volume volume;
  volume.size = size;
  volume.spacing = {0.2, 0.15, 0.3};
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i)
        volume.values.push_back(static_cast<float>(label(double(i), double(j), double(k))));
  return volume;
}

const std::vector<LabelLevel> three{{1, "a"}, {2, "b"}, {3, "c"}};

Reconstruction judged(const Volume& volume) {
  const ContourStack stack = label_contours(volume, three).stack;
  const std::vector<std::string> priority{"a", "b", "c"};
  Reconstruction made = reconstruct_partition(stack, {.priority = priority});
  EXPECT_EQ(partition_faults(made, stack, {priority, 0}), std::vector<std::string>{});
  return made;
}

TEST(LabelMapPartition, ThreeSectorsMeetInALineWithoutAVoid) {
  const Volume volume = map_of({24, 30, 6}, [](double i, double j, double k) {
    const double x = 0.2 * i - 2.3 - 0.05 * k, y = 0.15 * j - 2.2 + 0.04 * k;
    const double third = std::floor(3 * (std::atan2(y, x) + 3.2) / 6.4);
    return std::hypot(0.2 * i - 2.3, 0.15 * j - 2.2) < 1.8 ? 1 + third : 0;
  });
  const Reconstruction made = judged(volume);
  ASSERT_EQ(made.solids.size(), 3u);
  for (const Solid& solid : made.solids) {
    ASSERT_EQ(solid.report.shells.size(), 1u) << solid.structure;
    EXPECT_EQ(solid.report.shells[0].genus, 0) << solid.structure;
  }
  // All together are one ball: a void along the line would be a handle, or a shell of its own.
  SurfaceMesh outside{made.complex->mesh.points, {}};
  for (const InterfaceTriangle& face : made.complex->interfaces)
    if (face.outer == void_label) outside.triangles.push_back(face.triangle);
  const SurfaceReport report = inspect(outside);
  ASSERT_EQ(report.shells.size(), 1u);
  EXPECT_EQ(report.shells[0].genus, 0);
  EXPECT_EQ(made.partition.corners_cut, 0u);
}

TEST(LabelMapPartition, OfNoiseIsCertified) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    SCOPED_TRACE(seed);
    RandomNumbers random(seed);
    const int lowest = seed % 2 == 0 ? 0 : 1;  // with and without void
    judged(map_of({6, 5, 3}, [&](double, double, double) { return random.whole(lowest, 3); }));
  }
}

}  // namespace
}  // namespace odontoscope::test
