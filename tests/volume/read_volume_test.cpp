// Volumes from files: every format and type gives the same voxels, and every voxel lies where the file says.

#include "recon/volume/read_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "recon/core/error.h"
#include "tests/output/temporary_folder.h"
#include "tests/volume/volume_files.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

Volume read(const std::string& name, const std::string& bytes, const ReadVolumeOptions& options = {}) {
  const TemporaryFolder folder;
  put(folder / name, bytes);
  return read_volume((folder / name).string(), options);
}

std::vector<float> telling_floats() {
  const auto voxels = telling_voxels();
  return {voxels.begin(), voxels.end()};
}

template <class Number>
std::string telling_bytes() {
  const auto voxels = telling_voxels();
  return bytes_of(std::vector<Number>(voxels.begin(), voxels.end()));
}

TEST(ReadVolume, TakesEveryFormat) {
  const std::string pixels = bytes_of(telling_voxels());
  const std::string packed = zlib_packed(pixels);
  const std::string packing = "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n";
  std::string ascii;
  for (const int value : telling_voxels()) ascii += std::to_string(value) + " ";
  const std::vector<std::pair<std::string, std::string>> files{
      {"raw.nrrd", Nrrd{}.bytes()},
      {"gzip.nrrd", Nrrd{.encoding = "gzip", .pixels = gzip_packed(pixels)}.bytes()},
      {"ascii.nrrd", Nrrd{.encoding = "ascii", .pixels = ascii}.bytes()},
      {"skip.nrrd", Nrrd{.more = "byte skip: 3\n", .pixels = "xyz" + pixels}.bytes()},
      {"one-more-dimension.nrrd", Nrrd{.sizes = "5 4 3 1", .dimension = "4"}.bytes()},
      {"raw.mha", MetaImage{}.bytes()},
      {"packed.mha", MetaImage{.more = packing, .pixels = packed}.bytes()},
      {"raw.nii", Nifti{}.bytes()},
      {"packed.nii.gz", gzip_packed(Nifti{}.bytes())}};
  for (const auto& [name, bytes] : files) {
    const Volume volume = read(name, bytes);
    EXPECT_EQ(volume.size, telling_size) << name;
    EXPECT_EQ(volume.values, telling_floats()) << name;
    EXPECT_EQ(volume.tilt_degrees, 0) << name;
  }
}

TEST(ReadVolume, TakesPixelsFromAFileBesideTheHeader) {
  const TemporaryFolder folder;
  put(folder / "pixels.raw", bytes_of(telling_voxels()));
  put(folder / "a.nhdr", Nrrd{.more = "data file: pixels.raw\n", .pixels = ""}.bytes());
  put(folder / "b.mhd", MetaImage{.data_file = "pixels.raw", .pixels = ""}.bytes());
  put(folder / "c.img", bytes_of(telling_voxels()));
  put(folder / "c.hdr", Nifti{.vox_offset = 0, .magic = "ni1", .pixels = ""}.bytes().substr(0, 348));
  for (const char* name : {"a.nhdr", "b.mhd", "c.hdr", "c.img"}) {
    EXPECT_EQ(read_volume((folder / name).string()).values, telling_floats()) << name;
  }
}

TEST(ReadVolume, TakesEveryPixelType) {
  const std::vector<std::pair<std::string, std::string>> types{
      {"int8", telling_bytes<std::int8_t>()},   {"uint8", telling_bytes<std::uint8_t>()},
      {"int16", telling_bytes<std::int16_t>()}, {"uint16", telling_bytes<std::uint16_t>()},
      {"int32", telling_bytes<std::int32_t>()}, {"uint32", telling_bytes<std::uint32_t>()},
      {"int64", telling_bytes<std::int64_t>()}, {"uint64", telling_bytes<std::uint64_t>()},
      {"float", telling_bytes<float>()},        {"double", telling_bytes<double>()}};
  for (const auto& [type, pixels] : types) {
    EXPECT_EQ(read("a.nrrd", Nrrd{.type = type, .pixels = pixels}.bytes()).values, telling_floats()) << type;
  }
  EXPECT_EQ(read("a.nii", Nifti{.datatype = 16, .bits = 32, .pixels = telling_bytes<float>()}.bytes()).values,
            telling_floats());
  EXPECT_EQ(read("a.mha", MetaImage{.type = "MET_SHORT", .pixels = telling_bytes<std::int16_t>()}.bytes()).values,
            telling_floats());
}

TEST(ReadVolume, RescalesAsTheHeaderSays) {
  const Volume volume = read("a.nii", Nifti{.slope = 2, .intercept = -5}.bytes());
  EXPECT_EQ(volume.values.front(), -3);
  EXPECT_EQ(volume.values.back(), 115);
}

TEST(ReadVolume, TakesSpacingAndOriginInTheFilesAxes) {
  const Volume volume = read("a.mha", MetaImage{.more = "ElementSpacing = 0.5 0.25 2\nOffset = 1 2 3\n"}.bytes());
  EXPECT_EQ(volume.spacing, (std::array<double, 3>{0.5, 0.25, 2}));
  EXPECT_EQ(volume.origin, (Point3{1, 2, 3}));
  const Volume other = read("a.mha", MetaImage{.more = "ElementSpacing = 0.5 0.25 2\nOffset = 1 2 3\n"}.bytes(),
                            {.spacing = std::array<double, 3>{7, 8, 9}});
  EXPECT_EQ(other.spacing, (std::array<double, 3>{7, 8, 9}));
  EXPECT_EQ(other.origin, (Point3{1, 2, 3}));
}

/// Value of the voxel whose centre is at `at`, or -1.
float value_at(const Volume& volume, const std::array<double, 3>& at) {
  const std::array<double, 3> origin{volume.origin.x, volume.origin.y, volume.origin.z};
  std::array<std::size_t, 3> n{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double index = (at[axis] - origin[axis]) / volume.spacing[axis];
    if (std::abs(index - std::round(index)) > 1e-6 || index < -0.5 || index > double(volume.size[axis]) - 0.5)
      return -1;
    n[axis] = std::size_t(std::lround(index));
  }
  return volume.slice(n[2])[n[1] * volume.size[0] + n[0]];
}

TEST(ReadVolume, PutsEveryVoxelWhereTheFileSaysForAllOrdersAndHandsOfAxes) {
  constexpr std::array<double, 3> spacing{0.5, 2, 3};
  std::array<std::size_t, 3> along{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      std::array<std::array<double, 3>, 3> axes{};
      std::string directions = "space: left-posterior-superior\nspace directions:";
      for (std::size_t n = 0; n < 3; ++n) {
        axes[n][along[n]] = (signs >> n & 1) != 0 ? -spacing[n] : spacing[n];
        directions += " (" + std::to_string(axes[n][0]) + "," + std::to_string(axes[n][1]) + "," +
                      std::to_string(axes[n][2]) + ")";
      }
      const Volume volume = read("a.nrrd", Nrrd{.more = directions + "\nspace origin: (7,8,9)\n"}.bytes());
      for (std::size_t v = 0; v < telling_voxels().size(); ++v) {
        const std::array<double, 3> index{double(v % 5), double(v / 5 % 4), double(v / 20)};
        std::array<double, 3> at{7, 8, 9};
        for (std::size_t n = 0; n < 3; ++n) {
          for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += index[n] * axes[n][axis];
        }
        ASSERT_EQ(value_at(volume, at), float(1 + v)) << directions;
      }
    }
  } while (std::next_permutation(along.begin(), along.end()));
}

TEST(ReadVolume, TurnsOtherConventionsIntoLeftPosteriorSuperior) {
  const Volume nrrd =
      read("a.nrrd", Nrrd{.more = "space: right-anterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
                                  "space origin: (7,8,9)\n"}
                         .bytes());
  const Volume nifti = read("a.nii", Nifti{.sform = 1, .srow = {1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 1, 9}}.bytes());
  for (const Volume* volume : {&nrrd, &nifti}) {
    EXPECT_EQ(value_at(*volume, {-7, -8, 9}), 1);
    EXPECT_EQ(value_at(*volume, {-8, -8, 9}), 2);
    EXPECT_EQ(value_at(*volume, {-7, -9, 9}), 6);
    EXPECT_EQ(value_at(*volume, {-7, -8, 10}), 21);
  }
}

TEST(ReadVolume, ReadsAnObliqueImageInItsOwnFrameAndSaysItsTilt) {
  // 30 degrees about z, and the same left-handed: the turn is dropped, the hand is kept.
  const double c = std::sqrt(0.75), s = 0.5;
  const auto directions = [&](double hand) {
    return "space: left-posterior-superior\nspace directions: (" + std::to_string(hand * c) + "," +
           std::to_string(hand * s) + ",0) (" + std::to_string(-s) + "," + std::to_string(c) +
           ",0) (0,0,1)\nspace origin: (7,8,9)\n";
  };
  const Volume right = read("a.nrrd", Nrrd{.more = directions(1)}.bytes());
  EXPECT_NEAR(right.tilt_degrees, 30, 1e-3);
  EXPECT_EQ(right.values, telling_floats());
  EXPECT_EQ(right.origin, (Point3{7, 8, 9}));
  const Volume left = read("a.nrrd", Nrrd{.more = directions(-1)}.bytes());
  EXPECT_NEAR(left.tilt_degrees, 30, 1e-3);
  EXPECT_EQ(value_at(left, {7, 8, 9}), 1);  // the first voxel stays
  EXPECT_EQ(value_at(left, {6, 8, 9}), 2);  // and its neighbour along x is on the other side
  EXPECT_EQ(value_at(left, {7, 9, 9}), 6);
}

TEST(ReadVolume, RefusesAFileThatIsNotThereOrNone) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_volume((folder / "nothing.nrrd").string()), FileError);
  EXPECT_THROW(read_volume("/dev/null"), FileError);
  put(folder / "a.mhd", MetaImage{.data_file = "nothing.raw", .pixels = ""}.bytes());
  EXPECT_THROW(read_volume((folder / "a.mhd").string()), FileError);
  put(folder / "b.mhd", MetaImage{.data_file = "/dev/zero", .pixels = ""}.bytes());
  EXPECT_THROW(read_volume((folder / "b.mhd").string(), {.allow_outside = true}), FileError);
  put(folder / "c.nhdr", Nrrd{.more = "data file: nothing.raw\n", .pixels = ""}.bytes());
  EXPECT_THROW(read_volume((folder / "c.nhdr").string()), FileError);
}

}  // namespace
}  // namespace odontoscope::test
