// The whole way from a file to a stack, and the words of its command line.

#include "recon/volume/volume_contours.h"

#include <gtest/gtest.h>

#include "recon/core/error.h"
#include "tests/output/temporary_folder.h"
#include "tests/volume/volume_files.h"
#include "tests/volume/volumes.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

TEST(VolumeContours, MixIsoValuesAndLabelsAndSimplify) {
  const TemporaryFolder folder;
  put(folder / "a.nrrd", Nrrd{}.bytes());
  VolumeContourOptions options;
  options.isos = {{30.5, "high"}};
  options.labels = {{7, "seven"}, {27, "same place above"}};
  options.simplify = SimplifyContoursOptions{0.01};
  options.spacing = std::array<double, 3>{2, 2, 5};
  const VolumeContours result = contours_from_volume((folder / "a.nrrd").string(), options);
  EXPECT_EQ(result.volume.size, telling_size);
  EXPECT_EQ(result.volume.range.lowest, 1);
  EXPECT_EQ(result.volume.range.highest, 60);
  EXPECT_EQ(result.volume.spacing, (std::array<double, 3>{2, 2, 5}));
  ASSERT_EQ(result.stack.slices.size(), 3u);
  EXPECT_EQ(result.stack.slices[2].z, 10);
  ASSERT_EQ(result.levels.size(), 3u);
  EXPECT_EQ(result.levels[1].contours, 1u);
  EXPECT_TRUE(covers(result.stack.slices[0], "seven", {2, 2}));
  EXPECT_TRUE(covers(result.stack.slices[1], "same place above", {2, 2}));
  EXPECT_TRUE(covers(result.stack.slices[2], "high", {2, 2}));
  EXPECT_FALSE(covers(result.stack.slices[0], "high", {2, 2}));
  ASSERT_TRUE(result.simplification);
  EXPECT_LT(result.simplification->points_after, result.simplification->points_before);
  for (const char* structure : {"seven", "high"}) EXPECT_EQ(faults(only(result.stack, structure)), "");
}

TEST(VolumeContours, NameTheFileInEveryError) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.nrrd").string();
  put(path, Nrrd{}.bytes());
  VolumeContourOptions options;
  options.isos = {{900, "tooth"}};
  try {
    contours_from_volume(path, options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.cause(), "nothing-crosses-iso");
    EXPECT_EQ(error.place().file, path);
  }
}

TEST(VolumeContours, ParseTheirOptions) {
  EXPECT_EQ(parse_iso_level("120").threshold, 120);
  EXPECT_EQ(parse_iso_level("120").structure, "tooth");
  EXPECT_EQ(parse_iso_level("-1.5e2=dentine").threshold, -150);
  EXPECT_EQ(parse_iso_level("-1.5e2=dentine").structure, "dentine");
  EXPECT_EQ(parse_iso_level("1=a=b").structure, "a=b");
  EXPECT_EQ(parse_label_level("3").structure, "label-3");
  EXPECT_EQ(parse_label_level("3=pulp").label, 3);
  EXPECT_EQ(parse_label_level("3=pulp").structure, "pulp");
  EXPECT_EQ(parse_spacing("0.12,1e-1,2"), (std::array<double, 3>{0.12, 0.1, 2}));
  for (const char* text : {"", "x", "1x", "nan", "inf", "1=", "=a", "1=a\n"})
    EXPECT_THROW(parse_iso_level(text), UsageError) << text;
  for (const char* text : {"", "1.5", "x", "3=", "99999999999999999999"})
    EXPECT_THROW(parse_label_level(text), UsageError) << text;
  for (const char* text :
       {"", "1", "1,2", "1,2,3,4", "1,2,0", "1,2,-3", "1,2,nan", "1,,3", "1,2,3,", "a,b,c", "1,2,3mm"}) {
    EXPECT_THROW(parse_spacing(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace odontoscope::test
