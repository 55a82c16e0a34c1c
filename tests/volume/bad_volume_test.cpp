// Broken, lying and hostile volume files: one named error each, nothing on the terminal, no crash.

#include <gtest/gtest.h>

#include <limits>

#include "recon/core/error.h"
#include "recon/volume/read_volume.h"
#include "tests/output/temporary_folder.h"
#include "tests/support/random_numbers.h"
#include "tests/volume/volume_files.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

struct Bad {
  std::string name, bytes, cause;
};

std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.name << ", " << bad.cause; }

class BadVolume : public ::testing::TestWithParam<Bad> {};

TEST_P(BadVolume, IsRefusedByNameAndInSilence) {
  const Bad& bad = GetParam();
  const TemporaryFolder folder;
  const std::string path = (folder / bad.name).string();
  put(path, bad.bytes);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  std::string cause = "none", message;
  try {
    read_volume(path);
  } catch (const InputError& error) {
    cause = error.cause();
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(cause, bad.cause) << message;
  EXPECT_NE(message.find(bad.name), std::string::npos) << message;
  EXPECT_EQ(message.find("(0x"), std::string::npos) << "an address differs from run to run: " << message;
}

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

std::string floats_with(float odd_one) {
  std::vector<float> values(60, 1.0f);
  values[33] = odd_one;
  return bytes_of(values);
}

std::string cut(const std::string& bytes, std::size_t by) { return bytes.substr(0, bytes.size() - by); }

std::string directions(const std::string& vectors) {
  return "space: left-posterior-superior\nspace directions: " + vectors + "\n";
}

std::string packing(std::size_t size) {
  return "CompressedData = True\nCompressedDataSize = " + std::to_string(size) + "\n";
}

std::vector<Bad> bad_nrrd() {
  const std::string pixels = bytes_of(telling_voxels());
  return {
      {"empty.nrrd", "", "unknown-volume-format"},
      {"text.nrrd", "hello", "unknown-volume-format"},
      {"mark.nrrd", "NRRD0004", "unreadable-volume"},
      {"header.nrrd", Nrrd{}.bytes().substr(0, 60), "unreadable-volume"},
      {"short.nrrd", cut(Nrrd{}.bytes(), 1), "truncated-volume"},
      {"shortgzip.nrrd", Nrrd{.encoding = "gzip", .pixels = cut(gzip_packed(pixels), 20)}.bytes(), "truncated-volume"},
      {"badgzip.nrrd", Nrrd{.encoding = "gzip", .pixels = std::string(60, 'x')}.bytes(), "damaged-volume"},
      {"shortascii.nrrd", Nrrd{.encoding = "ascii", .pixels = "1 2 3"}.bytes(), "truncated-volume"},
      {"lying.nrrd", Nrrd{.sizes = "1000 1000 1000"}.bytes(), "truncated-volume"},
      {"lyinggzip.nrrd", Nrrd{.sizes = "1000 1000 1000", .encoding = "gzip", .pixels = gzip_packed(pixels)}.bytes(),
       "truncated-volume"},
      {"huge.nrrd", Nrrd{.sizes = "100000 100000 100000"}.bytes(), "too-many-voxels"},
      {"overflow.nrrd", Nrrd{.sizes = "4294967296 4294967296 16"}.bytes(), "too-many-voxels"},
      {"manyslices.nrrd", Nrrd{.sizes = "1 1 30000", .pixels = std::string(30000, 'a')}.bytes(), "too-many-voxels"},
      {"zero.nrrd", Nrrd{.sizes = "0 4 3"}.bytes(), "empty-volume"},
      {"oneslice.nrrd", Nrrd{.sizes = "5 12 1"}.bytes(), "single-slice"},
      {"flat.nrrd", Nrrd{.sizes = "5 12", .dimension = "2"}.bytes(), "single-slice"},
      {"time.nrrd", Nrrd{.sizes = "5 2 3 2", .dimension = "4"}.bytes(), "not-3d"},
      {"colour.nrrd",
       Nrrd{.sizes = "3 5 2 2", .dimension = "4", .more = "kinds: RGB-color domain domain domain\n"}.bytes(),
       "not-scalar"},
      {"block.nrrd", Nrrd{.type = "block", .more = "block size: 1\n"}.bytes(), "pixel-type"},
      {"nan.nrrd", Nrrd{.type = "float", .pixels = floats_with(nan_value)}.bytes(), "not-finite"},
      {"inf.nrrd", Nrrd{.type = "float", .pixels = floats_with(-std::numeric_limits<float>::infinity())}.bytes(),
       "not-finite"},
      {"toobig.nrrd", Nrrd{.type = "double", .pixels = bytes_of(std::vector<double>(60, 1e300))}.bytes(), "not-finite"},
      {"spacing.nrrd", Nrrd{.more = "spacings: -1 1 1\n"}.bytes(), "bad-spacing"},
      {"tiny.nrrd", Nrrd{.more = "spacings: 1 1 1e-9\n"}.bytes(), "bad-spacing"},
      {"shear.nrrd", Nrrd{.more = directions("(1,0,0) (0,1,0) (0,0.3,1)")}.bytes(), "sheared-volume"},
      {"flatdirection.nrrd", Nrrd{.more = directions("(0,0,0) (0,1,0) (0,0,1)")}.bytes(), "sheared-volume"},
      {"far.nrrd", Nrrd{.more = directions("(1,0,0) (0,1,0) (0,0,1)") + "space origin: (0,0,1e7)\n"}.bytes(),
       "too-large"},
      {"list.nhdr", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\nencoding: raw\ndata file: LIST\n",
       "unreadable-volume"},
      {"pattern.nhdr", Nrrd{.more = "data file: a%03d.raw 3 1 1\n", .pixels = ""}.bytes(), "unreadable-volume"}};
}

std::vector<Bad> bad_meta_image() {
  const std::string pixels = bytes_of(telling_voxels());
  const std::string packed = zlib_packed(pixels);
  return {
      {"empty.mha", "", "unknown-volume-format"},
      {"header.mha", MetaImage{}.bytes().substr(0, 60), "unreadable-volume"},
      {"short.mha", cut(MetaImage{}.bytes(), 1), "truncated-volume"},
      {"lying.mha", MetaImage{.size = "1000 1000 1000"}.bytes(), "truncated-volume"},
      {"huge.mha", MetaImage{.size = "100000 100000 100000"}.bytes(), "too-many-voxels"},
      {"overflow.mha", MetaImage{.size = "4294967296 4294967296 16"}.bytes(), "too-many-voxels"},
      {"negative.mha", MetaImage{.size = "-5 4 3"}.bytes(), "empty-volume"},
      {"fewsizes.mha", MetaImage{.size = "5 12"}.bytes(), "unreadable-volume"},
      {"manysizes.mha", MetaImage{.size = "5 4 3 1 1 1 1 1 1 1 1 1 1 1 1 1"}.bytes(), "unreadable-volume"},
      {"dimensions.mha", MetaImage{.dimensions = "1000000"}.bytes(), "not-3d"},
      {"negativedimensions.mha", MetaImage{.dimensions = "-3"}.bytes(), "unreadable-volume"},
      {"twice.mha", MetaImage{.more = "NDims = 10\n"}.bytes(), "unreadable-volume"},
      {"colon.mha", MetaImage{.more = "NDims : 10\n"}.bytes(), "unreadable-volume"},
      {"longline.mha", MetaImage{.more = "Comment = " + std::string(5000, 'x') + "\n"}.bytes(), "unreadable-volume"},
      {"channels.mha", MetaImage{.more = "ElementNumberOfChannels = 3\n"}.bytes(), "not-scalar"},
      {"negativechannels.mha", MetaImage{.more = "ElementNumberOfChannels = -3\n"}.bytes(), "unreadable-volume"},
      {"type.mha", MetaImage{.type = "MET_STRING"}.bytes(), "pixel-type"},
      {"headersize.mha", MetaImage{.more = "HeaderSize = 10\n"}.bytes(), "unreadable-volume"},
      {"spacing.mha", MetaImage{.more = "ElementSpacing = 1 0 1\n"}.bytes(), "bad-spacing"},
      {"nanspacing.mha", MetaImage{.more = "ElementSpacing = 1 nan 1\n"}.bytes(), "unreadable-volume"},
      {"matrix.mha", MetaImage{.more = "TransformMatrix = 1 0 0 0 1 0 0 0 inf\n"}.bytes(), "unreadable-volume"},
      {"shear.mha", MetaImage{.more = "TransformMatrix = 1 0 0 0.5 0.8 0 0 0 1\n"}.bytes(), "sheared-volume"},
      {"nan.mha", MetaImage{.type = "MET_FLOAT", .pixels = floats_with(nan_value)}.bytes(), "not-finite"},
      {"shortpacked.mha", MetaImage{.more = packing(packed.size()), .pixels = cut(packed, 20)}.bytes(),
       "truncated-volume"},
      {"fewpacked.mha", MetaImage{.more = packing(packed.size() - 20), .pixels = packed}.bytes(), "truncated-volume"},
      {"nopackedsize.mha", MetaImage{.more = "CompressedData = True\n", .pixels = cut(packed, 20)}.bytes(),
       "truncated-volume"},
      {"hugepacked.mha", MetaImage{.more = packing(99999999999999), .pixels = packed}.bytes(), "unreadable-volume"},
      {"badpacked.mha", MetaImage{.more = packing(60)}.bytes(), "damaged-volume"},
      {"list.mhd", MetaImage{.data_file = "LIST", .pixels = ""}.bytes(), "unreadable-volume"},
      {"pattern.mhd", MetaImage{.data_file = "a%s.raw 1 3 1", .pixels = ""}.bytes(), "unreadable-volume"}};
}

std::vector<Bad> bad_nifti() {
  const float infinite = std::numeric_limits<float>::infinity();
  return {{"empty.nii", "", "unknown-volume-format"},
          {"header.nii", Nifti{}.bytes().substr(0, 200), "unknown-volume-format"},
          {"short.nii", cut(Nifti{}.bytes(), 1), "truncated-volume"},
          {"short.nii.gz", gzip_packed(cut(Nifti{}.bytes(), 1)), "truncated-volume"},
          {"lying.nii", Nifti{.dim = {3, 1000, 1000, 500, 1, 1, 1, 1}}.bytes(), "truncated-volume"},
          {"lying.nii.gz", gzip_packed(Nifti{.dim = {3, 1000, 1000, 500, 1, 1, 1, 1}}.bytes()), "truncated-volume"},
          {"huge.nii", Nifti{.dim = {3, 32767, 32767, 32767, 1, 1, 1, 1}}.bytes(), "too-many-voxels"},
          {"negative.nii", Nifti{.dim = {3, -5, 4, 3, 1, 1, 1, 1}}.bytes(), "empty-volume"},
          {"dimensions.nii", Nifti{.dim = {9, 5, 4, 3, 1, 1, 1, 1}}.bytes(), "unreadable-volume"},
          {"time.nii", Nifti{.dim = {4, 5, 2, 3, 2, 1, 1, 1}}.bytes(), "not-3d"},
          {"colour.nii", Nifti{.dim = {3, 5, 2, 2, 1, 1, 1, 1}, .datatype = 128, .bits = 24}.bytes(), "not-scalar"},
          {"type.nii", Nifti{.datatype = 1536, .bits = 128}.bytes(), "pixel-type"},
          {"spacing.nii", Nifti{.pixdim = {1, 1, 0, 1}}.bytes(), "bad-spacing"},
          {"nanspacing.nii", Nifti{.pixdim = {1, 1, nan_value, 1}}.bytes(), "bad-spacing"},
          {"offset.nii", Nifti{.vox_offset = nan_value}.bytes(), "unreadable-volume"},
          {"negativeoffset.nii", Nifti{.vox_offset = -5}.bytes(), "unreadable-volume"},
          {"faroffset.nii", Nifti{.vox_offset = 1e6}.bytes(), "truncated-volume"},
          {"nansform.nii", Nifti{.sform = 1, .srow = {nan_value, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}.bytes(),
           "unreadable-volume"},
          {"shear.nii", Nifti{.sform = 1, .srow = {1, 0.3f, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}.bytes(), "sheared-volume"},
          {"infsform.nii", Nifti{.sform = 1, .srow = {1, 0, 0, infinite, 0, 1, 0, 0, 0, 0, 1, 0}}.bytes(),
           "unreadable-volume"},
          {"nan.nii", Nifti{.datatype = 16, .bits = 32, .pixels = floats_with(nan_value)}.bytes(), "not-finite"},
          {"nan.nii.gz", gzip_packed(Nifti{.datatype = 16, .bits = 32, .pixels = floats_with(nan_value)}.bytes()),
           "not-finite"},
          {"analyze.hdr", Nifti{.magic = "abc", .pixels = ""}.bytes().substr(0, 348), "unreadable-volume"}};
}

INSTANTIATE_TEST_SUITE_P(Nrrd, BadVolume, ::testing::ValuesIn(bad_nrrd()));
INSTANTIATE_TEST_SUITE_P(MetaImage, BadVolume, ::testing::ValuesIn(bad_meta_image()));
INSTANTIATE_TEST_SUITE_P(Nifti, BadVolume, ::testing::ValuesIn(bad_nifti()));

/// Whatever a few changed bytes do to a header, it is an Error or a volume, never anything else.
TEST(BadVolumes, OfAnyOtherKindEndInAnErrorOrAVolume) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> seeds{
      {"a.nrrd", Nrrd{}.bytes()},
      {"a.mha", MetaImage{.more = "ElementSpacing = 1 1 1\n"}.bytes()},
      {"a.nii", Nifti{.sform = 1}.bytes()}};
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    RandomNumbers random(seed);
    auto [name, bytes] = seeds[seed % seeds.size()];
    for (int change = random.whole(1, 3); change > 0; --change) {
      bytes[std::size_t(random.below(int(bytes.size())))] = char(random.below(256));
    }
    put(folder / name, bytes);
    try {
      validate_volume(read_volume((folder / name).string()));
    } catch (const InputError& error) {
      EXPECT_FALSE(error.cause().empty());
    } catch (const FileError&) {
      // A changed name of a data file.
    }
  }
}

}  // namespace
}  // namespace odontoscope::test
