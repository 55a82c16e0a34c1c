// Transfer functions as values: between their points, as presets, as JSON.
#include "engine/scene/volume_look.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/scene/scene_json.h"
#include "recon/core/error.h"

namespace odontoscope::test {
namespace {

const std::vector<TransferPoint> steps{{10, {0, 0, 0}, 0}, {20, {1, 0, 0}, 4}, {40, {0, 0, 1}, 0}};

TEST(VolumeLooks, RunStraightBetweenTheirPoints) {
  EXPECT_EQ(transferred(steps, 0), glm::vec4(0, 0, 0, 0));
  EXPECT_EQ(transferred(steps, 15), glm::vec4(0.5f, 0, 0, 2));
  EXPECT_EQ(transferred(steps, 30), glm::vec4(0.5f, 0, 0.5f, 2));
  EXPECT_EQ(transferred(steps, 99), glm::vec4(0, 0, 1, 0));
  EXPECT_EQ(transferred({}, 5), glm::vec4(0));
}

TEST(VolumeLooks, KnowWhereAnythingIsSeen) {
  EXPECT_FALSE(any_extinction(steps, 0, 10));
  EXPECT_TRUE(any_extinction(steps, 0, 10.5));
  EXPECT_TRUE(any_extinction(steps, 5, 50));
  EXPECT_FALSE(any_extinction(steps, 40, 50));
  EXPECT_FALSE(any_extinction({}, 0, 50));
}

TEST(VolumeLooks, AreSensibleOrNot) {
  EXPECT_TRUE(sensible(steps));
  EXPECT_FALSE(sensible({}));
  EXPECT_FALSE(sensible({{1, {}, 0}, {1, {}, 0}}));
  EXPECT_FALSE(sensible({{1, {}, -1}}));
  EXPECT_FALSE(sensible({{std::numeric_limits<double>::quiet_NaN(), {}, 0}}));
  EXPECT_FALSE(sensible({{0, {}, std::numeric_limits<double>::infinity()}}));
  EXPECT_FALSE(sensible(std::vector<TransferPoint>(65)));
}

TEST(VolumeLooks, HavePresetsThatShowWhatTheyAreCalledAfter) {
  const double air = 40, dentine = 140;
  const auto seen = [&](TransferPreset preset, double place) {
    return static_cast<double>(transferred(transfer_of(preset, air, dentine), air + place * (dentine - air)).a);
  };
  for (const char* preset : {"tooth", "enamel", "dentine", "pulp", "soft"}) {
    EXPECT_TRUE(sensible(transfer_of(transfer_named(preset), air, dentine))) << preset;
    EXPECT_EQ(seen(transfer_named(preset), 0), 0) << preset << " shows air";
  }
  EXPECT_EQ(seen(TransferPreset::enamel, 1), 0);
  EXPECT_GT(seen(TransferPreset::enamel, 1.6), 10);
  EXPECT_GT(seen(TransferPreset::dentine, 1), 10);
  EXPECT_GT(seen(TransferPreset::pulp, 0.5), 20 * seen(TransferPreset::pulp, 1));
  EXPECT_GT(seen(TransferPreset::soft, 0.3), 1);
  EXPECT_EQ(seen(TransferPreset::soft, 1), 0);
  EXPECT_GT(seen(TransferPreset::tooth, 1.6), 4 * seen(TransferPreset::tooth, 1));
  EXPECT_THROW(transfer_named("bone"), UsageError);
}

TEST(VolumeLooks, ComeBackFromJson) {
  Scene scene;
  EXPECT_EQ(to_json(scene).find("\"volume\""), std::string::npos);
  scene.volume = {VolumeLook::Shows::both,
                  VolumeLook::Cast::surface,
                  {{10, colour_of(0x102030), 0}, {20, colour_of(0xffee01), 4}},
                  {12, 90},
                  false,
                  30,
                  90,
                  0.5,
                  3,
                  true,
                  {31, 41},
                  77,
                  colour_of(0x010203)};
  EXPECT_EQ(scene_from_json(to_json(scene), Scene{}), scene);
}

TEST(VolumeLooks, RefuseJsonThatMakesNoSense) {
  const auto cause = [](const std::string& volume) {
    try {
      scene_from_json("{\"format\":\"odontoscope.scene\",\"version\":1,\"volume\":" + volume + "}", Scene{});
    } catch (const InputError& error) {
      return error.cause();
    }
    return std::string();
  };
  EXPECT_EQ(cause("{}"), "");
  EXPECT_EQ(cause("7"), "wrong-type");
  EXPECT_EQ(cause("{\"shows\":\"all\"}"), "bad-value");
  EXPECT_EQ(cause("{\"cast\":\"net\"}"), "bad-value");
  EXPECT_EQ(cause("{\"slopes\":[4,9]}"), "");
  EXPECT_EQ(cause("{\"film_mm\":[31,-41]}"), "bad-value");
  EXPECT_EQ(cause("{\"slopes\":[9,4]}"), "bad-value");
  EXPECT_EQ(cause("{\"slopes\":[-1,4]}"), "bad-value");
  EXPECT_EQ(cause("{\"transfer\":3}"), "wrong-type");
  EXPECT_EQ(cause("{\"transfer\":[{\"value\":5},{\"value\":5}]}"), "bad-value");
  EXPECT_EQ(cause("{\"transfer\":[{\"value\":5,\"extinction\":-1}]}"), "bad-value");
  EXPECT_EQ(cause("{\"window\":[5,5]}"), "bad-value");
  EXPECT_EQ(cause("{\"attenuation\":-1}"), "bad-value");
  EXPECT_EQ(cause("{\"latitude\":0}"), "bad-value");
  EXPECT_EQ(cause("{\"iso\":1e40}"), "bad-value");
}

}  // namespace
}  // namespace odontoscope::test
