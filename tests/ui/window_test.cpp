// The window, on a display that exists in memory only. Each case runs in a process of its own under xvfb-run: the
// display ends with it.
#include "engine/view/window.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/view/offscreen.h"
#include "engine/viewer/notes/notes_mode.h"
#include "engine/viewer/window_loop.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

int exit_code_of(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Runs a case below whose name begins with DISABLED_ on the display.
void run_on_display(const std::string& name) {
  const std::string xvfb = ODONTOSCOPE_XVFB_RUN;
  if (xvfb.empty()) GTEST_SKIP() << "xvfb-run is missing: no display to open a window on";
  EXPECT_EQ(exit_code_of(xvfb + " -a -s '-screen 0 1400x1000x24' '" + this_program() +
                         "' --gtest_also_run_disabled_tests --gtest_filter='OnADisplay.DISABLED_" + name + "' >&2"),
            0);
}

TEST(Window, DrawsTheSamePixelsAsEglAndOsmesa) { run_on_display("SamePixels"); }
TEST(Window, AsksAboutNotesBeforeItIsStopped) { run_on_display("AsksBeforeItIsStopped"); }
TEST(Window, OpensShowsAndCloses) { run_on_display("OpensShowsAndCloses"); }

TEST(Window, WithoutADisplayTheProgramSaysSo) {
  const std::string quiet = " 2>&1 | grep -q no-display";
  EXPECT_EQ(exit_code_of("env -u DISPLAY -u WAYLAND_DISPLAY '" ODONTOSCOPE_PROGRAM "' view" + quiet), 0);
  EXPECT_EQ(exit_code_of("env -u WAYLAND_DISPLAY DISPLAY=:4711 '" ODONTOSCOPE_PROGRAM "' view" + quiet), 0);
  EXPECT_EQ(exit_code_of("env -u DISPLAY -u WAYLAND_DISPLAY '" ODONTOSCOPE_PROGRAM "' view >/dev/null 2>&1"), 5);
}

TEST(Window, TooOldAnOpenGlIsSaid) {
  const std::string xvfb = ODONTOSCOPE_XVFB_RUN;
  if (xvfb.empty()) GTEST_SKIP() << "xvfb-run is missing";
  EXPECT_EQ(exit_code_of("MESA_GL_VERSION_OVERRIDE=3.3 " + xvfb +
                         " -a '" ODONTOSCOPE_PROGRAM "' view 2>&1 | grep -q gl-too-old"),
            0);
}

TEST(OnADisplay, DISABLED_SamePixels) {
  const Model& model = small_molar();
  Scene scene = usual_scene(model, 4.0 / 3);
  scene.section = Section{{0, 0, 10}, {0.2, 1, 0.1}};
  std::vector<Image> pictures;
  for (const Backend backend : {Backend::window, Backend::egl, Backend::osmesa}) {
    const auto context = make_context({.backend = backend, .debug = true});
    if (context->in_words().find("llvmpipe") == std::string::npos)
      return;  // a processor that draws by itself need not agree
    pictures.push_back(picture_of(*context, model, scene, {{320, 240}, {2}}));
    EXPECT_TRUE(context->debug_messages().empty());
  }
  EXPECT_TRUE(content_of(pictures[0]).shows_something());
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], pictures[2]);
}

ViewerOptions with_small_molar() {
  return {.load =
              [](const LoadRequest&, const Progress&) {
                LoadedModel loaded;
                loaded.title = "Small molar";
                loaded.model = small_molar();
                loaded.scene = usual_scene(loaded.model, 1);
                loaded.pickable = std::make_shared<const Pickable>(loaded.model);
                return loaded;
              },
          .side = 1,
          .coarse_when_slow = false};
}

/// Closes the window some frames after it was asked whether it may be.
class Impatient final : public Mode {
 public:
  using Mode::Mode;
  bool may_close() override {
    ++asked;
    return true;
  }
  void advance(double) override {
    if (asked > 0 && ++frames == 5) state_.close = true;
  }
  int asked = 0, frames = 0;
};

TEST(OnADisplay, DISABLED_AsksBeforeItIsStopped) {
  Window window({.size = {900, 600}});
  ViewerOptions options = with_small_molar();
  options.modes.insert(options.modes.begin(), mode<Impatient>);
  Viewer viewer(window.context().gl(), ShaderLibrary{}, std::move(options));
  viewer.mode<NotesMode>().notes().lesson.notes.push_back({});
  viewer.mode<NotesMode>().notes().unsaved = true;
  std::stop_source stop;
  stop.request_stop();
  run_in_window(viewer, window, stop.get_token());
  EXPECT_EQ(viewer.mode<Impatient>().asked, 1) << "a stop counts once";
  EXPECT_EQ(viewer.mode<Impatient>().frames, 5) << "the window went on";
  EXPECT_TRUE(viewer.mode<NotesMode>().notes().leaving) << "and asks";
}

TEST(OnADisplay, DISABLED_OpensShowsAndCloses) {
  small_molar();  // made once, before the clock runs
  Window window({.size = {900, 600}, .debug = true});
  Viewer viewer(window.context().gl(), ShaderLibrary{}, with_small_molar());
  viewer.open({});
  std::stop_source stop;
  std::jthread closer([&stop] {
    std::this_thread::sleep_for(std::chrono::seconds(3));
    stop.request_stop();
  });
  run_in_window(viewer, window, stop.get_token());
  EXPECT_TRUE(viewer.state().shown);
  // What stands in the window's own pixels is a lit tooth beside a panel.
  const PixelSize size = window.size();
  viewer.draw({size, window.scale(), 0}, {0, 0, 0, size});
  const Image shown = read_pixels(window.context().gl(), 0, size);
  EXPECT_TRUE(content_of(shown).shows_something());
  EXPECT_GT(content_of(shown).colours, 200u);
  EXPECT_TRUE(window.context().debug_messages().empty()) << window.context().debug_messages().front();
}

}  // namespace
}  // namespace odontoscope::testing_support
