#pragma once
// What tests led by the fake runtime begin and end with: a context without a display, and nobody complained.

#include <gtest/gtest.h>

#include <memory>

#include "engine/gpu/context.h"
#include "engine/headset/headset.h"
#include "engine/view/offscreen.h"
#include "tests/openxr/fake_runtime.h"

namespace odontoscope::testing_support {

class WithFakeRuntime : public ::testing::Test {
 protected:
  FakeRuntime& runtime = use_fake_runtime();
  std::unique_ptr<GlContext> context;  // null: there is no OpenGL, and the test is skipped
  std::unique_ptr<Headset> headset;

  void SetUp() override {
    try {
      context = make_egl_context({.debug = true});
    } catch (const GraphicsError& error) {
      GTEST_SKIP() << error.what();
    }
    runtime.gl = &context->gl();
  }
  void TearDown() override {
    if (!context) return;
    headset.reset();
    for (const std::string& misuse : runtime.misuse) ADD_FAILURE() << misuse;
    for (const std::string& message : context->debug_messages()) ADD_FAILURE() << "OpenGL says: " << message;
    EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
};

}  // namespace odontoscope::testing_support
