// `odontoscope web` as a process. What the page does in a browser is judged in tests/judges.

#include <filesystem>
#include <string>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Web : public ProgramTest {
 protected:
  /// Makes the page, or skips the test where this program was built without one.
  Ending web(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "web");
    Ending ending = odontoscope(std::move(arguments));
    without_page_ = ending.exit_code == 2 && ending.complains("was built without its web page");
    return ending;
  }
  bool without_page_ = false;
};

TEST_F(Web, GivesTheSameBytesOnAnyNumberOfThreads) {
  given("cube.json", cube_stack());
  const Ending one = web({"cube.json", "-o", "one.html", "--db", "--grid", "16", "--threads", "1"});
  if (without_page_) GTEST_SKIP() << one.err;
  ASSERT_EQ(one.exit_code, 0) << one.err;
  ASSERT_EQ(web({"cube.json", "-o", "two.html", "--db", "--grid", "16", "--threads", "2"}).exit_code, 0);
  EXPECT_EQ(bytes_of("one.html"), bytes_of("two.html"));
  EXPECT_TRUE(one.says("Green: certified")) << one.out;
}

TEST_F(Web, TakesMeshesBackAsTheyWereWritten) {
  given("cube.json", cube_stack());
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "cube.glb", "-o", "cube.stl", "-o", "cube.ply"}).exit_code,
            0);
  for (const char* mesh : {"cube.glb", "cube.stl", "cube.ply"}) {
    const Ending made = web({mesh, "-o", "cube.html"});
    if (without_page_) GTEST_SKIP() << made.err;
    EXPECT_EQ(made.exit_code, 0) << mesh << made.err;
    EXPECT_TRUE(made.says("Sound")) << mesh << made.out;
  }
  EXPECT_EQ(bytes_of("cube.html").find("external external"), std::string::npos);
}

TEST_F(Web, WritesTextOfTheInputAsText) {
  given("cube.json", cube_stack());
  const Ending made = web({"cube.json", "-o", "cube.html", "--title", "</title><script>bite()</script>"});
  if (without_page_) GTEST_SKIP() << made.err;
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string html = bytes_of("cube.html");
  EXPECT_EQ(html.find("<script>bite"), std::string::npos);
  EXPECT_NE(html.find("&lt;/title&gt;&lt;script&gt;bite()"), std::string::npos);
}

TEST_F(Web, IsOnePageThatKnowsNoOtherPlace) {
  given("cube.json", cube_stack());
  const Ending made = web({"cube.json", "-o", "cube.html"});
  if (without_page_) GTEST_SKIP() << made.err;
  const std::string html = bytes_of("cube.html");
  EXPECT_LT(html.size(), 1'500'000u);
  for (const char* from_elsewhere : {"<script src", "<link rel=\"stylesheet", "@import", "<img src", "<iframe"})
    EXPECT_EQ(html.find(from_elsewhere), std::string::npos) << from_elsewhere;
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(html.find("Permission is hereby granted"), std::string::npos);  // three.js's licence
}

constexpr const char* lesson =
    R"({"format":"odontoscope.tour","version":2,"title":"Two </script> steps","model":"cube.json","notes":[)"
    R"({"title":"One","text":"<b>","camera":{"position":[0,9,0],"target":[0,0,0],"up":[0,0,1]}}]})";

TEST_F(Web, OpensWithALessonOnTheModelThatItNames) {
  std::filesystem::create_directory(folder.path() / "lessons");
  given("lessons/cube.json", cube_stack());
  given("lessons/two.tour.json", lesson);
  const Ending made = web({"lessons/two.tour.json", "-o", "lesson.html"});
  if (without_page_) GTEST_SKIP() << made.err;
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string html = bytes_of("lesson.html");
  EXPECT_NE(html.find("<title>Two &lt;/script&gt; steps</title>"), std::string::npos);
  const std::size_t tour = html.find("id=\"tour\">");
  ASSERT_NE(tour, std::string::npos);
  EXPECT_EQ(html.substr(tour, html.find("</script>", tour) - tour).find("\"<b>\""), std::string::npos);
  given("cube.json", cube_stack());
  ASSERT_EQ(web({"cube.json", "--lesson", "lessons/two.tour.json", "-o", "other.html", "--title", "Mine"}).exit_code,
            0);
  EXPECT_NE(bytes_of("other.html").find("<title>Mine</title>"), std::string::npos);
  EXPECT_NE(bytes_of("other.html").find("id=\"tour\">"), std::string::npos);
  ASSERT_EQ(web({"cube.json", "--lesson", "Find your way", "-o", "other.html"}).exit_code,
            0);  // it comes with the program
  EXPECT_NE(bytes_of("other.html").find("<title>Find your way</title>"), std::string::npos);
}

TEST_F(Web, RefusesABadLessonAndTouchesNothing) {
  given("old.html", "old");
  given("cube.json", cube_stack());
  given("bad.tour.json", R"({"format":"odontoscope.tour","version":2,"title":"","notes":[]})");
  given("good.tour.json", lesson);
  EXPECT_EQ(web({"bad.tour.json", "-o", "old.html"}).exit_code, without_page_ ? 2 : 3);
  EXPECT_EQ(web({"cube.json", "--lesson", "missing.tour.json", "-o", "old.html"}).exit_code, 4);
  EXPECT_EQ(web({"good.tour.json", "--lesson", "good.tour.json", "-o", "old.html"}).exit_code, 2);
  const Ending over = web({"good.tour.json", "-o", "good.tour.json"});
  EXPECT_EQ(over.exit_code, 2);
  EXPECT_EQ(bytes_of("good.tour.json"), lesson);
  EXPECT_EQ(bytes_of("old.html"), "old");
}

TEST_F(Web, RefusesWhatMakesNoSenseAndTouchesNothing) {
  given("cube.json", cube_stack());
  given("old.html", "old");
  EXPECT_EQ(web({"cube.json"}).exit_code, 2);
  EXPECT_EQ(web({"cube.json", "-o", "old.txt"}).exit_code, 2);
  const Ending grid = web({"cube.json", "-o", "old.html", "--grid", "64"});
  EXPECT_EQ(grid.exit_code, 2);
  EXPECT_TRUE(grid.complains("--db"));
  const Ending volume = web({"scan.nrrd", "-o", "old.html"});
  EXPECT_EQ(volume.exit_code, 2);
  EXPECT_TRUE(volume.complains("--iso"));
  EXPECT_NE(web({"missing.json", "-o", "old.html"}).exit_code, 0);
  given("bad.json", "{\"format\": \"odontoscope.contours\"");
  EXPECT_NE(web({"bad.json", "-o", "old.html"}).exit_code, 0);
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "cube.stl"}).exit_code, 0);
  EXPECT_EQ(web({"cube.stl", "-o", "old.html", "--db"}).exit_code, 2);
  EXPECT_EQ(bytes_of("old.html"), "old");
  EXPECT_FALSE(exists("old.txt"));
}

}  // namespace
}  // namespace odontoscope::testing_support
