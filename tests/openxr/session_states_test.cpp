// The session through every state, loss and failure that OpenXR knows, with a runtime that brings them about.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "engine/gpu/context.h"
#include "engine/headset/headset.h"
#include "tests/openxr/with_fake_runtime.h"

namespace odontoscope::testing_support {
namespace {

constexpr XrSessionState idle = XR_SESSION_STATE_IDLE, ready = XR_SESSION_STATE_READY,
                         synchronized = XR_SESSION_STATE_SYNCHRONIZED, visible = XR_SESSION_STATE_VISIBLE,
                         focused = XR_SESSION_STATE_FOCUSED, stopping = XR_SESSION_STATE_STOPPING,
                         exiting = XR_SESSION_STATE_EXITING, loss_pending = XR_SESSION_STATE_LOSS_PENDING;

class OpenXr : public WithFakeRuntime {
 protected:
  void TearDown() override {
    if (!context) return;
    headset.reset();
    EXPECT_EQ(runtime.sessions, 0);
    EXPECT_EQ(runtime.instances, 0);
    for (const FakeSwapchain& swapchain : runtime.swapchains) EXPECT_TRUE(swapchain.destroyed);
    EXPECT_EQ(runtime.begun, static_cast<int>(runtime.ended.size())) << "a frame was begun and not ended";
    WithFakeRuntime::TearDown();
  }

  void open() { headset = open_headset(context->gl(), {}); }
  HeadsetState told(XrSessionState state) {
    runtime.tell(state);
    return headset->poll();
  }
  void open_with_focus() {
    open();
    for (const XrSessionState state : {ready, synchronized, visible, focused}) told(state);
  }
  HeadsetFrame frame(const Headset::Draw& draw = {}) {
    HeadsetFrame seen;
    headset->frame([&](const HeadsetFrame& one) {
      seen = one;
      return draw ? draw(one) : Depths{};
    });
    return seen;
  }
  /// Of the HeadsetError that `act` throws; empty: none.
  static std::string cause_of(const std::function<void()>& act) {
    try {
      act();
    } catch (const HeadsetError& error) {
      return error.cause();
    }
    return {};
  }
};

TEST_F(OpenXr, EveryChangeOfStateIsFollowed) {
  struct Step {
    XrSessionState told;
    HeadsetState state;
    bool running;
  };
  // From taking the headset on to putting it away, the system's menu in between, and once more; then the end.
  const Step steps[] = {{idle, HeadsetState::waiting, false},        {ready, HeadsetState::running, true},
                        {synchronized, HeadsetState::running, true}, {visible, HeadsetState::visible, true},
                        {focused, HeadsetState::focused, true},      {visible, HeadsetState::visible, true},
                        {focused, HeadsetState::focused, true},      {visible, HeadsetState::visible, true},
                        {synchronized, HeadsetState::running, true}, {visible, HeadsetState::visible, true},
                        {synchronized, HeadsetState::running, true}, {stopping, HeadsetState::waiting, false},
                        {idle, HeadsetState::waiting, false},        {ready, HeadsetState::running, true},
                        {synchronized, HeadsetState::running, true}, {visible, HeadsetState::visible, true},
                        {focused, HeadsetState::focused, true},      {visible, HeadsetState::visible, true},
                        {synchronized, HeadsetState::running, true}, {stopping, HeadsetState::waiting, false},
                        {idle, HeadsetState::waiting, false},        {exiting, HeadsetState::over, false}};
  open();
  for (const Step& step : steps) {
    EXPECT_EQ(told(step.told), step.state) << "told " << step.told;
    EXPECT_EQ(runtime.running, step.running) << "told " << step.told;
    if (!step.running) continue;
    const HeadsetFrame seen = frame();
    EXPECT_EQ(seen.input.focused, step.told == focused);
    EXPECT_EQ(seen.input.hands[0].tracked, step.told == focused);
  }
  EXPECT_EQ(headset->poll(), HeadsetState::over);
}

TEST_F(OpenXr, SeveralChangesAtOnceAreTakenInOrder) {
  open();
  for (const XrSessionState state :
       {idle, ready, synchronized, visible, focused, visible, synchronized, stopping, idle, ready})
    runtime.tell(state);
  EXPECT_EQ(headset->poll(), HeadsetState::running);
  frame();
  for (const XrSessionState state : {synchronized, stopping, idle, exiting}) runtime.tell(state);
  EXPECT_EQ(headset->poll(), HeadsetState::over);
}

TEST_F(OpenXr, ASystemThatNeverStartsUsCanEndUs) {
  open();
  EXPECT_EQ(told(idle), HeadsetState::waiting);
  EXPECT_EQ(told(exiting), HeadsetState::over);
}

TEST_F(OpenXr, ALossIsSaidInEveryState) {
  const std::vector<XrSessionState> way = {idle,    ready,        synchronized, visible, focused,
                                           visible, synchronized, stopping,     idle};
  for (std::size_t length = 0; length <= way.size(); ++length)
    for (const bool whole_instance : {false, true}) {
      open();
      for (std::size_t i = 0; i < length; ++i) told(way[i]);
      if (whole_instance)
        runtime.tell_lost_instance();
      else
        runtime.tell(loss_pending);
      EXPECT_EQ(cause_of([&] { headset->poll(); }), "headset-lost") << length;
      headset.reset();
      runtime.events.clear();
    }
}

TEST_F(OpenXr, WhateverCallSaysThatAllIsLostTheFrameIsEndedAndItIsSaid) {
  for (const char* call :
       {"xrPollEvent", "xrWaitFrame", "xrBeginFrame", "xrLocateViews", "xrLocateSpace", "xrSyncActions",
        "xrGetActionStatePose", "xrGetActionStateFloat", "xrGetActionStateVector2f", "xrGetActionStateBoolean",
        "xrAcquireSwapchainImage", "xrWaitSwapchainImage", "xrReleaseSwapchainImage", "xrEndFrame"})
    for (const XrResult answer : {XR_ERROR_SESSION_LOST, XR_ERROR_INSTANCE_LOST, XR_ERROR_RUNTIME_FAILURE}) {
      open_with_focus();
      frame();
      runtime.answers[call] = answer;
      const std::string cause = cause_of([&] {
        headset->poll();
        frame();
      });
      EXPECT_EQ(cause, answer == XR_ERROR_RUNTIME_FAILURE ? "openxr-failed" : "headset-lost") << call;
      // A frame whose end itself failed cannot be ended better.
      EXPECT_EQ(runtime.begun - static_cast<int>(runtime.ended.size()), std::string(call) == "xrEndFrame" ? 1 : 0)
          << call;
      if (std::string(call) == "xrEndFrame") runtime.ended.emplace_back();
      headset.reset();
      runtime.answers.clear();
      runtime.events.clear();
    }
}

TEST_F(OpenXr, WhatFailsWhileOpeningIsSaidAndNothingStaysBehind) {
  const std::pair<const char*, const char*> failures[] = {{"xrCreateInstance", "openxr-service-absent"},
                                                          {"xrGetSystem", "openxr-failed"},
                                                          {"xrGetOpenGLGraphicsRequirementsKHR", "openxr-failed"},
                                                          {"xrEnumerateEnvironmentBlendModes", "openxr-failed"},
                                                          {"xrCreateSession", "openxr-failed"},
                                                          {"xrCreateReferenceSpace", "openxr-failed"},
                                                          {"xrCreateActionSet", "openxr-failed"},
                                                          {"xrCreateAction", "openxr-failed"},
                                                          {"xrStringToPath", "openxr-failed"},
                                                          {"xrSuggestInteractionProfileBindings", "openxr-failed"},
                                                          {"xrAttachSessionActionSets", "openxr-failed"},
                                                          {"xrCreateActionSpace", "openxr-failed"},
                                                          {"xrEnumerateViewConfigurationViews", "openxr-failed"},
                                                          {"xrEnumerateSwapchainFormats", "openxr-failed"},
                                                          {"xrCreateSwapchain", "openxr-failed"},
                                                          {"xrEnumerateSwapchainImages", "openxr-failed"},
                                                          {"xrGetInstanceProperties", "openxr-failed"},
                                                          {"xrGetSystemProperties", "openxr-failed"}};
  for (const auto& [call, cause] : failures) {
    runtime.answers = {{call, XR_ERROR_RUNTIME_FAILURE}};
    EXPECT_EQ(cause_of([&] { open(); }), cause) << call;
    EXPECT_EQ(runtime.sessions, 0) << call;
    EXPECT_EQ(runtime.instances, 0) << call;
    runtime.events.clear();
  }
  runtime.answers = {{"xrGetSystem", XR_ERROR_FORM_FACTOR_UNAVAILABLE}};
  EXPECT_EQ(cause_of([&] { open(); }), "no-headset");
  runtime.answers.clear();
  runtime.formats = {GL_RGBA16F};
  EXPECT_EQ(cause_of([&] { open(); }), "headset-graphics");
}

// In a process of its own: the loader remembers what the runtime could do when it was first asked.
TEST_F(OpenXr, ARuntimeThatTakesNoOpenGlIsSaid) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  runtime.extensions.clear();
  EXPECT_EXIT(std::exit(cause_of([&] { open(); }) == "headset-graphics" ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

TEST_F(OpenXr, WhatNobodyWouldSeeIsNotDrawnYetItsFrameIsEnded) {
  open_with_focus();
  EXPECT_TRUE(frame().draw);
  for (const bool asked_for : {false, true}) {
    runtime.should_render = asked_for;
    runtime.eyes_known = !asked_for;
    const HeadsetFrame seen = frame();
    EXPECT_FALSE(seen.draw);
    EXPECT_TRUE(seen.targets.empty());
    EXPECT_EQ(runtime.ended.back().views, 0);
    EXPECT_EQ(seen.input.head_tracked, runtime.eyes_known);
  }
  runtime.should_render = runtime.eyes_known = true;
  const std::vector<int> before = runtime.ended.front().images;
  EXPECT_TRUE(frame().draw);
  EXPECT_EQ(runtime.ended.back().views, 2);
  EXPECT_EQ(runtime.ended.back().images[0], before[0] + 1) << "a picture was taken for a frame that nobody saw";
  EXPECT_EQ(runtime.ended.size(), 4u);
}

TEST_F(OpenXr, ADrawingThatThrowsEndsItsFrameAndTheNextOneIsWhole) {
  open_with_focus();
  for (int i = 0; i < 4; ++i) {
    EXPECT_THROW(frame([](const HeadsetFrame&) -> Depths { throw std::runtime_error("a bug"); }), std::runtime_error);
    EXPECT_EQ(runtime.ended.back().views, 0) << "half a picture was shown";
    EXPECT_EQ(runtime.begun, static_cast<int>(runtime.ended.size()));
    for (const FakeSwapchain& swapchain : runtime.swapchains) EXPECT_FALSE(swapchain.acquired);
    EXPECT_TRUE(frame().draw);
    EXPECT_EQ(runtime.ended.back().views, 2);
  }
}

TEST_F(OpenXr, LeavingAsksTheRuntimeAndFollowsIt) {
  open_with_focus();
  headset->leave();
  EXPECT_TRUE(runtime.exit_requested);
  EXPECT_EQ(headset->poll(), HeadsetState::focused);  // until it has decided
  frame();
  for (const XrSessionState state : {visible, synchronized}) {
    EXPECT_NE(told(state), HeadsetState::over);
    frame();
  }
  EXPECT_EQ(told(stopping), HeadsetState::waiting);
  EXPECT_EQ(told(idle), HeadsetState::waiting);
  EXPECT_EQ(told(exiting), HeadsetState::over);
}

TEST_F(OpenXr, LeavingWhatDoesNotRunIsOverAtOnce) {
  open();
  EXPECT_EQ(told(idle), HeadsetState::waiting);
  headset->leave();
  EXPECT_EQ(headset->poll(), HeadsetState::over);
}

TEST_F(OpenXr, LeavingJustAsTheRuntimeStopsIsOverToo) {
  open_with_focus();
  runtime.tell(stopping);
  headset->leave();  // nobody has looked at the event yet
  EXPECT_EQ(headset->poll(), HeadsetState::waiting);
  headset->leave();
  EXPECT_EQ(headset->poll(), HeadsetState::over);
}

TEST_F(OpenXr, ClosingInTheMiddleIsClean) {
  for (const XrSessionState last : {idle, ready, synchronized, visible, focused, stopping}) {
    open();
    for (const XrSessionState state : {idle, ready, synchronized, visible, focused, stopping}) {
      if (told(state); runtime.running) frame();
      if (state == last) break;
    }
    headset.reset();
    EXPECT_EQ(runtime.sessions, 0);
    runtime.events.clear();
  }
}

TEST_F(OpenXr, RecentringIsToldOnceWhenItsTimeHasCome) {
  open_with_focus();
  EXPECT_FALSE(frame().input.recentred);
  runtime.tell_recentred(XR_REFERENCE_SPACE_TYPE_STAGE);  // not the one that we stand in
  headset->poll();
  EXPECT_FALSE(frame().input.recentred);
  runtime.tell_recentred();
  headset->poll();
  EXPECT_TRUE(frame().input.recentred);
  EXPECT_FALSE(frame().input.recentred);
  runtime.time += 1'000'000'000;
  runtime.tell_recentred();  // in a second
  runtime.time -= 1'000'000'000;
  headset->poll();
  EXPECT_FALSE(frame().input.recentred);
  runtime.time += 1'000'000'000;
  EXPECT_TRUE(frame().input.recentred);
}

TEST_F(OpenXr, ControllersThatWereHiddenComeBack) {
  runtime.trigger = 0.75f;
  open_with_focus();
  EXPECT_DOUBLE_EQ(frame().input.hands[1].trigger, 0.75);
  runtime.hands_held = false;
  HandInput hand = frame().input.hands[1];
  EXPECT_FALSE(hand.tracked);
  EXPECT_EQ(hand.trigger, 0);
  runtime.hands_held = true;
  EXPECT_TRUE(frame().input.hands[1].tracked);
  told(visible);  // the system's menu has them
  hand = frame().input.hands[1];
  EXPECT_FALSE(hand.tracked);
  EXPECT_EQ(hand.trigger, 0);
  told(focused);
  hand = frame().input.hands[1];
  EXPECT_TRUE(hand.tracked);
  EXPECT_DOUBLE_EQ(hand.trigger, 0.75);
}

TEST_F(OpenXr, TimeNeverJumps) {
  open_with_focus();
  EXPECT_EQ(frame().seconds, 0);
  EXPECT_NEAR(frame().seconds, 1 / 90.0, 1e-6);
  runtime.time += 60'000'000'000;  // a minute in the system's menu
  EXPECT_LE(frame().seconds, 0.1);
  runtime.time -= 5'000'000'000;
  EXPECT_EQ(frame().seconds, 0);
}

}  // namespace
}  // namespace odontoscope::testing_support
