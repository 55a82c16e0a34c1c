// What is remembered, and what a hostile file can do to it: nothing.
#include "engine/viewer/settings.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>

#include "recon/core/error.h"
#include "recon/core/read_file.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

Settings unusual() {
  Settings settings;
  settings.window = {1111, 777};
  settings.panel = false;
  settings.text_scale = 1.3f;
  settings.back_faces = BackFaces::tint;
  settings.projection = Camera::Projection::parallel;
  settings.backdrop = Backdrop::white;
  settings.picture = {640, 480, false, 4, true};
  settings.comfort = {90, 2.5, true, true, false, true};
  settings.looks = {{"enamel", colour_of(0x123456), 0.25f}, {"Zahnbein \xC3\xA4", colour_of(0xffffff), 0}};
  settings.hints = settings.desktop_dialogs = false;
  settings.save_folder = "/teeth/pictures of";
  settings.recent = {"/teeth/b.json", "/teeth/a.glb"};
  return settings;
}

TEST(Settings, ComeBackAsTheyWere) {
  const ReadSettings read = settings_from_json(to_json(unusual()));
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.settings, unusual());
}

TEST(Settings, OfAWindowThatWasMadeNarrowAreTaken) {
  Settings narrow;
  narrow.window = {409, 908};
  const ReadSettings read = settings_from_json(to_json(narrow));
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.settings, narrow);
}

TEST(Settings, AreNeverWrittenSoThatTheyAreRefused) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const double extreme : {-1e9, -1.0, 0.0, 1e9, nothing}) {
    Settings settings;
    const int whole = extreme > 0 ? 1'000'000'000 : extreme < 0 ? -1 : 0;
    settings.window = {whole, whole};
    settings.text_scale = static_cast<float>(extreme);
    settings.picture = {whole, whole, true, whole, false};
    settings.comfort = {extreme, extreme, true, true};
    settings.looks = {{"enamel", colour_of(0x123456), static_cast<float>(extreme)}};
    EXPECT_EQ(settings_from_json(to_json(settings)).complaint, "") << extreme;
  }
}

TEST(Settings, AreWrittenIntoAFolderThatIsNotThereYet) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "a" / "b" / "viewer.json";
  write_settings(unusual(), file);
  EXPECT_EQ(read_settings(file).settings, unusual());
}

TEST(Settings, MissingAreNoComplaint) {
  const ReadSettings read = read_settings("/no/such/file.json");
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.settings, Settings());
}

TEST(Settings, WhatMakesNoSenseIsLeftAloneAndSaid) {
  const std::string head = R"({"format":"odontoscope.viewer-settings",)";
  for (const char* wrong : {R"("window":{"width":-4})",
                            R"("window":{"width":1e300})",
                            R"("window":7)",
                            R"("panel":"yes")",
                            R"("text_scale":1000)",
                            R"("back_faces":"everything")",
                            R"("projection":3)",
                            R"("backdrop":null)",
                            R"("picture":{"samples_a_side":0})",
                            R"("picture":{"height":"tall"})",
                            R"("picture":[])",
                            R"("flight":{"field_of_view_deg":200})",
                            R"("flight":{"vignette":1})",
                            R"("flight":{"speed_limit":0})",
                            R"("looks":[])",
                            R"("looks":{"a":1})",
                            R"("looks":{"":{"colour":"#112233","opacity":1}})",
                            R"("looks":{"a":{"opacity":1}})",
                            R"("looks":{"a":{"colour":"red","opacity":1}})",
                            R"("looks":{"a":{"colour":7,"opacity":1}})",
                            R"("looks":{"a":{"colour":"#112233"}})",
                            R"("looks":{"a":{"colour":"#112233","opacity":-1}})",
                            R"("looks":{"a":{"colour":"#112233","opacity":"1"}})"}) {
    const ReadSettings read = settings_from_json(head + wrong + "}");
    EXPECT_NE(read.complaint, "") << wrong;
    EXPECT_EQ(read.settings, Settings()) << wrong;
  }
}

TEST(Settings, OneWrongMemberLeavesTheOthers) {
  const ReadSettings read =
      settings_from_json(R"({"format":"odontoscope.viewer-settings","panel":3,"backdrop":"light"})");
  EXPECT_NE(read.complaint.find("panel"), std::string::npos);
  EXPECT_EQ(read.settings.backdrop, Backdrop::light);
}

TEST(Settings, LooksAreRememberedByNameAndNotForEver) {
  Settings settings;
  for (std::size_t i = 0; i < most_remembered_looks + 3; ++i)
    remember(settings, Look{"structure " + std::to_string(i), {}, 0.5f});
  remember(settings, Look{"structure 10", colour_of(0xff0000), 0.75f});
  remember(settings, Look{std::string(most_structure_bytes + 1, 'x'), {}, 1});
  remember(settings, Look{"no text \xff", {}, 1});
  EXPECT_EQ(settings.looks.size(), most_remembered_looks);
  Scene scene;
  scene.looks = {{"structure 10", {}}, {"structure 0", {}}};
  apply_remembered(settings, scene);
  EXPECT_EQ(scene.looks[0].opacity, 0.75f);
  EXPECT_EQ(scene.looks[0].colour, colour_of(0xff0000));
  EXPECT_EQ(scene.looks[1].opacity, 1) << "forgotten";
  EXPECT_EQ(settings_from_json(to_json(settings)).settings.looks.size(), most_remembered_looks)
      << "what is no text does not spoil the file";
}

TEST(Settings, NoTextCanBreakTheReader) {
  const std::string deep(60'000, '['), sound = to_json(unusual());
  for (const std::string& text : {std::string(), std::string("null"), std::string("[]"), std::string("{"), deep,
                                  std::string(1 << 20, 'x'), std::string(100, '\0')})
    EXPECT_EQ(settings_from_json(text).settings, Settings()) << text.substr(0, 20);
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::string text = sound;
    for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random());
    const Settings read = settings_from_json(text).settings;
    EXPECT_GE(read.window.width, 640);
    EXPECT_LE(read.window.width, 16384);
    EXPECT_GE(read.picture.side, 1);
    EXPECT_LE(read.picture.side, 4);
    EXPECT_TRUE(read.text_scale >= 0.7f && read.text_scale <= 2.5f);
  }
}

TEST(Settings, AFileThatIsNoneIsLeftAside) {
  const ScratchFolder scratch;
  const auto folder = scratch.path() / "folder", pipe = scratch.path() / "pipe", large = scratch.path() / "large";
  std::filesystem::create_directory(folder);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::ofstream(large) << std::string(100'000, ' ');
  for (const auto& file : {folder, pipe, large}) {
    const ReadSettings read = read_settings(file);
    EXPECT_NE(read.complaint, "") << file;
    EXPECT_EQ(read.settings, Settings());
  }
}

TEST(Settings, AFolderThatCannotBeMadeIsAnError) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "file") << "x";
  EXPECT_THROW(write_settings({}, scratch.path() / "file" / "viewer.json"), FileError);
  EXPECT_EQ(read_file((scratch.path() / "file").string()), "x");
}

TEST(Settings, LieWhereThePlatformPutsThem) {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  const std::string before = config ? config : "";
  ::setenv("XDG_CONFIG_HOME", "/tmp/of-mine", 1);
  EXPECT_EQ(settings_file(), "/tmp/of-mine/odontoscope/viewer.json");
  ::setenv("XDG_CONFIG_HOME", "relative", 1);  // the rule: as if it were not set
  EXPECT_TRUE(settings_file().empty() || settings_file().is_absolute());
  ::unsetenv("XDG_CONFIG_HOME");
  if (const char* home = std::getenv("HOME")) {
    EXPECT_EQ(settings_file(), std::filesystem::path(home) / ".config/odontoscope/viewer.json");
  }
  if (config) ::setenv("XDG_CONFIG_HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace odontoscope::testing_support
