// The panel's section about grey values: what clicks change in the scene, and that the picture follows.
#include <chrono>
#include <cmath>
#include <thread>

#include "engine/picture/image_difference.h"
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
        grid->values.push_back(
            static_cast<float>(1700 * std::max(0.0, 1 - std::hypot((static_cast<double>(i) - 11.5) / 11,
                                                                   (static_cast<double>(j) - 10.5) / 10,
                                                                   (static_cast<double>(k) - 12.5) / 12))));
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

TEST_F(VolumePanel, HasTheUsualFilmsAndBothBeams) {
  click_control("Volume", {"volume shows"});
  click_control("X-ray", {"cast"});
  frames(3);
  const Image cone = picture();
  click_control("0", {"film"});
  EXPECT_EQ(look().film_mm, glm::dvec2(22, 35));
  EXPECT_TRUE(differs(cone));
  keep_picture("volume-x-ray-film");
  const Image film = picture();
  click_control("Parallel beam", {"beam"});
  EXPECT_TRUE(differs(film));
  EXPECT_EQ(viewer().state().scene.camera.projection, Camera::Projection::parallel);
}

TEST_F(VolumePanel, HasTransferFunctions) {
  click_control("Volume", {"volume shows"});
  const Image before = picture();
  click_control("Enamel", {"transfer"});
  EXPECT_EQ(look().transfer, transfer_of(TransferPreset::enamel, 10, 800));
  EXPECT_TRUE(differs(before));
  const double usual = look().transfer.back().extinction;
  const glm::dvec2 slider = control("Density");  // near the right end
  click(slider.x, slider.y);
  EXPECT_GT(look().transfer.back().extinction, 2 * usual);
  const double place = look().transfer.back().value;
  const glm::dvec2 dentine = control("Dentine");
  click(dentine.x, dentine.y);
  EXPECT_GT(look().transfer.back().value, place);
}

/// A place of the editor: parts of its width from the left and of its height from below.
TEST_F(VolumePanel, HasAnEditorOfTransferFunctions) {
  click_control("Volume", {"volume shows"});
  frames(3);
  const unsigned id = control_id("##transfer points");
  const auto found = [&] {
    for (const Interface::Place& place : viewer().interface().places)
      if (place.id == id) return place;
    ADD_FAILURE() << "there is no editor";
    return Interface::Place{};
  }();
  const auto at = [&](double right, double up) {
    return glm::dvec2(found.left + right * (found.right - found.left), found.bottom - up * (found.bottom - found.top));
  };
  const std::vector<TransferPoint> ready = look().transfer;
  const Image before = picture();
  const glm::dvec2 fresh = at(0.06, 0.7), moved = at(0.12, 0.9);
  click(fresh.x, fresh.y);
  ASSERT_EQ(look().transfer.size(), ready.size() + 1);
  EXPECT_NEAR(look().transfer[0].value, 0.06 * 1700, 8);
  EXPECT_NEAR(look().transfer[0].extinction, std::expm1(0.7 * std::log1p(60.0)), 1.5);
  EXPECT_TRUE(sensible(look().transfer));
  drag(fresh.x, fresh.y, moved.x, moved.y);
  EXPECT_NEAR(look().transfer[0].value, 0.12 * 1700, 20);  // the button comes up in a frame of its own
  EXPECT_GT(look().transfer[0].extinction, 30);
  EXPECT_TRUE(differs(before));
  keep_picture("transfer-editor");
  drag(moved.x, moved.y, at(0.99, 0.9).x, moved.y);  // not beyond its neighbour
  EXPECT_TRUE(sensible(look().transfer));
  EXPECT_LT(look().transfer[0].value, ready[0].value);
  const double dense = look().transfer[0].extinction;
  const glm::dvec2 density = control("Density");
  click(density.x, density.y);  // edits stay
  EXPECT_EQ(look().transfer.size(), ready.size() + 1);
  EXPECT_GT(look().transfer[0].extinction, 2 * dense);
  click_control("Remove");
  EXPECT_EQ(look().transfer.size(), ready.size());
  click_control("Tooth", {"transfer"});
  EXPECT_EQ(look().transfer.front().value, ready.front().value);
}

TEST_F(VolumePanel, ColoursSurfacesByTheirDistanceFromTheCt) {
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) {
    LoadedModel loaded = tooth_of_a_volume();
    mark_deviations(loaded.model, *loaded.values, {{"enamel", 400}});
    loaded.deviations = deviations_in(loaded.model);
    return loaded;
  }});
  frames(3);
  const Image own = picture();
  click_control("Distance", {"data colours"});
  ASSERT_TRUE(viewer().state().scene.data_colours);
  EXPECT_EQ(viewer().state().scene.data_colours->of, DataColours::Of::distance);
  EXPECT_TRUE(differs(own));
  keep_picture("distance-from-the-ct");
  const Image distance = picture();
  click_control("Slope", {"data colours"});
  EXPECT_EQ(viewer().state().scene.data_colours->of, DataColours::Of::slope);
  EXPECT_TRUE(differs(distance));
  click_control("Own colours", {"data colours"});
  EXPECT_FALSE(viewer().state().scene.data_colours);
}

// Nobody asked for them when the model was opened: they are measured once they are.
TEST_F(VolumePanel, ComparesWithTheCtWhenAsked) {
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) {
    LoadedModel loaded = tooth_of_a_volume();
    loaded.isos = {{"enamel", 400}};
    return loaded;
  }});
  frames(3);
  EXPECT_FALSE(viewer().state().shown->deviations);
  const Image own = picture();
  click_control("Distance", {"data colours"});
  for (int i = 0; i < 400 && !viewer().state().scene.data_colours; ++i) {
    frames(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(viewer().state().scene.data_colours);
  EXPECT_EQ(viewer().state().scene.data_colours->of, DataColours::Of::distance);
  EXPECT_EQ(viewer().state().scene.look_of("enamel")->opacity, 1);
  LoadedModel right = tooth_of_a_volume();
  mark_deviations(right.model, *right.values, {{"enamel", 400}});
  ASSERT_TRUE(viewer().state().shown->deviations);
  EXPECT_EQ(viewer().state().shown->deviations->median_mm, deviations_in(right.model)->median_mm);
  EXPECT_TRUE(differs(own));
  click_control("Slope", {"data colours"});  // known by now
  EXPECT_EQ(viewer().state().scene.data_colours->of, DataColours::Of::slope);
}

TEST_F(VolumePanel, ShowsBordersOnly) {
  click_control("Volume", {"volume shows"});
  frames(3);
  const Image all = picture();
  click_control("Borders only");
  const double steepest =
      1600 / std::min({viewer().state().shown->values->step_mm.x, viewer().state().shown->values->step_mm.y,
                       viewer().state().shown->values->step_mm.z});
  EXPECT_TRUE(look().slopes.count());
  EXPECT_NEAR(look().slopes.steep, 0.2 * steepest, 1e-9);
  EXPECT_TRUE(differs(all));
  keep_picture("borders-only");
  frames(2);
  const glm::dvec2 flat = control("Too flat, values/mm");  // near the right end: what is steep enough stays above
  click(flat.x, flat.y);
  EXPECT_GT(look().slopes.flat, 0.5 * steepest);
  EXPECT_TRUE(look().slopes.sensible());
  click_control("Borders only");
  EXPECT_FALSE(look().slopes.count());
}

TEST_F(VolumePanel, SlidesFromModelToData) {
  click_control("Both", {"volume shows"});
  frames(2);
  const glm::dvec2 right = control("Model to data");
  click(right.x, right.y);
  EXPECT_LT(viewer().state().scene.look_of("enamel")->opacity, 0.1f);
  const double dense = look().transfer.back().extinction;
  click(right.x - 150, right.y);
  EXPECT_GT(viewer().state().scene.look_of("enamel")->opacity, 0.3f);
  EXPECT_LT(look().transfer.back().extinction, dense);
}

TEST_F(VolumePanel, IsNotThereWithoutAVolume) {
  viewer_with_tooth();
  frames(2);
  for (const Interface::Place& place : viewer().interface().places)
    EXPECT_NE(place.id, control_id("Volume", {"volume shows"}));
}

TEST_F(VolumePanel, AnotherModelBeginsAnew) {
  click_control("Volume", {"volume shows"});
  click_control("Enamel", {"transfer"});
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) { return tooth_of_a_volume(); }});
  frames(2);
  EXPECT_FALSE(look().shows_volume());
  EXPECT_EQ(mode<VolumeMode>().layout().preset, TransferPreset::tooth);
}

}  // namespace
}  // namespace odontoscope::testing_support
