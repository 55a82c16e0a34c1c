// The session with a real runtime: states, frames, what both eyes see, the hands, and the end of it.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "engine/gpu/window_context.h"
#include "engine/headset/headset.h"
#include "tests/xr/monado.h"
#include "tests/xr/validation.h"

namespace odontoscope::testing_support {
namespace {

enum class Through { xlib, egl };

std::unique_ptr<GlContext> context_for(Through binding) {
  if (binding == Through::egl) return make_egl_context({.debug = true});
  return open_window({.size = {640, 480}, .visible = false, .debug = true});
}

/// Frames until the session has the focus; false if that does not come.
bool reach_focus(Headset& headset) {
  for (int i = 0; i < 600; ++i) {
    switch (headset.poll()) {
      case HeadsetState::focused: return true;
      case HeadsetState::over: return false;
      case HeadsetState::waiting: std::this_thread::sleep_for(std::chrono::milliseconds(5)); break;
      default: headset.frame([](const HeadsetFrame&) {});
    }
  }
  return false;
}

/// true: it ended as it should.
bool leave(Headset& headset) {
  headset.leave();
  for (int i = 0; i < 600; ++i) {
    const HeadsetState state = headset.poll();
    if (state == HeadsetState::over) return true;
    if (state == HeadsetState::waiting) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    else headset.frame([](const HeadsetFrame&) {});
  }
  return false;
}

/// Opens a headset that must not open.
std::string cause_of_failure(Through binding = Through::egl) {
  const auto context = context_for(binding);
  try {
    open_headset(context->gl(), {});
  } catch (const HeadsetError& error) {
    std::printf("measured: \"%s\"\n", error.what());
    EXPECT_EQ(error.exit_code(), ExitCode::graphics);
    EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return error.cause();
  }
  return "it opened";
}

class Session : public ::testing::TestWithParam<Through> {};

TEST_P(Session, ReachesFocusRunsAHundredFramesAndEnds) {
  Monado monado;
  const auto context = context_for(GetParam());
  const auto headset = open_headset(context->gl(), {});
  std::printf("measured: %s\n", headset->in_words().c_str());
  ASSERT_TRUE(reach_focus(*headset)) << Monado::log();
  int drawn = 0;
  double seconds = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(headset->poll(), HeadsetState::focused);
    headset->frame([&](const HeadsetFrame& frame) {
      seconds += frame.seconds;
      if (!frame.draw) return;
      ++drawn;
      ASSERT_EQ(frame.eyes.size(), 2u);
      ASSERT_EQ(frame.targets.size(), 2u);
      for (const Target& target : frame.targets) {
        context->gl().BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        constexpr GLfloat grey[4] = {0.5f, 0.5f, 0.5f, 1};
        context->gl().ClearBufferfv(GL_COLOR, 0, grey);
      }
    });
  }
  EXPECT_GE(drawn, 90);
  EXPECT_GT(seconds, 0.5);
  EXPECT_TRUE(leave(*headset));
  EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

INSTANTIATE_TEST_SUITE_P(Bindings, Session, ::testing::Values(Through::xlib, Through::egl), [](const auto& param) { return param.param == Through::xlib ? "Xlib" : "Egl"; });

// The layer checks every call against the specification; it refuses the binding through EGL, which is Monado's own.
TEST(Validation, IsSilent) {
  report_validation_to("/tmp/validation.txt");
  Monado monado;
  const auto context = context_for(Through::xlib);
  {
    const auto headset = open_headset(context->gl(), {.layers = {validation_layer}});
    ASSERT_TRUE(reach_focus(*headset));
    for (int i = 0; i < 20; ++i) {
      headset->poll();
      headset->frame([](const HeadsetFrame&) {});
    }
    EXPECT_TRUE(leave(*headset));
  }
  expect_silent_validation("/tmp/validation.txt");
}

TEST(Failure, AFrameThatThrowsIsEndedAllTheSame) {
  Monado monado;
  const auto context = context_for(Through::egl);
  const auto headset = open_headset(context->gl(), {});
  ASSERT_TRUE(reach_focus(*headset));
  for (int i = 0; i < 3; ++i) {
    EXPECT_THROW(headset->frame([](const HeadsetFrame&) { throw std::runtime_error("a bug"); }), std::runtime_error);
    headset->poll();
  }
  bool drawn = false;
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(headset->poll(), HeadsetState::focused);
    headset->frame([&](const HeadsetFrame& frame) { drawn = drawn || frame.draw; });
  }
  EXPECT_TRUE(drawn);
  EXPECT_TRUE(leave(*headset));
}

TEST(Failure, NoRuntime) {
  setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
  EXPECT_EQ(cause_of_failure(), "no-openxr-runtime");
}

TEST(Failure, NoService) { EXPECT_EQ(cause_of_failure(), "openxr-service-absent"); }

TEST(Failure, ServiceKilledWhileRunning) {
  for (const Through binding : {Through::xlib, Through::egl}) {
    Monado monado;
    const auto context = context_for(binding);
    std::string cause;
    {
      const auto headset = open_headset(context->gl(), {});
      ASSERT_TRUE(reach_focus(*headset));
      monado.kill();
      try {
        for (int i = 0; i < 300; ++i) {
          headset->poll();
          headset->frame([](const HeadsetFrame&) {});
        }
      } catch (const HeadsetError& error) {
        std::printf("measured: \"%s\"\n", error.what());
        cause = error.cause();
      }
    }
    EXPECT_EQ(cause, "headset-lost");
    // OpenGL still works, so the desktop goes on.
    const Framebuffer pixels(context->gl(), {{8, 8}, {GL_RGBA8}});
    pixels.bind();
    EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

TEST(Failure, AfterARestartItOpensAgain) {
  const auto context = context_for(Through::egl);
  EXPECT_EQ(cause_of_failure(), "openxr-service-absent");
  context->make_current();
  for (int i = 0; i < 2; ++i) {
    Monado monado;
    const auto headset = open_headset(context->gl(), {});
    EXPECT_TRUE(reach_focus(*headset));
    EXPECT_TRUE(leave(*headset));
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
