// The viewer's window while its model is in the headset: what a person does at the desk meanwhile, and a runtime that
// misbehaves. Each case runs in a process of its own on a display in memory.
#include "engine/headset_viewer/headset_loop.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "engine/view/offscreen.h"
#include "engine/viewer/window_loop.h"
#include "tests/openxr/fake_runtime.h"
#include "tests/render/shapes.h"
// Last: it would bring another OpenGL along.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace odontoscope::testing_support {
namespace {

void run_on_display(const std::string& name) {
  const std::string xvfb = ODONTOSCOPE_XVFB_RUN;
  if (xvfb.empty()) GTEST_SKIP() << "xvfb-run is missing: no display to open a window on";
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const int status =
      std::system((xvfb + " -a -s '-screen 0 1400x1000x24' '" + program +
                   "' --gtest_also_run_disabled_tests --gtest_filter='OnADisplay.DISABLED_" + name + "' >&2")
                      .c_str());
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0);
}

TEST(HeadsetLoop, AFileDroppedOnTheWindowTakesTheModelsPlace) { run_on_display("Dropped"); }
TEST(HeadsetLoop, AFileThatCannotBeReadIsSaidAndTheModelStays) { run_on_display("Unreadable"); }
TEST(HeadsetLoop, ClosingTheWindowEndsTheSession) { run_on_display("Closed"); }
TEST(HeadsetLoop, AWindowThatNobodySeesDoesNotHoldTheHeadsetUp) { run_on_display("Hidden"); }
TEST(HeadsetLoop, ARuntimeThatDoesNotLetGoIsLeft) { run_on_display("Clinging"); }
TEST(HeadsetLoop, ALossIsSaidAndTheDesktopGoesOn) { run_on_display("Lost"); }
TEST(HeadsetLoop, TheHeadsetsOwnMenuCanEndIt) { run_on_display("Menu"); }
TEST(HeadsetLoop, BothEyesSeeTheVolumeThatTheWindowShows) { run_on_display("Volume"); }

class OnADisplay : public ::testing::Test {
 protected:
  using Watch = std::function<void(const HeadsetFrame&, const Visit&)>;
  FakeRuntime& runtime = use_fake_runtime();
  std::unique_ptr<Window> window = std::make_unique<Window>(WindowOptions{.size = {500, 400}, .debug = true});
  std::unique_ptr<Viewer> viewer;
  std::stop_source stop;
  std::string said;
  int frames = 0;

  void SetUp() override {
    runtime.gl = &window->context().gl();
    runtime.obliging = true;
  }
  void TearDown() override {
    EXPECT_EQ(runtime.sessions, 0);
    EXPECT_EQ(runtime.instances, 0);
    EXPECT_EQ(runtime.begun, static_cast<int>(runtime.ended.size()));
    for (const std::string& misuse : runtime.misuse) ADD_FAILURE() << misuse;
    for (const std::string& message : window->context().debug_messages()) ADD_FAILURE() << "OpenGL says: " << message;
    viewer.reset();
  }
  static inline bool with_volume = false;
  /// Dense stuff in half of a box around the ball, shown alone.
  static void give_volume(LoadedModel& loaded) {
    ValueGrid grid;
    grid.size = {20, 20, 20};
    grid.first_mm = glm::dvec3(-5.7);
    grid.step_mm = glm::dvec3(0.6);
    for (std::size_t i = 0; i < 8000; ++i) grid.values.push_back(i % 20 > 10 ? 200.0f : 0.0f);
    grid.range = grid.usual = {0, 200};
    loaded.values = std::make_shared<const ValueGrid>(std::move(grid));
    loaded.greys = GreyValues{.air = 0, .dentine = 200};
    loaded.scene.volume.shows = VolumeLook::Shows::volume;
  }
  static LoadedModel loaded(const LoadRequest& request, const Progress&) {
    if (request.file == "broken.json") throw std::runtime_error("broken.json: no tooth in it");
    LoadedModel loaded;
    loaded.title = request.file.empty() ? "first" : request.file;
    loaded.model = make_model({{"ball", ball({{}, request.file.empty() ? 5.0 : 3.0})}});
    loaded.scene = usual_scene(loaded.model, 1);
    loaded.pickable = std::make_shared<const Pickable>(loaded.model);
    if (with_volume) give_volume(loaded);
    return loaded;
  }
  /// Ends after thousands of frames in any case.
  bool visit(const Watch& watch) {
    viewer = std::make_unique<Viewer>(window->context().gl(), ShaderLibrary{},
                                      ViewerOptions{.load = loaded, .side = 1, .coarse_when_slow = false});
    viewer->open({});
    HeadsetVisitOptions options;
    options.say = [this](const std::string& words) { said += words + "\n"; };
    options.watch = [&](const HeadsetFrame& frame, const Visit& now) {
      watch(frame, now);
      if (++frames == 3000) stop.request_stop();
    };
    return visit_in_headset(*viewer, *window, ShaderLibrary{}, stop.get_token(), options);
  }
  /// As a window system tells of it.
  static void drop(const char* file) {
    GLFWwindow* shown = glfwGetCurrentContext();
    const GLFWdropfun told = glfwSetDropCallback(shown, nullptr);
    glfwSetDropCallback(shown, told);
    ASSERT_NE(told, nullptr);
    told(shown, 1, &file);
  }
  void expect_the_desktop_goes_on() {
    const PixelSize size = window->size();
    viewer->draw({size, window->scale(), 0}, {0, 0, 0, size});
    EXPECT_TRUE(content_of(read_pixels(window->context().gl(), 0, size)).shows_something());
  }
};

/// Of the middle column of an eye's picture, where the tooth stands: from top to bottom.
int height_of_what_is_seen(const Gl& gl, const Target& target) {
  const Image image = read_pixels(gl, target.framebuffer, target.size);
  int seen = 0;
  for (int y = 0; y < image.height; ++y)
    if (image.pixel(image.width / 2, y) != image.pixel(0, 0)) ++seen;
  return seen;
}

TEST_F(OnADisplay, DISABLED_Dropped) {
  runtime.side = 256;
  int height_before = 0, height_after = 0;
  const bool well = visit([&](const HeadsetFrame& frame, const Visit& now) {
    const bool drawn = now.placed && now.seen.told == 0 && frame.draw;  // nothing is written below the ball
    if (drawn && height_before == 0) {
      height_before = height_of_what_is_seen(window->context().gl(), frame.targets[0]);
      drop("second.json");
    }
    if (viewer->state().shown->title != "second.json" || !drawn) return;
    height_after = height_of_what_is_seen(window->context().gl(), frame.targets[0]);
    stop.request_stop();
  });
  EXPECT_TRUE(well) << viewer->state().trouble;
  EXPECT_EQ(viewer->state().shown->title, "second.json");
  EXPECT_GT(height_after, 10);
  EXPECT_NEAR(height_after, 0.6 * height_before, 0.15 * height_before)
      << "not the new ball, which is 3 mm instead of 5";
  EXPECT_EQ(runtime.ended.back().views, 2);
  expect_the_desktop_goes_on();
}

/// Pixels that are not the background, left and right of the middle.
std::array<int, 2> seen_on_either_side(const Gl& gl, const Target& target) {
  const Image image = read_pixels(gl, target.framebuffer, target.size);
  std::array<int, 2> seen{};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.pixel(x, y) != image.pixel(0, 0)) ++seen[x < image.width / 2 ? 0 : 1];
  return seen;
}

// Of the ball's surface nothing is seen: it would be as wide on the left as on the right.
TEST_F(OnADisplay, DISABLED_Volume) {
  runtime.side = 256;
  with_volume = true;
  std::array<std::array<int, 2>, 2> eyes{};
  EXPECT_TRUE(visit([&](const HeadsetFrame& frame, const Visit& now) {
    EXPECT_GT(frame.beat, 0);
    if (!now.placed || now.seen.told != 0 || !frame.draw) return;
    for (std::size_t eye = 0; eye < 2; ++eye)
      eyes[eye] = seen_on_either_side(window->context().gl(), frame.targets[eye]);
    stop.request_stop();
  })) << viewer->state().trouble;
  for (const auto& [left, right] : eyes) {
    EXPECT_GT(left + right, 300);
    EXPECT_GT(std::max(left, right), 3 * std::min(left, right));
  }
}

TEST_F(OnADisplay, DISABLED_Unreadable) {
  const bool well = visit([&](const HeadsetFrame&, const Visit&) {
    if (frames == 20) drop("broken.json");
    if (said.find("no tooth in it") != std::string::npos) stop.request_stop();
  });
  EXPECT_TRUE(well);
  EXPECT_EQ(viewer->state().shown->title, "first");
  EXPECT_LT(frames, 3000);
  expect_the_desktop_goes_on();
}

TEST_F(OnADisplay, DISABLED_Closed) {
  EXPECT_TRUE(visit([&](const HeadsetFrame&, const Visit&) {
    if (frames == 20) glfwSetWindowShouldClose(glfwGetCurrentContext(), GLFW_TRUE);
  }));
  EXPECT_TRUE(runtime.exit_requested);
  EXPECT_LT(frames, 30);
  EXPECT_TRUE(window->closing());
}

TEST_F(OnADisplay, DISABLED_Hidden) {
  EXPECT_TRUE(visit([&](const HeadsetFrame& frame, const Visit&) {
    EXPECT_TRUE(frame.draw);
    if (frames == 20) glfwIconifyWindow(glfwGetCurrentContext());
    if (frames == 40) glfwHideWindow(glfwGetCurrentContext());
    if (frames == 60) glfwShowWindow(glfwGetCurrentContext());
    if (frames == 80) stop.request_stop();
  }));
  for (const FakeFrame& frame : runtime.ended) EXPECT_TRUE(frame.views == 2 || &frame == &runtime.ended.front());
  expect_the_desktop_goes_on();
}

TEST_F(OnADisplay, DISABLED_Clinging) {
  const auto began = std::chrono::steady_clock::now();
  EXPECT_TRUE(visit([&](const HeadsetFrame&, const Visit&) {
    runtime.obliging = false;
    if (frames == 5) stop.request_stop();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (frames > 2000) std::exit(3);
  }));
  EXPECT_TRUE(runtime.exit_requested);
  EXPECT_NE(said.find("does not let go"), std::string::npos) << said;
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
  expect_the_desktop_goes_on();
}

TEST_F(OnADisplay, DISABLED_Lost) {
  EXPECT_FALSE(visit([&](const HeadsetFrame&, const Visit&) {
    if (frames == 20) runtime.tell(XR_SESSION_STATE_LOSS_PENDING);
  }));
  EXPECT_NE(viewer->state().trouble.find("[headset-lost]"), std::string::npos) << viewer->state().trouble;
  EXPECT_LT(frames, 30);
  expect_the_desktop_goes_on();
}

TEST_F(OnADisplay, DISABLED_Menu) {
  EXPECT_TRUE(visit([&](const HeadsetFrame&, const Visit&) {
    if (frames == 20)
      for (const XrSessionState state : {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED,
                                         XR_SESSION_STATE_STOPPING, XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING})
        runtime.tell(state);
  }));
  EXPECT_FALSE(runtime.exit_requested);
  EXPECT_LT(frames, 30);
  expect_the_desktop_goes_on();
}

}  // namespace
}  // namespace odontoscope::testing_support
