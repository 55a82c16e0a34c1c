// The panel's section about grey values: what clicks change in the scene, and that the picture follows.
#include <cmath>

#include "engine/picture/compare.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

/// The toy tooth as if it came from a volume: denser towards its middle.
LoadedModel tooth_of_a_volume() {
  LoadedModel loaded = toy_tooth();
  const Box& box = loaded.model.bounds_mm;
  auto grid = std::make_shared<ValueGrid>();
  grid->size = {24, 22, 26};
  grid->first_mm = box.low;
  grid->step_mm = (box.high - box.low) / glm::dvec3(23, 21, 25);
  for (std::size_t k = 0; k < 26; ++k)
    for (std::size_t j = 0; j < 22; ++j)
      for (std::size_t i = 0; i < 24; ++i)
        grid->values.push_back(static_cast<float>(1700 * std::max(0.0, 1 - std::hypot((static_cast<double>(i) - 11.5) / 11, (static_cast<double>(j) - 10.5) / 10, (static_cast<double>(k) - 12.5) / 12))));
  grid->range = {0, 1700};
  grid->usual = {0, 1600};
  loaded.values = grid;
  loaded.greys = GreyValues{10, 800, 0.25, {400}, 0, 1700, {1, 0.8f, 0.6f, 0.4f, 0.2f}};
  return loaded;
}

class VolumePanel : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (IsSkipped()) return;
    size_ = {760, 1500};
    viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) { return tooth_of_a_volume(); }});
  }
  const VolumeLook& look() { return viewer().state().scene.volume; }
  bool differs(const Image& before) {
    frames(3);
    return compare(picture(), before).share > 0.001;
  }
};

TEST_F(VolumePanel, ShowsSurfacesVolumeOrBoth) {
  const Image surfaces = picture();
  EXPECT_FALSE(look().shows_volume());
  click_control("Volume", {"volume shows"});
  EXPECT_EQ(look().shows, VolumeLook::Shows::volume);
  EXPECT_EQ(look().transfer, transfer_of(TransferPreset::tooth, 10, 800));
  EXPECT_TRUE(differs(surfaces));
  keep_picture("volume");
  const Image volume = picture();
  click_control("Both", {"volume shows"});
  EXPECT_EQ(look().shows, VolumeLook::Shows::both);
  EXPECT_LT(viewer().state().scene.look_of("enamel")->opacity, 0.2f);
  EXPECT_TRUE(differs(volume));
  keep_picture("volume-and-surfaces");
  click_control("Surfaces", {"volume shows"});
  EXPECT_FALSE(look().shows_volume());
}

TEST_F(VolumePanel, CastsInSeveralWays) {
  click_control("Both", {"volume shows"});
  Image before = picture();
  click_control("Maximum", {"cast"});
  EXPECT_EQ(look().cast, VolumeLook::Cast::maximum);
  EXPECT_EQ(look().shows, VolumeLook::Shows::volume) << "greys along the whole ray hide all else";
  EXPECT_EQ(look().black, 10);
  EXPECT_EQ(look().white, 1600);
  EXPECT_TRUE(differs(before));
  before = picture();
  click_control("X-ray", {"cast"});
  EXPECT_EQ(look().cast, VolumeLook::Cast::radiograph);
  EXPECT_EQ(look().white, 800);
  EXPECT_EQ(look().attenuation, 0.25);
  EXPECT_TRUE(differs(before));
  keep_picture("volume-x-ray");
  click_control("Both", {"volume shows"});
  EXPECT_EQ(look().cast, VolumeLook::Cast::shaded);
}

TEST_F(VolumePanel, HasTransferFunctions) {
  click_control("Volume", {"volume shows"});
  const Image before = picture();
  click_control("Enamel", {"transfer"});
  EXPECT_EQ(look().transfer, transfer_of(TransferPreset::enamel, 10, 800));
  EXPECT_TRUE(differs(before));
  const double usual = look().transfer.back().extinction;
  const glm::dvec2 slider = control("Density");   // near the right end
  click(slider.x, slider.y);
  EXPECT_GT(look().transfer.back().extinction, 2 * usual);
  const double place = look().transfer.back().value;
  const glm::dvec2 dentine = control("Dentine");
  click(dentine.x, dentine.y);
  EXPECT_GT(look().transfer.back().value, place);
}

TEST_F(VolumePanel, IsNotThereWithoutAVolume) {
  viewer_with_tooth();
  frames(2);
  for (const Interface::Place& place : viewer().interface().places) EXPECT_NE(place.id, control_id("Volume", {"volume shows"}));
}

TEST_F(VolumePanel, AnotherModelBeginsAnew) {
  click_control("Volume", {"volume shows"});
  click_control("Enamel", {"transfer"});
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) { return tooth_of_a_volume(); }});
  frames(2);
  EXPECT_FALSE(look().shows_volume());
  EXPECT_EQ(viewer().state().volume_layout.preset, TransferPreset::tooth);
}

}  // namespace
}  // namespace odontoscope::testing_support
