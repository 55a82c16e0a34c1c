// What a newcomer reads first.

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Help : public ProgramTest {};

TEST_F(Help, OfTheProgramTellsFirstStepsAndExitCodes) {
  const Ending help = odontoscope({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_TRUE(help.says("First steps"));
  EXPECT_TRUE(help.says("Exit codes"));
  for (const char* subcommand : {"sample", "contours", "reconstruct", "check", "render"})
    EXPECT_TRUE(help.says(subcommand));
  EXPECT_EQ(help.err, "");
}

TEST_F(Help, WithoutArgumentsIsShownButIsAMistake) {
  const Ending nothing = odontoscope({});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_TRUE(nothing.complains("First steps"));
  EXPECT_EQ(nothing.out, "");
}

TEST_F(Help, IsGivenToWhoeverAsksInAWord) {
  const Ending word = odontoscope({"help"}), option = odontoscope({"--help"});
  EXPECT_EQ(word.exit_code, 0);
  EXPECT_EQ(word.out, option.out);
  EXPECT_EQ(odontoscope({"help", "sample"}).out, odontoscope({"sample", "--help"}).out);
  EXPECT_EQ(odontoscope({"sample", "Premolar", "-o", "p.json"}).exit_code, 0) << "a capital is no mistake";
}

TEST_F(Help, VersionIsOneLine) {
  const Ending version = odontoscope({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.says("odontoscope 0."));
}

class HelpOf : public ProgramTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(HelpOf, TeachesByExample) {
  const Ending help = odontoscope({GetParam(), "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_TRUE(help.says("Example"));
  EXPECT_TRUE(help.says(std::string("odontoscope ") + GetParam()));
  EXPECT_TRUE(help.says("--threads") || help.says("--help"));
  std::size_t start = 0;
  while (start < help.out.size()) {  // fits a terminal that is not too narrow
    const std::size_t end = std::min(help.out.find('\n', start), help.out.size());
    EXPECT_LE(end - start, 110u) << help.out.substr(start, end - start);
    start = end + 1;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, HelpOf,
                         ::testing::Values("sample", "contours", "reconstruct", "check", "render", "web", "compare",
                                           "canal", "anatomy", "figures", "corpus", "batch", "compare-images"),
                         [](const auto& test) {
                           return std::string(test.param) == "compare-images" ? "compare_images" : test.param;
                         });

}  // namespace
}  // namespace odontoscope::testing_support
