// Machines that cannot draw, made from this one: by libraries in the way that cannot be loaded, by a driver told to be
// old, by no display.

#include "tests/app/program.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

using Environment = std::vector<std::pair<std::string, std::string>>;

const Environment no_display = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};

class NoGraphics : public ProgramTest {
 protected:
  void SetUp() override { given("cube.json", cube_stack()); }

  Ending render(const std::string& backend, Environment environment) {
    environment.insert(environment.end(), no_display.begin(), no_display.end());
    return run({.arguments = {"render", "cube.json", "-o", "x.png", "--size", "80x60", "--backend", backend},
                .folder = folder.path().string(),
                .environment = environment});
  }
  /// Libraries of these names are found first, and are none.
  Environment without(const std::vector<std::string>& libraries) {
    for (const std::string& name : libraries) given(name, "no library");
    return {{"LD_LIBRARY_PATH", folder.path().string()}};
  }
  void expect_refused(const Ending& ending, const std::vector<std::string>& words) {
    EXPECT_EQ(ending.exit_code, 5) << ending.err;
    for (const std::string& part : words)
      EXPECT_TRUE(ending.complains(part)) << "not in: " << ending.err << "\nwanted: " << part;
    EXPECT_FALSE(exists("x.png"));
  }
};

const std::vector<std::string> egl = {"libEGL.so.1", "libEGL.so"};
const std::vector<std::string> osmesa = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};

TEST_F(NoGraphics, WithoutEgl) {
  expect_refused(render("egl", without(egl)), {"[no-egl]", "libEGL.so.1", "Install EGL"});
}

TEST_F(NoGraphics, WithoutOSMesa) {
  expect_refused(render("osmesa", without(osmesa)), {"[no-osmesa]", "libOSMesa.so.8", "Install OSMesa"});
}

TEST_F(NoGraphics, WithNothingAtAllAutoTellsWhatEachSaid) {
  std::vector<std::string> both = egl;
  both.insert(both.end(), osmesa.begin(), osmesa.end());
  expect_refused(render("auto", without(both)), {"libEGL.so.1", "libOSMesa.so.8"});
}

TEST_F(NoGraphics, WithoutEglAutoDrawsByOSMesaAndSaysSo) {
  if (!try_context(Backend::osmesa).context) GTEST_SKIP() << "no OSMesa here";
  const Ending ending = render("auto", without(egl));
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("osmesa")) << ending.out;
  EXPECT_TRUE(exists("x.png"));
}

TEST_F(NoGraphics, WithTooOldADriver) {
  if (!try_context(Backend::egl).context) GTEST_SKIP() << "no EGL here";
  expect_refused(render("egl", {{"MESA_GL_VERSION_OVERRIDE", "3.3"}, {"LIBGL_ALWAYS_SOFTWARE", "1"}}),
                 {"[gl-too-old]", "4.1"});
}

TEST_F(NoGraphics, WithoutADisplayForAWindow) {
  expect_refused(render("window", {}), {"[no-display]", "DISPLAY"});
  const Ending view =
      run({.arguments = {"view", "cube.json"}, .folder = folder.path().string(), .environment = no_display});
  EXPECT_EQ(view.exit_code, 5) << view.err;
  EXPECT_TRUE(view.complains("odontoscope render")) << view.err;
}

TEST_F(NoGraphics, WithADisplayThatIsNotThere) {
  const Ending view = run({.arguments = {"view", "cube.json"},
                           .folder = folder.path().string(),
                           .environment = {{"DISPLAY", ":4711"}, {"WAYLAND_DISPLAY", ""}}});
  EXPECT_EQ(view.exit_code, 5) << view.err;
  EXPECT_TRUE(view.complains("[no-display]")) << view.err;
}

}  // namespace
}  // namespace odontoscope::testing_support
