// view --script: the viewer without hands, as a user asks for it.
#include "engine/picture/png.h"
#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Scripts : public ProgramTest {
 protected:
  /// Or a skip where nothing can be drawn.
  Ending played(const std::string& script, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"view", "tooth.json", "--size", "480x360", "--script", script};
    words.insert(words.end(), more.begin(), more.end());
    if (!exists("tooth.json")) std::filesystem::copy_file(ODONTOSCOPE_SMALL_TOOTH, folder / "tooth.json");
    return odontoscope(words);
  }
  Image picture(const std::string& name) { return read_png((folder / name).string()); }
  void expect_drawn_again(const std::string& name) {
    const Ending again = odontoscope({"render", "tooth.json", "--scene", name + ".json", "-o", "again.png"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(bytes_of(name + ".png") == bytes_of("again.png")) << name;
  }
};

TEST_F(Scripts, SavePicturesThatRenderDrawsAgainToThePixel) {
  const Ending ending = played(
      "shot:first.png 1 shot:buccal.png s format:200,150,4 picture:cut.png scene:cut.json s drag:350,150,400,190 "
      "scroll:2 w picture:turned.png scene:turned.json "
      "shot:last.png format:120,120,1 c hold:w,0.2 picture:inside.png scene:inside.json");
  if (ending.exit_code == 5) GTEST_SKIP() << ending.err;
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("Wrote cut.png")) << ending.out;
  EXPECT_EQ(picture("first.png").width, 480);
  EXPECT_EQ(picture("cut.png").width, 200);
  EXPECT_EQ(picture("cut.png").height, 150);
  for (const auto& [one, other] :
       {std::pair{"first.png", "buccal.png"}, {"buccal.png", "last.png"}, {"first.png", "last.png"}})
    EXPECT_NE(picture(one), picture(other)) << one << " " << other;
  for (const char* name : {"cut.png", "turned.png", "inside.png"})
    EXPECT_TRUE(content_of(picture(name)).shows_something()) << name;
  EXPECT_NE(picture("cut.png").pixel(100, 75), picture("cut.png").pixel(2, 2));
  for (const char* name : {"cut", "turned", "inside"}) expect_drawn_again(name);
}

TEST_F(Scripts, DoTheSameEachTime) {
  const std::string script = "2 wait:0.4 s move:300,180 shot:a.png";
  const Ending ending = played(script);
  if (ending.exit_code == 5) GTEST_SKIP() << ending.err;
  const std::string first = bytes_of("a.png");
  given("steps.txt", "# the same, as a file\n2 wait:0.4\n\ns move:300,180 shot:a.png\n");
  std::filesystem::remove(folder / "a.png");
  EXPECT_EQ(played("@steps.txt").exit_code, 0);
  EXPECT_TRUE(first == bytes_of("a.png"));
  EXPECT_EQ(played("2 wait:0.4 s f9 shot:a.png").exit_code, 0);
  EXPECT_FALSE(first == bytes_of("a.png"));
}

TEST_F(Scripts, AreRefusedBeforeAnythingIsDone) {
  for (const auto& [script, words] :
       std::vector<std::pair<std::string, std::string>>{{"dance", "is no step"},
                                                        {"click:5", "is no step"},
                                                        {"click:5,x", "is no step"},
                                                        {"drag:1,2,3", "is no step"},
                                                        {"wait:-1", "Wait from 0 to 600"},
                                                        {"wait:1e9", "Wait from 0 to 600"},
                                                        {"hold:w", "is no step"},
                                                        {"hold:,1", "is no step"},
                                                        {"shot:a.jpg", ".png"},
                                                        {"scene:a.png", ".json"},
                                                        {"shot:", "is no step"},
                                                        {"", "no step in it"},
                                                        {"'x", "quote"},
                                                        {"format:0,5,4", "Write width and height"},
                                                        {"format:10,10,5", "1, 4, 9 or 16"},
                                                        {"s shot:none/a.png", "none"}}) {
    const Ending ending = played(script);
    EXPECT_TRUE(ending.exit_code == 2 || ending.exit_code == 4) << script << ": " << ending.exit_code;
    EXPECT_TRUE(ending.complains(words)) << script << ": " << ending.err;
  }
  EXPECT_EQ(played("@none.txt").exit_code, 4);
  EXPECT_EQ(played("s", {"--vr"}).exit_code, 2);
  EXPECT_FALSE(exists("a.png"));
}

}  // namespace
}  // namespace odontoscope::testing_support
