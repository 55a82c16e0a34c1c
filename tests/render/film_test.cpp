// Films of a tour by a program called ffmpeg: a small one that says what it was given stands in for it. The real one is
// tried by hand.

#include <signal.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <thread>

#include "engine/picture/film_file.h"
#include "engine/picture/png.h"
#include "tests/app/program.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

namespace fs = std::filesystem;

std::string ring(double radius) {
  std::string points;
  for (int i = 0; i < 16; ++i) {
    const double turn = 2 * 3.14159265358979 * i / 16;
    points += std::string(i == 0 ? "[" : ",[") + std::to_string(radius * std::cos(turn)) + "," +
              std::to_string(radius * std::sin(turn)) + "]";
  }
  return R"({"structure":"tooth","points":[)" + points + "]}";
}

/// A tooth of 12 mm that is hollow, so wide at each height.
std::string hollow_tooth(const std::function<double(double)>& radius) {
  std::string text = R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[)";
  for (int slice = 0; slice <= 24; ++slice) {
    const double z = 0.5 * slice;
    const double hollow = radius(z);
    text += std::string(slice == 0 ? "{" : ",{") + "\"z\":" + std::to_string(z) + ",\"contours\":[" + ring(4) +
            (hollow > 0 ? "," + ring(hollow) : "") + "]}";
  }
  return text + "]}";
}

/// A chamber with one canal below it, closed all round.
std::string tooth_with_a_canal() {
  return hollow_tooth([](double z) { return z < 1 || z > 11 ? 0 : z < 8 ? 0.4 : 2; });
}

class Film : public ProgramTest {
 protected:
  void SetUp() override {
    const PerhapsContext made = try_context(Backend::automatic);
    if (!made.context) GTEST_SKIP() << "no picture can be drawn here: " << made.reason;
    given("tooth.json", tooth_with_a_canal());
    fs::create_directory(folder / "bin");
    fs::create_directory(folder / "frames");
  }
  /// The film that ffmpeg is to write is the last of its words.
  void ffmpeg_is(const std::string& script) {
    given("bin/ffmpeg", "#!/bin/sh\nfor film; do :; done\n" + script);
    fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
  }
  Ending render(std::vector<std::string> options) {
    std::vector<std::string> words = {"render", "tooth.json", "--samples", "1"};
    for (const auto& [option, usual] : {std::pair("--tour", "canal-1"), std::pair("--size", "64x48")})
      if (std::find(options.begin(), options.end(), option) == options.end())
        words.insert(words.end(), {option, usual});
    words.insert(words.end(), options.begin(), options.end());
    return run({.arguments = words,
                .folder = folder.path().string(),
                .environment = {{"PATH", (folder / "bin").string() + ":/usr/bin:/bin"}}});
  }
  std::size_t files() const { return folder.names().size(); }
};

constexpr std::size_t picture_bytes = 4 * 64 * 48;

TEST_F(Film, GetsEveryPictureAndIsWrittenWhole) {
  ffmpeg_is("echo \"$@\" > words\ncat > pictures\necho film of $(wc -c < pictures) bytes > \"$film\"\n");
  const Ending ending = render({"--frames", "7", "-o", "x.mp4"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("Wrote x.mp4")) << ending.out;
  EXPECT_EQ(bytes_of("x.mp4"), "film of " + std::to_string(7 * picture_bytes) + " bytes\n");
  for (const char* word : {"-pix_fmt rgba -s 64x48 -r 30 -i pipe:0", "-pix_fmt yuv420p", "-c:v libx264", "-f mp4"})
    EXPECT_NE(bytes_of("words").find(word), std::string::npos) << bytes_of("words");
  // The pictures are those that a folder gets.
  ASSERT_EQ(render({"--frames", "7", "-o", "frames"}).exit_code, 0);
  const Image third = read_png((folder / "frames/frame-0002.png").string());
  EXPECT_EQ(bytes_of("pictures").substr(2 * picture_bytes, picture_bytes),
            std::string(third.rgba.begin(), third.rgba.end()));
  EXPECT_NE(third, read_png((folder / "frames/frame-0000.png").string()));
}

TEST_F(Film, InReverseIsTheSameTheOtherWayRoundInPlaceAndLooksBack) {
  ffmpeg_is("echo \"$@\" > words\ncat > /dev/null\necho film > \"$film\"\n");
  ASSERT_EQ(render({"--frames", "3", "-o", "frames"}).exit_code, 0);
  const std::string there = bytes_of("frames/frame-0000.png");
  ASSERT_EQ(render({"--frames", "3", "--reverse", "-o", "frames"}).exit_code, 0);
  EXPECT_NE(bytes_of("frames/frame-0000.png"), there);
  const Ending ending = render({"--reverse", "--frames", "2", "-o", "x.WEBM"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_NE(bytes_of("words").find("-c:v libvpx-vp9"), std::string::npos);
}

TEST_F(Film, WithoutFramesHasThirtyASecond) {
  ffmpeg_is("cat | wc -c > \"$film\"\n");
  const Ending ending = render({"--size", "2x2", "-o", "x.mp4"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const std::size_t at = ending.out.find("The tour takes ");
  ASSERT_NE(at, std::string::npos) << ending.out;
  const double seconds = std::stod(ending.out.substr(at + 15)), pictures = std::stod(bytes_of("x.mp4")) / 16;
  EXPECT_NEAR(pictures, 30 * seconds + 1, 3) << "a tenth of a second is not said";
}

TEST_F(Film, OnAPathWithoutFfmpegIsRefusedAtOnce) {
  given("x.mp4", "old");
  const std::size_t before = files();
  const Ending ending = run({.arguments = {"render", "tooth.json", "--tour", "canal-1", "-o", "x.mp4"},
                             .folder = folder.path().string(),
                             .environment = {{"PATH", (folder / "bin").string()}}});
  EXPECT_EQ(ending.exit_code, 4);
  EXPECT_TRUE(ending.complains("x.mp4: cannot be made")) << ending.err;
  EXPECT_TRUE(ending.complains("Debian: ffmpeg")) << ending.err;
  EXPECT_FALSE(ending.complains("certify")) << "the long work was done first: " << ending.err;
  EXPECT_EQ(bytes_of("x.mp4"), "old");
  EXPECT_EQ(files(), before);
}

TEST_F(Film, FailuresOfFfmpegAreToldAndTouchNothing) {
  given("x.mp4", "old");
  const std::size_t before = files();
  const std::vector<std::pair<std::string, const char*>> failures = {
      {"cat > /dev/null; echo first >&2; echo Unknown encoder libx264 >&2; exit 3\n",
       "ended with exit code 3: Unknown encoder libx264"},
      {"exit 1\n", "ended with exit code 1"},
      {"cat > /dev/null; kill -9 $$\n", "was ended by signal 9"},
      {"exec < /dev/null; exit 0\n", "exit code 0"},
      {"cat > /dev/null\n", "wrote nothing"},
  };
  for (const auto& [script, words] : failures) {
    ffmpeg_is(script);
    const Ending ending = render({"--frames", "40", "-o", "x.mp4"});
    EXPECT_EQ(ending.exit_code, 4) << script;
    EXPECT_TRUE(ending.complains("x.mp4: cannot be made: ffmpeg")) << ending.err;
    EXPECT_TRUE(ending.complains(words)) << ending.err;
    EXPECT_EQ(bytes_of("x.mp4"), "old");
    EXPECT_EQ(files(), before) << script;
  }
}

TEST_F(Film, WhenInterruptedKillsFfmpeg) {
  ffmpeg_is("echo $$ > " + (folder / "pid").string() + "\nexec sleep 100\n");  // takes no picture
  const std::string usual = std::getenv("PATH");
  ::setenv("PATH", ((folder / "bin").string() + ":/usr/bin:/bin").c_str(), 1);
  std::stop_source stop;
  const Progress progress{{}, stop.get_token()};
  std::thread someone([&] {
    while (!exists("pid") || bytes_of("pid").empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    stop.request_stop();
  });
  {
    FilmMaker maker((folder / "x.mp4").string(), {1000, 1000});
    EXPECT_THROW(while (true) maker.add(Image(1000, 1000), progress), Cancelled);
  }
  someone.join();
  ::setenv("PATH", usual.c_str(), 1);
  EXPECT_NE(::kill(std::atoi(bytes_of("pid").c_str()), 0), 0) << "it still runs";
  EXPECT_FALSE(exists("x.mp4"));
}

TEST_F(Film, SenselessWordsAreAnswered) {
  ffmpeg_is("exit 1\n");
  const std::vector<std::pair<std::vector<std::string>, const char*>> wrong = {
      {{"-o", "x.mp4", "--size", "65x48"}, "even"},
      {{"-o", "x.png"}, "-o tour.mp4"},
      {{"-o", "x.mp4", "--tour", "canal-9"}, "canal-1"},
      {{"-o", "x.mp4", "--void", "2"}, "there is one void"},
      {{"-o", "x.png", "--contact-sheet", "4"}, "4x3"},
      {{"-o", "x.png", "--contact-sheet", "0x3"}, "4x3"},
      {{"-o", "x.png", "--contact-sheet", "2x2", "--frames", "3"}, "--frames"},
      {{"-o", "x.mp4", "--contact-sheet", "2x2"}, ".png"},
      {{"-o", "x.png", "--contact-sheet", "20x20", "--size", "2000x2000"}, "smaller --size"},
  };
  for (const auto& [options, answer] : wrong) {
    const Ending ending = render(options);
    EXPECT_EQ(ending.exit_code, 2) << options[1] << " " << ending.err;
    EXPECT_TRUE(ending.complains(answer)) << ending.err;
    EXPECT_FALSE(exists(options[1]));
  }
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--reverse"}, {"--contact-sheet", "2x2"}, {"--frames", "2"}}) {
    std::vector<std::string> all = {"render", "tooth.json", "-o", "x.png"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(odontoscope(all).exit_code, 2) << words[0];
  }
}

/// What is on a sheet of pictures of 64 x 48, row by row.
struct Sheet {
  std::vector<Image> pictures, words;
  int beyond = 0;  // pixels of words beside the pictures that they belong to
};

Sheet read_sheet(const std::string& file, int columns, int rows) {
  const Image whole = read_png(file);
  EXPECT_EQ(whole.width, columns * (64 + 4) + 4);
  EXPECT_EQ(whole.height, rows * (48 + 14) + 4);
  const auto part = [&](int left, int top, int width, int height) {
    Image cut(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) cut.set_pixel(x, y, whole.pixel(left + x, top + y));
    return cut;
  };
  const auto bright = [](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i] > 60;
    return count;
  };
  Sheet sheet;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int left = 4 + column * 68, top = 4 + row * 62;
      sheet.pictures.push_back(part(left, top, 64, 48));
      sheet.words.push_back(part(left, top + 48, 64, 12));
      sheet.beyond += bright(part(left + 64, top + 48, 4, 12));
      EXPECT_GT(bright(sheet.words.back()), 20) << column << " " << row;
    }
  }
  return sheet;
}

void expect_no_two_alike(const std::vector<Image>& pictures) {
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t before = 0; before < i; ++before)
      EXPECT_FALSE(pictures[before] == pictures[i]) << before << " and " << i;
}

TEST_F(Film, AContactSheetHasAllPicturesAndWords) {
  const Ending ending = render({"--contact-sheet", "3x2", "-o", "sheet.png"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Sheet sheet = read_sheet((folder / "sheet.png").string(), 3, 2);
  expect_no_two_alike(sheet.pictures);
  EXPECT_NE(sheet.words.front(), sheet.words.back());
  EXPECT_EQ(sheet.beyond, 0) << "words run into the next picture's";
}

TEST_F(Film, AContactSheetOfAShortTourHasNoPictureTwice) {
  const std::tuple<const char*, const char*, std::string> voids[] = {
      {"a chamber alone", "horn-1", hollow_tooth([](double z) { return z < 4 || z > 6 ? 0 : 2; })},
      {"a chamber no wider than its canal's mouth", "canal-1",
       hollow_tooth([](double z) { return z < 1 || z > 10 ? 0 : 0.3 + 0.12 * z; })}};
  for (const auto& [name, line, tooth] : voids) {
    SCOPED_TRACE(name);
    given("tooth.json", tooth);
    for (const bool back : {false, true}) {
      std::vector<std::string> words = {"--tour", line, "--contact-sheet", "4x2", "-o", "sheet.png"};
      if (back) words.emplace_back("--reverse");
      const Ending ending = render(words);
      ASSERT_EQ(ending.exit_code, 0) << ending.err;
      const Sheet sheet = read_sheet((folder / "sheet.png").string(), 4, 2);
      expect_no_two_alike(sheet.pictures);
      EXPECT_NE(sheet.words.front(), sheet.words.back());
    }
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
