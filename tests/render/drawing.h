#pragma once
// A test that draws: it has a context with the driver's checks on, or skips itself and says why.

#include <gtest/gtest.h>

#include <memory>

#include "engine/view/offscreen.h"

namespace odontoscope::testing_support {

/// The context, or null and the reason.
struct PerhapsContext {
  std::unique_ptr<GlContext> context;
  std::string reason;
};
PerhapsContext try_context(Backend backend);

class DrawingTest : public ::testing::Test {
 protected:
  void SetUp() override;
  /// No test may leave a complaint of the driver behind.
  void TearDown() override;

  Image draw(const Model& model, const Scene& scene, PixelSize size = {160, 120}, int side = 1);
  const Gl& gl() const { return context_->gl(); }
  GlContext& context() { return *context_; }

 private:
  std::unique_ptr<GlContext> context_;
};

/// No occlusion, nothing behind, parallel from the buccal side: `height_mm` from top to bottom around the origin.
Scene plain_scene(const Model& model, double height_mm);

}  // namespace odontoscope::testing_support
