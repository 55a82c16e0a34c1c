// Does everything still look as it did? One line a golden, in golden.cpp.

#include "tests/render/golden.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/picture/png.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

constexpr std::uintmax_t most_golden_bytes = 1 << 20;  // of all together

class Goldens : public DrawingTest, public ::testing::WithParamInterface<GoldenCase> {};

std::string in_words(const ImageDifference& difference) {
  return fmt::format("{} pixels ({:.3f} %) differ by more than {}, the most by {}; {:.3f} % may; similarity {:.4f}\n",
                     difference.pixels, 100 * difference.share, golden_tolerance.channel, difference.largest,
                     100 * golden_tolerance.share, difference.similarity);
}

void leave_evidence(const GoldenCase& golden, const Image& drawn, const Image& stored,
                    const ImageDifference& difference) {
  const std::filesystem::path folder = ODONTOSCOPE_FAILED_PICTURES;
  std::filesystem::create_directories(folder);
  write_png(drawn, (folder / golden.name).string() + ".png");
  if (difference.same_size)
    write_png(difference_picture(drawn, stored), (folder / golden.name).string() + "-difference.png");
  std::ofstream((folder / golden.name).string() + ".txt") << in_words(difference);
}

TEST_P(Goldens, LookTheSame) {
  const Image drawn = draw_golden(context(), GetParam());
  const ImageContent content = content_of(drawn);
  ASSERT_TRUE(content.shows_something()) << "coverage " << content.coverage << ", colours " << content.colours;
  const std::string file = golden_file(GetParam(), ".png");
  if (std::getenv("ODONTOSCOPE_ACCEPT_GOLDENS")) write_png(drawn, file);
  const Image stored = read_png(file);
  ASSERT_TRUE(content_of(stored).shows_something());
  const ImageDifference difference = compare(drawn, stored, golden_tolerance);
  if (!difference.within_tolerance) leave_evidence(GetParam(), drawn, stored, difference);
  EXPECT_TRUE(difference.within_tolerance)
      << in_words(difference) << "see " << ODONTOSCOPE_FAILED_PICTURES << "/" << GetParam().name << ".png";
}

TEST_P(Goldens, AreDrawnTheSameTwice) {
  EXPECT_EQ(draw_golden(context(), GetParam()), draw_golden(context(), GetParam()));
}

std::string test_name(const ::testing::TestParamInfo<GoldenCase>& info) {
  std::string name = info.param.name;
  for (char& character : name) character = character == '-' ? '_' : character;
  return name;
}

INSTANTIATE_TEST_SUITE_P(Each, Goldens, ::testing::ValuesIn(golden_cases()), test_name);

TEST(GoldenFiles, AreSmallAndAllInUse) {
  std::uintmax_t bytes = 0;
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ODONTOSCOPE_GOLDENS)) {
    bytes += entry.file_size();
    pictures += entry.path().extension() == ".png";
  }
  EXPECT_LT(bytes, most_golden_bytes);
  EXPECT_EQ(pictures, golden_cases().size());
}

}  // namespace
}  // namespace odontoscope::testing_support
