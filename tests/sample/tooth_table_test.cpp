#include "recon/sample/tooth_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "recon/core/error.h"

using namespace odontoscope;
using namespace odontoscope::sample;

namespace {

std::string table(const std::string& tooth) {
  std::ifstream file(std::string(ODONTOSCOPE_SOURCE) + "/assets/teeth/" + tooth + ".json", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The molar's table with one place changed.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = table("molar");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string cause_of(const std::string& text) {
  try {
    read_tooth_table(text, "my-tooth.json");
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("my-tooth.json"), std::string::npos) << error.what();
    return std::string(error.cause());
  }
  return "read";
}

}  // namespace

TEST(ToothTable, TheProgramHasTheTablesOfTheTree) {
  for (const ToothKind kind : {ToothKind::molar, ToothKind::premolar, ToothKind::incisor}) {
    const ToothShape built_in = tooth_shape(kind), read = read_tooth_table(table(name(kind)), "a");
    EXPECT_EQ(built_in.kind, kind);
    EXPECT_EQ(read.tooth, built_in.tooth);
    EXPECT_EQ(read.canals.size(), built_in.canals.size());
    EXPECT_EQ(read.sides.mesial(16), built_in.sides.mesial(16));
  }
}

TEST(ToothTable, HoldsWhatItSays) {
  const ToothShape molar = tooth_shape(ToothKind::molar);
  EXPECT_EQ(molar.fdi, "36");
  EXPECT_EQ(molar.proportions.crown_mesiodistal, 11);
  EXPECT_EQ(molar.occlusal.cusps.size(), 5u);
  EXPECT_EQ(molar.occlusal.cusps[2].along.y, 0.82);
  EXPECT_EQ(molar.occlusal.cusps[0].along.x, 1) << "as usual, since nothing is said";
  EXPECT_EQ(molar.occlusal.ridges[1].crest.size(), 4u);
  EXPECT_EQ(molar.sides.furrows[1].side, Side::buccal);
  EXPECT_EQ(molar.roots[1].lobe_offset(5), 0);
  EXPECT_EQ(molar.canals[2].root, 1u);
  EXPECT_EQ(molar.chamber.high.z, 15.6);
  EXPECT_EQ(tooth_shape(ToothKind::incisor).landmarks.size(), 2u);
  EXPECT_EQ(tooth_shape(ToothKind::incisor).enamel.dentine_edge.size(), 1u);
  EXPECT_EQ(molar.steep.front().high, 21.5);
}

TEST(ToothTable, IsRefusedLikeAnyInput) {
  EXPECT_EQ(cause_of(table("molar")), "read");
  EXPECT_EQ(cause_of("{"), "unparsable");
  EXPECT_EQ(cause_of(changed("odontoscope.tooth", "odontoscope.stack")), "wrong-format");
  EXPECT_EQ(cause_of(changed("\"version\": 1", "\"version\": 2")), "wrong-version");
  EXPECT_EQ(cause_of(changed("\"top_z\"", "\"height\"")), "unknown-key");
  EXPECT_EQ(cause_of(changed("\"top_z\": 21.5,", "")), "missing-key");
  EXPECT_EQ(cause_of(changed("\"top_z\": 21.5", "\"top_z\": \"high\"")), "wrong-type");
  EXPECT_EQ(cause_of(changed("\"top_z\": 21.5", "\"top_z\": 1e9")), "bad-value");
  EXPECT_EQ(cause_of(changed("\"side\": \"buccal\"", "\"side\": \"left\"")), "bad-value");
  EXPECT_EQ(cause_of(changed("\"kind\": \"molar\"", "\"kind\": \"canine\"")), "bad-value");
  EXPECT_EQ(cause_of(changed("\"root\": 1", "\"root\": 2")), "bad-value");
  EXPECT_EQ(cause_of(changed("[2.6, 2.75, 21.1]", "[2.6, 2.75]")), "bad-value");
  EXPECT_EQ(cause_of(changed("[[18.4, 21.5]]", "[[21.5, 18.4]]")), "bad-value");
  EXPECT_EQ(cause_of(changed("[[12, 4.35], [14, 4.5]", "[[14, 4.35], [14, 4.5]")), "bad-profile");
  EXPECT_EQ(cause_of(changed("[[0, -0.1], [14, 0]]", "[]")), "bad-profile");
  std::string many;
  for (int i = 0; i < 70; ++i) many += "{\"name\": \"a\", \"at\": [0, 0, 0]}" + std::string(i < 69 ? ", " : "");
  std::string text = table("molar");
  text.insert(text.rfind('}'), ", \"landmarks\": [" + many + "]");
  EXPECT_EQ(cause_of(text), "too-many");
}
