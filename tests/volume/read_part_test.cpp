// Large files, of which no more is kept than is wanted: every block lies where its voxels lie in the file, whichever
// way its axes run.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "recon/volume/read_volume.h"
#include "tests/output/temporary_folder.h"
#include "tests/volume/volume_files.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

constexpr std::array<std::size_t, 3> file_size{24, 18, 30};

/// Runs straight in all of space: the mean of a block is what it is in the block's middle.
double field(double x, double y, double z) { return 3 * x - 2 * y + 0.5 * z + 40; }

/// `axes`: the file's, each along one of x, y and z, by "space directions".
struct Axes {
  std::array<std::array<double, 3>, 3> steps;
  std::array<double, 3> origin;
};

std::string nrrd(const Axes& axes, bool packed) {
  std::vector<float> values;
  for (std::size_t k = 0; k < file_size[2]; ++k)
    for (std::size_t j = 0; j < file_size[1]; ++j)
      for (std::size_t i = 0; i < file_size[0]; ++i) {
        std::array<double, 3> place = axes.origin;
        const std::array<std::size_t, 3> index{i, j, k};
        for (std::size_t n = 0; n < 3; ++n)
          for (std::size_t x = 0; x < 3; ++x) place[x] += static_cast<double>(index[n]) * axes.steps[n][x];
        values.push_back(static_cast<float>(field(place[0], place[1], place[2])));
      }
  Nrrd file;
  file.type = "float";
  file.sizes = "24 18 30";
  file.more = "endian: little\nspace: left-posterior-superior\nspace directions:";
  for (const auto& step : axes.steps)
    file.more += " (" + std::to_string(step[0]) + "," + std::to_string(step[1]) + "," + std::to_string(step[2]) + ")";
  file.more += "\nspace origin: (" + std::to_string(axes.origin[0]) + "," + std::to_string(axes.origin[1]) + "," +
               std::to_string(axes.origin[2]) + ")\n";
  file.pixels = bytes_of(values);
  if (packed) {
    file.encoding = "gzip";
    file.pixels = gzip_packed(file.pixels);
  }
  return file.bytes();
}

const Axes usual{{{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.25}}}, {1, 2, 3}};
const Axes turned_round{{{{0, 0, -0.5}, {0.25, 0, 0}, {0, -0.5, 0}}}, {-4, 7, 20}};

Volume read(const Axes& axes, const std::optional<VolumePart>& part, bool packed = false) {
  const TemporaryFolder folder;
  put(folder / "ct.nrrd", nrrd(axes, packed));
  return read_volume((folder / "ct.nrrd").string(), {.spacing = {}, .series = {}, .part = part});
}

double worst(const Volume& volume) {
  double most = 0;
  for (std::size_t k = 0; k < volume.size[2]; ++k)
    for (std::size_t j = 0; j < volume.size[1]; ++j)
      for (std::size_t i = 0; i < volume.size[0]; ++i) {
        const double right = field(volume.origin.x + static_cast<double>(i) * volume.spacing[0],
                                   volume.origin.y + static_cast<double>(j) * volume.spacing[1],
                                   volume.origin.z + static_cast<double>(k) * volume.spacing[2]);
        most = std::max(most, std::abs(right - static_cast<double>(volume.slice(k)[j * volume.size[0] + i])));
      }
  return most;
}

TEST(PartsOfVolumes, AreWholeWhereThatIsLittle) {
  const Volume whole = read(usual, {}), part = read(usual, VolumePart{.whole_up_to = 24 * 18 * 30, .most_voxels = 8});
  EXPECT_EQ(part.values, whole.values);
  EXPECT_EQ(part.merged, (std::array<std::size_t, 3>{1, 1, 1}));
}

TEST(PartsOfVolumes, HaveTheMeansOfBlocksWhereTheirMiddlesLie) {
  for (const Axes& axes : {usual, turned_round})
    for (const bool packed : {false, true}) {
      const Volume part =
          read(axes, VolumePart{.most_voxels = 24 * 18 * 30 / 12}, packed);  // 2 x 2 x 3: finest axis first
      EXPECT_LE(part.values.size(), 24u * 18 * 30 / 12);
      EXPECT_EQ(part.values.size(), part.size[0] * part.size[1] * part.size[2]);
      EXPECT_GT(part.merged[0] * part.merged[1] * part.merged[2], 11u);
      EXPECT_LT(worst(part), 1e-4);
    }
}

TEST(PartsOfVolumes, AreCutToBounds) {
  const VolumeBounds within{{3, 4, 5}, {6, 7, 8}};
  const Volume part = read(usual, VolumePart{.most_voxels = 100000, .within = within}), whole = read(usual, {});
  EXPECT_LT(worst(part), 1e-4);
  EXPECT_LT(part.values.size(), whole.values.size() / 2);
  const std::array<double, 3> low{part.origin.x, part.origin.y, part.origin.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(low[axis], within.low[axis]);
    EXPECT_GE(low[axis] + static_cast<double>(part.size[axis] - 1) * part.spacing[axis], within.high[axis]);
    EXPECT_GT(low[axis], within.low[axis] - 2.01 * part.spacing[axis]);
  }
  const Volume coarse =
      read(turned_round, VolumePart{.most_voxels = 200, .within = VolumeBounds{{-3, 0, 12}, {2, 4, 17}}});
  EXPECT_LE(coarse.values.size(), 200u);
}

// What is sampled is a voxel of the file, not a mean: labels stay labels.
TEST(PartsOfVolumes, AreSampledWhereTheirFirstVoxelsLie) {
  for (const Axes& axes : {usual, turned_round}) {
    const Volume samples = read(axes, VolumePart{.most_voxels = 700, .sampled = true}), whole = read(axes, {});
    EXPECT_LE(samples.values.size(), 700u);
    EXPECT_EQ(samples.size_before, whole.size);
    EXPECT_EQ(whole.size_before, (std::array<std::size_t, 3>{}));
    EXPECT_LT(worst(samples), 1e-4);
    for (const float value : samples.values)
      EXPECT_NE(std::find(whole.values.begin(), whole.values.end(), value), whole.values.end());
  }
}

TEST(PartsOfVolumes, HaveAtLeastTwoVoxelsAlongEachAxis) {
  const Volume part = read(usual, VolumePart{.most_voxels = 1});
  for (const std::size_t count : part.size) EXPECT_EQ(count, 2u);
}

}  // namespace
}  // namespace odontoscope::test
