// The table of bindings, and what can be said of a headset where there is none.
#include "engine/headset/bindings.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "engine/gpu/context.h"
#include "engine/headset/headset.h"

namespace odontoscope {
namespace {

TEST(Bindings, EveryControllerHasWhatIsNeeded) {
  std::set<std::string> profiles;
  for (const Bindings& bindings : all_bindings()) {
    EXPECT_TRUE(profiles.insert(bindings.profile).second) << bindings.profile;
    std::set<std::string> paths;
    std::set<HandAction> left, right;
    for (const Binding& binding : bindings.bindings) {
      for (const auto& [path, actions, hand] :
           {std::tuple{binding.left, &left, "left "}, std::tuple{binding.right, &right, "right "}}) {
        if (!path) continue;
        EXPECT_TRUE(actions->insert(binding.action).second) << bindings.profile << ": two for one action";
        EXPECT_TRUE(paths.insert(hand + std::string(path)).second)
            << bindings.profile << ": " << path << " does two things";
        EXPECT_EQ(std::string(path).rfind(binding.action == HandAction::haptic ? "output/" : "input/", 0), 0u) << path;
      }
    }
    EXPECT_EQ(left, right) << bindings.profile;
    for (const HandAction needed :
         {HandAction::grip, HandAction::aim, HandAction::trigger, HandAction::menu, HandAction::haptic})
      EXPECT_TRUE(left.contains(needed)) << bindings.profile;
    // Without a button to grab with, the trigger does it.
    const bool one_button = std::string(bindings.profile) == "khr/simple_controller";
    EXPECT_EQ(left.contains(HandAction::grab), !one_button) << bindings.profile;
  }
  EXPECT_EQ(profiles,
            (std::set<std::string>{"khr/simple_controller", "oculus/touch_controller", "valve/index_controller",
                                   "htc/vive_controller", "microsoft/motion_controller"}));
}

TEST(NoHeadset, IsSaidAndOpenGlGoesOn) {
  std::unique_ptr<GlContext> context;
  try {
    context = make_osmesa_context({});
  } catch (const GraphicsError& error) {
    GTEST_SKIP() << error.what();
  }
  // OSMesa's contexts cannot be shared with a runtime, whether there is one or not.
  try {
    open_headset(context->gl());
    FAIL() << "it opened";
  } catch (const HeadsetError& error) {
    EXPECT_EQ(error.cause(), headsets_built_in() ? "headset-graphics" : "headset-not-built");
    EXPECT_EQ(error.exit_code(), ExitCode::graphics);
  }
  EXPECT_EQ(context->gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(NoHeadset, NoRuntimeIsSaid) {
  if (!headsets_built_in()) GTEST_SKIP() << "built without OpenXR";
  setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
  setenv("XR_LOADER_DEBUG", "none", 1);
  std::unique_ptr<GlContext> context;
  try {
    context = make_egl_context({});
  } catch (const GraphicsError& error) {
    GTEST_SKIP() << error.what();
  }
  try {
    open_headset(context->gl());
    FAIL() << "it opened";
  } catch (const HeadsetError& error) {
    EXPECT_EQ(error.cause(), "no-openxr-runtime");
  }
}

}  // namespace
}  // namespace odontoscope
