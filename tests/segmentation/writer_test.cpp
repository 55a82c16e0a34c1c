// Identifiers and numbers of DICOM.

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

#include "recon/core/error.h"
#include "recon/segmentation/derived_uid.h"
#include "recon/segmentation/dicom_common.h"
#include "recon/segmentation/dicom_writer.h"

namespace odontoscope {
namespace {

std::string hex(const std::array<std::uint8_t, 20>& digest) {
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

TEST(DerivedUids, AreOfSha1) {
  EXPECT_EQ(hex(sha1("abc")), "a9993e364706816aba3e25717850c26c9cd0d89d");  // FIPS 180's own examples
  EXPECT_EQ(hex(sha1("")), "da39a3ee5e6b4b0d3255bfef95601890afd80709");
  EXPECT_EQ(hex(sha1("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "84983e441c3bd26ebaae4aa1f95129e5e54670f1");
  EXPECT_EQ(hex(sha1(std::string(1'000'000, 'a'))), "34aa973cd4c4daa4f61eeb2bdbad27316534016f");
}

TEST(DerivedUids, DependOnContentAndRoleAlone) {
  const DerivedUid one("one");
  EXPECT_EQ(one.of("series"), DerivedUid("one").of("series"));
  EXPECT_NE(one.of("series"), one.of("instance"));
  EXPECT_NE(one.of("series"), DerivedUid("other").of("series"));
  for (int n = 0; n < 1000; ++n) {
    const std::string uid = DerivedUid(std::to_string(n)).of("instance");
    ASSERT_TRUE(is_uid(uid));
    ASSERT_TRUE(uid.starts_with("2.25."));
    ASSERT_NE(uid[5], '0');
  }
}

TEST(DerivedUids, AreToldFromWhatIsNone) {
  for (const char* wrong : {"", "1.2.", ".1", "1.2a", "1 2"}) EXPECT_FALSE(is_uid(wrong)) << wrong;
  EXPECT_FALSE(is_uid(std::string(65, '1')));
  EXPECT_TRUE(is_uid("1.2.840.10008.1.2"));
}

TEST(DecimalStrings, HaveSixteenCharactersAtMost) {
  EXPECT_EQ(decimal_string(0.0), "0");
  EXPECT_EQ(decimal_string(-0.0), "0");
  EXPECT_EQ(decimal_string(12), "12");
  EXPECT_EQ(decimal_string(0.1), "0.1");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-12, 6), part(-1, 1);
  for (int n = 0; n < 20'000; ++n) {
    const double value = part(random) * std::pow(10, exponent(random));
    const std::string text = decimal_string(value);
    ASSERT_LE(text.size(), 16u) << text;
    ASSERT_NEAR(std::strtod(text.c_str(), nullptr), value, std::max(std::abs(value) * 5e-10, 1e-15)) << text;
    if (std::abs(value) < 0.1) continue;
    ASSERT_NEAR(std::strtod(text.c_str(), nullptr), value, std::abs(value) * 5e-13) << text;
  }
}

TEST(DicomNames, AreShortAndDifferent) {
  const std::string longer(70, 'a');
  const auto names = dicom_names({longer, longer + "b", "back\\slash"});
  EXPECT_EQ(names[0], std::string(64, 'a'));
  EXPECT_EQ(names[1], std::string(60, 'a') + " (2)");
  EXPECT_EQ(names[2], "back/slash");
}

TEST(DicomWriting, TellsWhatIsTooLong) {
  DicomWriter data;
  data.text(0x00080016, "UI", "1.2").text(0x00080018, "UI", "1.3").text(0x30060050, "DS", std::string(70'000, '1'));
  EXPECT_NO_THROW(data.file(DicomCoding::implicit_little));
  EXPECT_THROW(data.file(DicomCoding::explicit_little), InternalError);
}

}  // namespace
}  // namespace odontoscope
