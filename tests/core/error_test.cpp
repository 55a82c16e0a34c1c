#include "recon/core/error.h"

#include <gtest/gtest.h>

namespace odontoscope {
namespace {

TEST(Errors, TellWhatIsWrongAndWhatToDoApart) {
  Place place;
  place.file = "tooth.json";
  const InputError error("too-few-points", place, "a contour of 2 points. Three are the least", "give it more");
  EXPECT_EQ(error.wrong(), "a contour of 2 points. Three are the least");
  EXPECT_EQ(error.remedy(), "Give it more.");
  EXPECT_STREQ(error.what(), "tooth.json: a contour of 2 points. Three are the least. Give it more. [too-few-points]");
}

TEST(Errors, WithoutRemedyEndInAFullStop) {
  const FileError error("tooth.glb", "cannot be written: Is this a folder?", {});
  EXPECT_EQ(error.file(), "tooth.glb");
  EXPECT_EQ(error.remedy(), "");
  EXPECT_STREQ(error.what(), "tooth.glb: cannot be written: Is this a folder?");
  EXPECT_STREQ(UsageError("two outputs", {}).what(), "two outputs.");
}

TEST(Errors, OfOursSayThatTheyAre) {
  const InternalError error("a wall is open");
  EXPECT_EQ(error.wrong(), "internal error: a wall is open");
  EXPECT_NE(error.remedy().find("bug in odontoscope"), std::string::npos);
  EXPECT_EQ(error.exit_code(), ExitCode::internal);
}

}  // namespace
}  // namespace odontoscope
