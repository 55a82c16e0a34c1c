// `compare-images` where the second folder holds what is drawn first: GLB files, scenes, pages.

#include <filesystem>

#include "engine/picture/png.h"
#include "tests/app/program.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

constexpr const char* no_browser = "no-such-browser";

/// Draws a square on a colour, a moment after it was loaded, and says so.
std::string page(const std::string& colour, const std::string& says = "root.setAttribute('data-drawn', '')") {
  return "<!DOCTYPE html><html><meta "
         "charset=utf-8><style>body{margin:0;background:#102030}div{width:40px;height:30px;background:" +
         colour +
         "}</style><body><script>const root = document.documentElement;setTimeout(() => "
         "{document.body.append(document.createElement('div'));" +
         says + "}, 150)</script>";
}

class Shots : public ProgramTest {
 protected:
  void SetUp() override {
    for (const char* name : {"expected/views", "actual/views"}) std::filesystem::create_directories(folder / name);
  }
  Ending compared(std::vector<std::string> more = {}) {
    std::vector<std::string> words{"compare-images", "expected",      "actual", "--channel",    "0", "--share", "0",
                                   "--report",       "actual/v.json", "--html", "actual/v.html"};
    words.insert(words.end(), more.begin(), more.end());
    return odontoscope(words);
  }
  Ending accepted(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"compare-images", "expected", "actual", "--accept"});
    return odontoscope(more);
  }
  void plant_pixel(const std::string& name) {
    Image picture = read_png((folder / name).string());
    auto pixel = picture.pixel(5, 5);
    pixel[0] = static_cast<std::uint8_t>(pixel[0] ^ 1);
    picture.set_pixel(5, 5, pixel);
    write_png(picture, (folder / name).string());
  }
};

class DrawnShots : public Shots {
 protected:
  void SetUp() override {
    const PerhapsContext made = try_context(Backend::automatic);
    if (!made.context) GTEST_SKIP() << "no picture can be drawn here: " << made.reason;
    Shots::SetUp();
    given("cube.json", cube_stack());
    ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "actual/cube.glb"}).exit_code, 0);
    ASSERT_EQ(odontoscope({"render", "cube.json", "-o", "x.png", "--size", "80x60", "--view", "lingual", "--save-scene",
                           "actual/views/side.json"})
                  .exit_code,
              0);
  }
};

TEST_F(DrawnShots, OfGlbFilesAndScenesAreWhatRenderDraws) {
  ASSERT_EQ(odontoscope({"render", "actual/cube.glb", "-o", "expected/cube.png", "--size", "64x48"}).exit_code, 0);
  ASSERT_EQ(odontoscope({"render", "cube.json", "-o", "expected/views/side.png", "--scene", "actual/views/side.json"})
                .exit_code,
            0);
  const Ending ending = compared({"--model", "cube.json"});
  EXPECT_EQ(ending.exit_code, 0) << ending.out << ending.err;
  EXPECT_TRUE(ending.says("2 of 2 pictures alike")) << ending.out;
  EXPECT_EQ(compared({"--model", "cube.json"}).exit_code, 0) << "report and page of the call before are no pictures";
  plant_pixel("expected/views/side.png");
  const Ending planted = compared({"--model", "cube.json"});
  EXPECT_EQ(planted.exit_code, 1);
  EXPECT_TRUE(planted.says("views/side.png: different: 1 of 4800 pixels")) << planted.out;
  EXPECT_NE(bytes_of("actual/v.html").find("<h2>views/side.png</h2>"), std::string::npos);
}

TEST_F(DrawnShots, AreAcceptedAsWhatIsExpectedAndAGlbIsSeenByTheSceneOfItsName) {
  std::filesystem::rename(folder / "actual/views/side.json", folder / "actual/cube.json");
  given("expected/views/old.png", png_bytes(Image(8, 8)));
  given("actual/flat.png", png_bytes(Image(8, 8)));
  const Ending ending = accepted();
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("2 pictures expected from now on")) << ending.out;
  EXPECT_TRUE(ending.says("old.png stays")) << ending.out;
  EXPECT_EQ(bytes_of("expected/flat.png"), bytes_of("actual/flat.png"));
  ASSERT_EQ(odontoscope({"render", "actual/cube.glb", "-o", "x.png", "--scene", "actual/cube.json"}).exit_code, 0);
  EXPECT_EQ(bytes_of("expected/cube.png"), bytes_of("x.png"));
  std::filesystem::remove(folder / "expected/views/old.png");
  EXPECT_EQ(compared().exit_code, 0);
  EXPECT_EQ(odontoscope({"compare-images", "expected/cube.png", "actual/cube.glb", "--channel", "0", "--share", "0",
                         "--difference", "d.png"})
                .exit_code,
            1)
      << "without the scene";
  EXPECT_EQ(read_png((folder / "d.png").string()).width, 80);
}

TEST_F(DrawnShots, ThatCannotBeDrawnAreToldAndStopNothing) {
  given("actual/bad.glb", "glTF, but not really");
  ASSERT_EQ(odontoscope({"render", "actual/cube.glb", "-o", "expected/cube.png", "--size", "64x48"}).exit_code, 0);
  std::filesystem::remove(folder / "actual/views/side.json");
  given("expected/bad.png", bytes_of("expected/cube.png"));
  const Ending ending = compared();
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_TRUE(ending.says("bad.png: unreadable: ")) << ending.out;
  EXPECT_TRUE(ending.says("[cannot-be-shot]")) << ending.out;
  EXPECT_TRUE(ending.says("1 of 2 pictures alike")) << ending.out;
}

TEST_F(Shots, ThatMakeNoSenseAreRefused) {
  given("actual/scene.json", R"({"format":"odontoscope.scene","version":1})");
  given("actual/other.json", R"({"format":"something else"})");
  Ending ending = compared();
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_TRUE(ending.complains("scene.json is a scene, and nothing says of what. Give --model FILE")) << ending.err;
  std::filesystem::remove(folder / "actual/scene.json");
  given("actual/a.html", page("red"));
  given("actual/a.png", png_bytes(Image(8, 8)));
  ending = compared();
  EXPECT_EQ(ending.exit_code, 2);
  EXPECT_TRUE(ending.complains("are both the picture a.png")) << ending.err;
  std::filesystem::remove(folder / "actual/a.png");
  EXPECT_EQ(accepted({"--report", "r.json"}).exit_code, 2);
}

TEST_F(Shots, OfAPageWithoutABrowserAreAClearError) {
  given("actual/a.html", page("red"));
  const std::string here = folder.path().string();
  Ending ending = run({.arguments = {"compare-images", "expected", "actual"},
                       .folder = here,
                       .environment = {{"PATH", "/nowhere"}, {"ODONTOSCOPE_BROWSER", ""}}});
  EXPECT_EQ(ending.exit_code, 5);
  EXPECT_TRUE(ending.complains("Install chromium, or name one by --browser or ODONTOSCOPE_BROWSER. [no-browser]"))
      << ending.err;
  ending = run({.arguments = {"compare-images", "expected", "actual", "--browser", no_browser}, .folder = here});
  EXPECT_TRUE(ending.says("no-such-browser: does not start")) << ending.out << ending.err;
  ending = run({.arguments = {"compare-images", "expected", "actual", "--browser", "true"}, .folder = here});
  EXPECT_TRUE(ending.says("true ended before it was drawn")) << ending.out << ending.err;
  ending = run(
      {.arguments = {"compare-images", "expected", "actual", "--browser", "cat", "--timeout", "1"}, .folder = here});
  EXPECT_EQ(ending.exit_code, 1) << ending.out << ending.err;
}

class PageShots : public Shots {
 protected:
  void SetUp() override {
    const char* const browser = ODONTOSCOPE_CHROMIUM;
    if (!std::filesystem::exists(browser)) GTEST_SKIP() << "Chromium was not found (Debian: chromium)";
    Shots::SetUp();
    browser_ = browser;
  }
  std::string browser_;
};

TEST_F(PageShots, AreTakenOnceThePageSaysThatItHasDrawn) {
  given("expected/views/a b.png", png_bytes(Image(120, 90)));  // its size counts
  given("actual/views/a b.html", page("rgb(200, 100, 50)"));
  ASSERT_EQ(accepted({"--browser", browser_}).exit_code, 0);
  const Image shot = read_png((folder / "expected/views/a b.png").string());
  EXPECT_EQ(shot.width, 120);
  EXPECT_EQ(shot.height, 90);
  EXPECT_EQ(shot.pixel(10, 10), (std::array<std::uint8_t, 4>{200, 100, 50, 255}));
  EXPECT_EQ(shot.pixel(100, 80), (std::array<std::uint8_t, 4>{0x10, 0x20, 0x30, 255}));
  EXPECT_EQ(compared({"--browser", browser_}).exit_code, 0);
  plant_pixel("expected/views/a b.png");
  const Ending planted = compared({"--browser", browser_});
  EXPECT_EQ(planted.exit_code, 1);
  EXPECT_TRUE(planted.says("views/a b.png: different: 1 of 10800 pixels")) << planted.out;
}

TEST_F(PageShots, OfPagesThatFailHangOrWantTheNetworkAreTold) {
  const char* const fetches =
      "fetch('http://127.0.0.1:1/').then(() => root.setAttribute('data-failed', 'it came through'), () => "
      "root.setAttribute('data-drawn', ''))";
  given("actual/asks.html", page("red", fetches));
  given("actual/fails.html", page("red", "root.setAttribute('data-failed', 'no WebGL')"));
  given("actual/hangs.html", page("red", ""));
  const Ending ending = compared({"--browser", browser_, "--timeout", "8"});
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_FALSE(ending.says("it came through")) << ending.out;
  EXPECT_TRUE(ending.says("asks.png: unexpected")) << ending.out;
  EXPECT_TRUE(ending.says("it says that it cannot be drawn: no WebGL")) << ending.out;
  EXPECT_TRUE(ending.says("it has not said that it has drawn within 8 s")) << ending.out;
}

}  // namespace
}  // namespace odontoscope::testing_support
