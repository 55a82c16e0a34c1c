// What a runtime is handed besides colours: depths that mean what they say, and what is left out because lenses hide
// it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "engine/gpu/context.h"
#include "engine/headset/eye_painter.h"
#include "engine/picture/image.h"
#include "engine/view/offscreen.h"
#include "tests/headset/worlds.h"
#include "tests/openxr/with_fake_runtime.h"

namespace odontoscope::testing_support {
namespace {

constexpr const char* depth_extension = "XR_KHR_composition_layer_depth";
constexpr const char* mask_extension = "XR_KHR_visibility_mask";
constexpr int side = 128;

/// A head that looks at a ball in a ball, with a runtime that takes all that is offered.
class HandedOver : public WithFakeRuntime {
 protected:
  BallWorld balls;
  Visit visit;

  void SetUp() override {
    WithFakeRuntime::SetUp();
    if (!context) return;
    runtime.side = side;
    runtime.extensions.insert(runtime.extensions.end(), {depth_extension, mask_extension});
  }

  void open() {
    headset = open_headset(context->gl(), {});
    for (const XrSessionState state :
         {XR_SESSION_STATE_READY, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED})
      runtime.tell(state);
    headset->poll();
  }
  /// One frame; the left eye's picture.
  Image draw(EyePainter& painter) {
    Image left;
    headset->frame([&](const HeadsetFrame& frame) {
      HeadsetInput input = frame.input;
      input.hands = {};
      if (!visit.placed) visit = advance_visit({}, input, balls.world(), {}, 0.01);
      visit.seen.told = 0;  // no figures beside the ball
      const Depths depths = painter.draw(visit, input, balls.world(), frame.eyes, frame.targets, {}, frame.hidden);
      eyes_ = frame.eyes;
      left = read_pixels(context->gl(), frame.targets[0].framebuffer, frame.targets[0].size);
      return depths;
    });
    return left;
  }
  /// What lies in the swapchain that the runtime got with the eye's last picture, at a pixel from the lower left
  /// corner: metres ahead of the eye.
  double metres_ahead(std::size_t eye, int x, int y) const {
    const FakeFrame::Depth& depth = runtime.ended.back().depths.at(eye);
    const FakeSwapchain& swapchain = runtime.swapchains.at(reinterpret_cast<std::size_t>(depth.swapchain) - 1);
    std::vector<float> stored(side * side);
    const Gl& gl = context->gl();
    gl.BindTexture(GL_TEXTURE_2D, swapchain.images.at(static_cast<std::size_t>(depth.image)));
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, stored.data());
    const double z = (stored.at(static_cast<std::size_t>(y * side + x)) - depth.low) / (depth.high - depth.low);
    if (z >= 1) return std::numeric_limits<double>::infinity();
    return depth.near_z * depth.far_z /
           (depth.far_z - z * (depth.far_z - depth.near_z));  // OpenXR's words on nearZ and farZ
  }
  /// Of a ball of so many millimetres, by geometry alone, at a place in pixels; infinity where it is not met.
  double foretold(std::size_t eye, double x, double y, double radius_mm) const {
    const EyeView& view = eyes_.at(eye);
    const auto tangent = [](double low, double high, double share) {
      return std::tan(low) + share * (std::tan(high) - std::tan(low));
    };
    const glm::dvec3 way(tangent(view.field.left, view.field.right, x / side),
                         tangent(view.field.down, view.field.up, y / side), -1);
    const glm::dvec3 centre = glm::conjugate(view.pose.turn) * (to_room(visit.stage, {1, 2, 30}) - view.pose.position);
    const double radius = radius_mm / mm_per_metre(visit.stage);
    const double a = glm::dot(way, way), b = glm::dot(way, centre), c = glm::dot(centre, centre) - radius * radius;
    const double root = b * b - a * c;
    return root < 0 ? std::numeric_limits<double>::infinity() : (b - std::sqrt(root)) / a;  // the way is 1 long ahead
  }

  std::vector<EyeView> eyes_;
};

TEST_F(HandedOver, DepthsAreWhereTheNearestSurfaceIsInTheRoom) {
  open();
  for (const int samples : {1, 2})
    for (const float opacity : {1.0f, 0.3f}) {
      for (Look& look : balls.scene.looks) look.opacity = look.structure == "dentine" ? opacity : 1;
      EyePainter painter(context->gl(), ShaderLibrary{}, balls.model, {.side = samples});
      draw(painter);
      ASSERT_EQ(runtime.ended.back().depths.size(), 2u);
      int met = 0, missed = 0;
      for (std::size_t eye = 0; eye < 2; ++eye)
        for (int y = 0; y < side; y += 5)
          for (int x = 0; x < side; x += 5) {
            const double there = metres_ahead(eye, x, y), within = foretold(eye, x + 0.5, y + 0.5, 4.5),
                         without = foretold(eye, x + 0.5, y + 0.5, 5.3);
            if (std::isinf(without)) {
              EXPECT_TRUE(std::isinf(there)) << x << ' ' << y;
              ++missed;
            } else if (!std::isinf(within)) {
              const auto [nearest, farthest] =
                  std::minmax({foretold(eye, x, y, 5), foretold(eye, x + 1, y, 5), foretold(eye, x, y + 1, 5),
                               foretold(eye, x + 1, y + 1, 5)});
              EXPECT_GE(there, nearest - 0.001) << x << ' ' << y << " with opacity " << opacity;
              EXPECT_LE(there, farthest + 0.001) << x << ' ' << y << " with opacity " << opacity;
              ++met;
            }
          }
      EXPECT_GT(met, 20);
      EXPECT_GT(missed, 20);
    }
}

TEST_F(HandedOver, OfAHiddenStructureTheOneBehindCounts) {
  open();
  balls.scene.look_of("dentine")->visible = false;
  balls.scene.look_of("pulp")->opacity = 1;
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
  draw(painter);
  const glm::dvec3 centre =
      glm::conjugate(eyes_[0].pose.turn) * (to_room(visit.stage, {1, 2, 30}) - eyes_[0].pose.position);
  const auto pixel = [&](double along, double low, double high) {
    return static_cast<int>(side * (along / -centre.z - std::tan(low)) / (std::tan(high) - std::tan(low)));
  };
  const int x = pixel(centre.x, eyes_[0].field.left, eyes_[0].field.right),
            y = pixel(centre.y, eyes_[0].field.down, eyes_[0].field.up);
  EXPECT_NEAR(metres_ahead(0, x, y), foretold(0, x + 0.5, y + 0.5, 2), 0.002);
}

TEST_F(HandedOver, InTheDarkNoDepthIsToldOf) {
  open();
  EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
  draw(painter);
  EXPECT_EQ(runtime.ended.back().depths.size(), 2u);
  visit.seen.dark = 1;
  draw(painter);
  EXPECT_EQ(runtime.ended.back().views, 2);
  EXPECT_TRUE(runtime.ended.back().depths.empty());
}

TEST_F(HandedOver, ARuntimeThatWantsNoDepthGetsNone) {
  for (const bool with_format : {true, false}) {
    runtime.extensions = {"XR_KHR_opengl_enable", "XR_MNDX_egl_enable"};
    if (!with_format) {
      runtime.extensions.emplace_back(depth_extension);
      std::erase(runtime.formats, GL_DEPTH_COMPONENT32F);
    }
    runtime.swapchains.clear();
    open();
    EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
    EXPECT_TRUE(content_of(draw(painter)).shows_something());
    EXPECT_EQ(runtime.ended.back().views, 2);
    EXPECT_TRUE(runtime.ended.back().depths.empty());
    EXPECT_EQ(runtime.swapchains.size(), 2u);
    headset.reset();
    runtime.events.clear();
  }
}

TEST_F(HandedOver, WhatLensesHideIsNotDrawnAndTheRestIsAsItWas) {
  for (const float opacity : {1.0f, 0.3f}) {
    for (Look& look : balls.scene.looks) look.opacity = opacity;
    runtime.hidden_corners.clear();
    open();
    EyePainter painter(context->gl(), ShaderLibrary{}, balls.model);
    const Image whole = draw(painter);
    const auto background = whole.pixel(0, 0);
    // All that lies left of the line of sight, and more of it than the picture shows.
    const float edge = 0.001f;
    runtime.hidden_corners = {{-9, -9}, {edge, -9}, {edge, 9}, {-9, -9}, {edge, 9}, {-9, 9}};
    XrEventDataBuffer changed{XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR};
    runtime.events.push_back(changed);
    headset->poll();
    const Image masked = draw(painter);
    int hidden = 0, shown = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const double tangent = std::tan(-0.8) + 2 * std::tan(0.8) * (x + 0.5) / side;
        if (tangent < edge) {
          EXPECT_EQ(masked.pixel(x, y), background) << x << ' ' << y;
          if (x % 16 == 0 && y % 16 == 0) {
            EXPECT_TRUE(std::isinf(metres_ahead(0, x, side - 1 - y)));
          }
          if (whole.pixel(x, y) != background) ++hidden;
        } else {
          EXPECT_EQ(masked.pixel(x, y), whole.pixel(x, y)) << x << ' ' << y;
          if (whole.pixel(x, y) != background) ++shown;
        }
      }
    EXPECT_GT(hidden, 100);
    EXPECT_GT(shown, 100);
    headset.reset();
    runtime.events.clear();
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
