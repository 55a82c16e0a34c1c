#pragma once
// Tests that draw what the headset shows: they skip themselves, saying why, where nothing can be drawn, and fail if
// OpenGL complains.

#include <gtest/gtest.h>

#include <memory>

#include "engine/gpu/context.h"

namespace odontoscope::testing_support {

class Drawing : public ::testing::Test {
 protected:
  std::unique_ptr<GlContext> context;

  void SetUp() final {
    try {
      context = make_context({.debug = true});
    } catch (const GraphicsError& error) {
      GTEST_SKIP() << "nothing can be drawn here: " << error.what();
    }
    begin();
  }
  void TearDown() final {
    if (!context) return;
    for (const std::string& message : context->debug_messages()) ADD_FAILURE() << "OpenGL says: " << message;
    EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    finish();
  }

  /// What a test begins with, and gives back while the context is there.
  virtual void begin() {}
  virtual void finish() {}
};

}  // namespace odontoscope::testing_support
