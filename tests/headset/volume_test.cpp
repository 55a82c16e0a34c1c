// Grey values in the headset: both eyes see what the desktop casts, and the beat decides how finely.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "engine/headset/eye_painter.h"
#include "engine/view/offscreen.h"
#include "tests/headset/drawing.h"
#include "tests/headset/worlds.h"

namespace odontoscope::testing_support {
namespace {

TEST(AVolumesPace, BecomesCoarserAtOnceAndFinerByAndBy) {
  VolumePace pace;
  pace.took(0.004, 0.011);
  EXPECT_EQ(pace.coarseness(), 1);
  pace.took(0.022, 0.011);  // a picture is missed
  EXPECT_GT(pace.coarseness(), 1.5);
  const double coarse = pace.coarseness();
  pace.took(0.006, 0.011);  // it just keeps up
  EXPECT_EQ(pace.coarseness(), coarse);
  pace.took(0.003, 0.011);
  EXPECT_LT(pace.coarseness(), coarse);
  EXPECT_GT(pace.coarseness(), 0.9 * coarse);
  for (int i = 0; i < 100; ++i) pace.took(0.003, 0.011);
  EXPECT_EQ(pace.coarseness(), 1);
  for (int i = 0; i < 100; ++i) pace.took(5, 0.011);
  EXPECT_EQ(pace.coarseness(), VolumePace::coarsest);
  pace.took(0, 0.011);
  pace.took(0.001, 0);
  EXPECT_EQ(pace.coarseness(), VolumePace::coarsest);
}

/// The balls' CT: dense in the dentine, less in the pulp, nothing around; no plane of symmetry.
std::shared_ptr<const ValueGrid> balls_ct() {
  ValueGrid grid;
  grid.size = {40, 44, 42};
  grid.first_mm = {-5, -4.6, 23.7};
  grid.step_mm = {0.31, 0.3, 0.3};
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i) {
        const glm::dvec3 off = grid.first_mm + grid.step_mm * glm::dvec3(i, j, k) - glm::dvec3(1, 2, 30);
        const double far = glm::length(off), dense = far < 2 ? 60 : 150 + 8 * off.x - 5 * off.z;
        grid.values.push_back(static_cast<float>(dense * std::clamp(5.5 - far, 0.0, 1.0)));
      }
  grid.range = {0, 200};
  grid.usual = {0, 200};
  return std::make_shared<const ValueGrid>(std::move(grid));
}

class VolumeInTheHeadset : public Drawing {
 protected:
  static constexpr PixelSize size{160, 150};
  const BallWorld& balls = BallWorld::once();
  const std::shared_ptr<const ValueGrid> values = balls_ct();
  Framebuffer pixels[2];
  HeadsetInput input = person();
  Visit visit;

  void begin() override {
    for (Framebuffer& eye : pixels) eye = Framebuffer(context->gl(), {size, {GL_SRGB8_ALPHA8}, GL_DEPTH_COMPONENT32F});
    input.hands = {};
    visit = advance_visit({}, input, balls.world(), {}, 0.01);
    visit.seen.told = 0;
    visit.scene.volume.transfer = {{40, colour_of(0xc04030), 0},
                                   {70, colour_of(0xc04030), 0.3},
                                   {120, colour_of(0xeec488), 0.1},
                                   {190, colour_of(0xf4f4ff), 0.6}};
  }
  Target target(std::size_t eye) const { return {pixels[eye].id(), 0, 0, size, true}; }

  std::array<Image, 2> seen(EyePainter& painter, double beat = 1e3) {
    const Target targets[2] = {target(0), target(1)};
    painter.draw(visit, input, balls.world(), eyes_of(input.head), targets, {}, {}, beat);
    return {read_pixels(context->gl(), pixels[0].id(), size), read_pixels(context->gl(), pixels[1].id(), size)};
  }

  /// As the desktop's renderer draws such a scene from where the eye is: a ray through each pixel.
  Image from_the_desktop(std::size_t eye) {
    const Gl& gl = context->gl();
    Renderer renderer(gl, ShaderLibrary{});
    const GpuModel model = upload(gl, balls.model);
    const GpuValueGrid grid = upload(gl, *values, model);
    GpuVolume volume(gl, *values, grid.field());
    Scene scene = scene_of(visit, balls.world());
    scene.background = EyeQuality{}.background;
    scene.occlusion.on = false;
    const Pane pane{view_of(visit.stage, eyes_of(input.head)[eye], balls.model), target(eye)};
    renderer.draw(model, scene, {&pane, 1}, {1, RenderOptions::Rays::every}, nullptr, nullptr, &volume);
    return read_pixels(gl, pixels[eye].id(), size);
  }

  struct Unlike {
    int worst = 0, many = 0;  // of 255; pixels off by more than two
  };
  static Unlike unlike(const Image& one, const Image& other) {
    Unlike found;
    for (std::size_t i = 0; i < one.rgba.size(); i += 4) {
      int here = 0;
      for (std::size_t channel = i; channel < i + 3; ++channel)
        here = std::max(here, std::abs(one.rgba[channel] - other.rgba[channel]));
      found.worst = std::max(found.worst, here);
      found.many += here > 2;
    }
    return found;
  }
};

TEST_F(VolumeInTheHeadset, IsWhatTheDesktopShowsFromWhereEachEyeIs) {
  for (const VolumeLook::Shows shows : {VolumeLook::Shows::volume, VolumeLook::Shows::both}) {
    show_as(shows, visit.scene);
    EyePainter painter(context->gl(), ShaderLibrary{}, balls.model, {}, values);
    const auto eyes = seen(painter);
    for (std::size_t eye = 0; eye < 2; ++eye) {
      const Unlike found = unlike(eyes[eye], from_the_desktop(eye));
      EXPECT_LE(found.worst, 6) << name(shows) << eye;
      EXPECT_LE(found.many, 8) << name(shows) << eye;  // of some 2,000: rays are told by those around them
    }
    EXPECT_GT(unlike(eyes[0], eyes[1]).many, 500);
    EyePainter without(context->gl(), ShaderLibrary{}, balls.model);
    EXPECT_GT(unlike(eyes[0], seen(without)[0]).many, 400);
  }
}

TEST_F(VolumeInTheHeadset, GreysWithoutDepthAreShownShaded) {
  show_as(VolumeLook::Shows::volume, visit.scene);
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model, {}, values);
  const Image shaded = seen(painter)[0];
  visit.scene.volume.cast = VolumeLook::Cast::radiograph;
  EXPECT_EQ(seen(painter)[0], shaded);
}

TEST_F(VolumeInTheHeadset, IsCastAsFinelyAsTheBeatLeavesTimeFor) {
  show_as(VolumeLook::Shows::volume, visit.scene);
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model, {}, values);
  const Image fine = seen(painter)[0];
  EXPECT_EQ(painter.coarseness(), 1);
  constexpr double too_fast = 1e-6;
  for (int i = 0; i < 5; ++i) seen(painter, too_fast);
  EXPECT_EQ(painter.coarseness(), VolumePace::coarsest);
  EXPECT_GT(unlike(seen(painter, too_fast)[0], fine).worst, 2);
  for (int i = 0; i < 50; ++i) seen(painter);
  EXPECT_EQ(painter.coarseness(), 1);
  EXPECT_EQ(seen(painter)[0], fine);
}

// DB in place of DT: another model, the same grey values around it.
TEST_F(VolumeInTheHeadset, StaysWhereItIsWhenTheModelChanges) {
  show_as(VolumeLook::Shows::volume, visit.scene);
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model, {}, values);
  const Image before = seen(painter)[1];
  painter.take(balls.model);
  EXPECT_EQ(seen(painter)[1], before);
}

}  // namespace
}  // namespace odontoscope::testing_support
