// The session with a real runtime: states, frames, what both eyes see, the hands, and the end of it.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
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

Depths look_only(const HeadsetFrame&) { return {}; }

/// Frames until the session has the focus; false if that does not come.
bool reach_focus(Headset& headset) {
  for (int i = 0; i < 600; ++i) {
    switch (headset.poll()) {
      case HeadsetState::focused:
        return true;
      case HeadsetState::over:
        return false;
      case HeadsetState::waiting:
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        break;
      default:
        headset.frame(look_only);
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
    if (state == HeadsetState::waiting)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    else
      headset.frame(look_only);
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
      if (!frame.draw) return Depths{};
      ++drawn;
      EXPECT_EQ(frame.eyes.size(), 2u);
      EXPECT_EQ(frame.targets.size(), 2u);
      for (const Target& target : frame.targets) {
        context->gl().BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        constexpr GLfloat grey[4] = {0.5f, 0.5f, 0.5f, 1};
        context->gl().ClearBufferfv(GL_COLOR, 0, grey);
      }
      return Depths{};
    });
  }
  EXPECT_GE(drawn, 90);
  EXPECT_GT(seconds, 0.5);
  EXPECT_TRUE(leave(*headset));
  EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

INSTANTIATE_TEST_SUITE_P(Bindings, Session, ::testing::Values(Through::xlib, Through::egl),
                         [](const auto& param) { return param.param == Through::xlib ? "Xlib" : "Egl"; });

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
      headset->frame(look_only);
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
    EXPECT_THROW(headset->frame([](const HeadsetFrame&) -> Depths { throw std::runtime_error("a bug"); }),
                 std::runtime_error);
    headset->poll();
  }
  bool drawn = false;
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(headset->poll(), HeadsetState::focused);
    headset->frame([&](const HeadsetFrame& frame) {
      drawn = drawn || frame.draw;
      return Depths{};
    });
  }
  EXPECT_TRUE(drawn);
  EXPECT_TRUE(leave(*headset));
}

/// Frames until `wanted` says enough; false if that does not come within half a minute.
bool frames_until(Headset& headset, const std::function<bool(HeadsetState, const HeadsetFrame&)>& wanted) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  bool there = false;
  while (!there && std::chrono::steady_clock::now() < end) {
    const HeadsetState state = headset.poll();
    if (state == HeadsetState::over) return false;
    if (state == HeadsetState::waiting) {
      there = wanted(state, {});
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      continue;
    }
    headset.frame([&](const HeadsetFrame& frame) {
      there = wanted(state, frame);
      return Depths{};
    });
  }
  return there;
}

constexpr const char* enough = "/tmp/enough";  // the other program ends when there is such a file

/// Not a test: another program that wants the headset, in a process of its own.
TEST(OtherProgram, DISABLED_WantsTheHeadset) {
  const auto context = context_for(Through::egl);
  const auto headset = open_headset(context->gl(), {});
  frames_until(*headset, [](HeadsetState, const HeadsetFrame&) { return std::filesystem::exists(enough); });
  leave(*headset);
}

TEST(States, AnotherProgramTakesTheFocusAndGivesItBack) {
  std::filesystem::remove(enough);
  Monado monado;
  const auto context = context_for(Through::egl);
  const auto headset = open_headset(context->gl(), {});
  ASSERT_TRUE(reach_focus(*headset));
  const auto in_hand = [](const HeadsetFrame& frame) {
    return frame.input.hands[0].tracked && frame.input.hands[1].tracked;
  };
  EXPECT_TRUE(frames_until(*headset, [&](HeadsetState state, const HeadsetFrame& frame) {
    return state == HeadsetState::focused && frame.draw && in_hand(frame);
  }));
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  std::thread other([program] {
    EXPECT_EQ(std::system(("'" + program +
                           "' --gtest_also_run_disabled_tests --gtest_filter=OtherProgram.DISABLED_WantsTheHeadset "
                           ">/tmp/other.log 2>&1")
                              .c_str()),
              0);
  });
  int unseen = 0;
  EXPECT_TRUE(frames_until(*headset, [&](HeadsetState state, const HeadsetFrame& frame) {
    if (state == HeadsetState::focused) return false;
    EXPECT_FALSE(frame.input.focused);
    EXPECT_FALSE(frame.input.hands[0].tracked || frame.input.hands[1].tracked) << "the other program's hands";
    return ++unseen == 20;
  })) << Monado::log();
  std::ofstream(enough) << '\n';
  EXPECT_TRUE(frames_until(*headset, [&](HeadsetState state, const HeadsetFrame& frame) {
    return state == HeadsetState::focused && frame.draw && in_hand(frame);
  })) << Monado::log();
  other.join();
  EXPECT_TRUE(leave(*headset));
}

TEST(States, RecentringIsTold) {
  Monado monado;
  RemoteBody body;
  body.head.position = {0.4, 1.2, -0.3};
  monado.say(body);
  const auto context = context_for(Through::egl);
  const auto headset = open_headset(context->gl(), {});
  ASSERT_TRUE(reach_focus(*headset));
  glm::dvec3 before(0);
  EXPECT_TRUE(frames_until(*headset, [&](HeadsetState, const HeadsetFrame& frame) {
    before = frame.input.head.position;
    EXPECT_FALSE(frame.input.recentred);
    return frame.input.head_tracked && frame.draw;
  }));
  ASSERT_EQ(std::system("env -u LD_LIBRARY_PATH monado-ctl -c >/tmp/ctl.log 2>&1"), 0);
  glm::dvec3 after(0);
  EXPECT_TRUE(frames_until(*headset, [&](HeadsetState, const HeadsetFrame& frame) {
    after = frame.input.head.position;
    return frame.input.recentred;
  })) << Monado::log();
  std::printf("measured: the head was %.2f %.2f %.2f from the middle and is %.2f %.2f %.2f\n", before.x, before.y,
              before.z, after.x, after.y, after.z);
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
          headset->frame(look_only);
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
