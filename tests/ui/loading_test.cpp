// Work off the frame thread: progress, cancelling, errors in words, and frames that go on meanwhile.
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <new>
#include <thread>

#include "recon/volume/read_volume.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

using Loading = ViewerTest;

/// Works until it is stopped, and says how far it is.
Loader endless(std::atomic<bool>& stopped) {
  return [&stopped](const LoadRequest&, const Progress& progress) -> LoadedModel {
    progress.tell("conform", 0.4);
    while (!progress.stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    stopped = true;
    progress.check();
    return {};
  };
}

TEST_F(Loading, ShowsProgressAndStopsWhenAsked) {
  std::atomic<bool> stopped = false;
  make_viewer({.load = endless(stopped)}).open({.file = "/somewhere/tooth.json"});
  frames(5, 0.01);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  frames(3, 0.01);
  ASSERT_TRUE(viewer().loading());
  keep_picture("loading");
  press_key(Key::escape);
  wait_until_loaded();
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(viewer().state().shown);
  EXPECT_FALSE(viewer().failure());
  ASSERT_EQ(viewer().state().notices.size(), 1u);
  EXPECT_EQ(viewer().state().notices[0].words, "Stopped.");
}

TEST_F(Loading, TheCancelButtonStopsIt) {
  std::atomic<bool> stopped = false;
  make_viewer({.load = endless(stopped)}).open({});
  frames(5);
  click_control("Cancel", {}, "loading");
  for (int i = 0; i < 300 && !stopped; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(stopped);
}

TEST_F(Loading, FramesGoOnWhileItWorks) {
  std::atomic<bool> stopped = false;
  viewer_with_tooth();
  ViewerOptions options{.load = endless(stopped)};
  Viewer& viewer = make_viewer(std::move(options));
  viewer.open({});
  for (int i = 0; i < 10; ++i) frame();
  EXPECT_TRUE(viewer.loading());
  EXPECT_GT(viewer.wait_timeout(), 0);  // no busy waiting either
  EXPECT_LT(viewer.wait_timeout(), 0.1);
}

TEST_F(Loading, ANewOneReplacesOneThatRuns) {
  std::atomic<bool> stopped = false;
  const Loader first = endless(stopped);
  make_viewer({.load = [&first](const LoadRequest& request, const Progress& progress) {
    return request.file == "first" ? first(request, progress) : toy_tooth();
  }});
  viewer().open({.file = "first"});
  frames(3);
  viewer().open({.file = "second"});
  wait_until_loaded();
  ASSERT_TRUE(viewer().state().shown);
  EXPECT_EQ(viewer().state().shown->title, "Toy tooth");
}

TEST_F(Loading, ErrorsAreShownInWordsAndTheOldModelStays) {
  bool fail = false;
  viewer_with_tooth({.load = [&fail](const LoadRequest&, const Progress&) -> LoadedModel {
    if (fail) throw FileError("tooth.json", "cannot be read: No such file or directory", "Check its name.");
    return toy_tooth();
  }});
  const auto before = viewer().state().shown;
  fail = true;
  viewer().handle(FilesDropped{{"tooth.json"}});
  frame();
  wait_until_loaded();
  EXPECT_NE(viewer().state().trouble.find("tooth.json"), std::string::npos);
  EXPECT_EQ(viewer().state().shown, before);
  EXPECT_TRUE(viewer().failure());
  keep_picture("trouble");
  const Image with = picture();
  press_key(Key::escape);
  EXPECT_EQ(viewer().state().trouble, "");
  EXPECT_NE(picture(), with);
}

TEST_F(Loading, WhateverIsThrownIsSaid) {
  for (const bool memory : {true, false}) {
    make_viewer({.load = [memory](const LoadRequest&, const Progress&) -> LoadedModel {
      if (memory) throw std::bad_alloc();
      throw std::out_of_range("map::at");
    }});
    viewer().open({});
    wait_until_loaded();
    EXPECT_NE(viewer().state().trouble.find(memory ? "memory" : "map::at"), std::string::npos)
        << viewer().state().trouble;
  }
}

bool is_nrrd(const LoadRequest& request) { return !request.volume && request.file.ends_with(".nrrd"); }

TEST_F(Loading, AVolumeIsAskedAbout) {
  LoadRequest got;
  make_viewer({.load =
                   [&got](const LoadRequest& request, const Progress&) {
                     got = request;
                     return toy_tooth();
                   },
               .wants_level = is_nrrd});
  viewer().handle(FilesDropped{{"/data/tooth.nrrd"}});
  frames(3);
  ASSERT_TRUE(mode<OpenMode>().question());
  EXPECT_FALSE(viewer().loading());
  keep_picture("volume-question");
  mode<OpenMode>().question()->iso = 130;
  click_control("Make the model", {}, "question");
  frame();
  wait_until_loaded();
  EXPECT_EQ(got.file, "/data/tooth.nrrd");
  ASSERT_TRUE(got.volume);
  EXPECT_EQ(got.volume->iso, 130.0);
  EXPECT_TRUE(viewer().state().shown);
}

/// A ball of 200 in 0, with a hollow of 100; as labels of 2 around 1.
Volume ball(bool labels) {
  Volume volume;
  volume.size = {40, 30, 20};
  volume.spacing = {0.5, 0.5, 1};
  for (std::size_t k = 0; k < 20; ++k)
    for (std::size_t j = 0; j < 30; ++j)
      for (std::size_t i = 0; i < 40; ++i) {
        const double x = 0.5 * (static_cast<double>(i) - 20), y = 0.5 * (static_cast<double>(j) - 14),
                     z = static_cast<double>(k) - 9;
        const double radius = std::sqrt(x * x + y * y + z * z);
        const bool hollow = radius < 2, inside = radius < 6;
        volume.values.push_back(labels   ? (hollow   ? 1.0f
                                            : inside ? 2.0f
                                                     : 0.0f)
                                : hollow ? 100.0f
                                : inside ? 200.0f
                                         : 0.37f * static_cast<float>((i + j + k) % 3));
      }
  if (labels) volume.labels = {{1, "pulp"}, {2, "dentine"}};
  return volume;
}

TEST(VolumePreviews, TellTheSizeOfTheFileAndNotOfTheSamples) {
  Volume samples = ball(false);
  samples.merged = {2, 2, 1};
  samples.size_before = {79, 60, 20};
  const VolumePreview preview = volume_preview(samples);
  EXPECT_EQ(preview.size, (std::array<std::size_t, 3>{79, 60, 20}));
  EXPECT_EQ(preview.spacing_mm, (std::array<double, 3>{0.25, 0.25, 1}));
  EXPECT_EQ(preview.values.size, samples.size);
}

class VolumeAsked : public Loading {
 protected:
  /// As ImGui names a window within another.
  static std::string child_of(const std::string& window, const std::string& name) {
    return fmt::format("{}/{}_{:08X}", window, name, control_id(name, {}, window));
  }

  void ask(Previewer preview) {
    make_viewer({.load =
                     [this](const LoadRequest& request, const Progress&) {
                       got = request;
                       return toy_tooth();
                     },
                 .wants_level = is_nrrd,
                 .preview = std::move(preview)});
    viewer().open({.file = "/data/tooth.nrrd", .volume = {}, .from_command_line = true});
    for (int i = 0; i < 500 && mode<OpenMode>().question() && mode<OpenMode>().question()->reading; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      frame();
    }
    frames(4);
  }
  LoadRequest got;
};

TEST_F(VolumeAsked, ShowsASliceItsOutlineAndTheGreyValues) {
  ask([](const LoadRequest&, const Progress&) { return volume_preview(ball(false)); });
  ASSERT_TRUE(mode<OpenMode>().question() && mode<OpenMode>().question()->preview);
  const VolumeQuestion& question = *mode<OpenMode>().question();
  EXPECT_GT(question.iso, 2);  // Otsu's
  EXPECT_LT(question.iso, 200);
  EXPECT_EQ(question.slice, 10u);  // the middle one, of three with as much of the ball
  EXPECT_GT(question.drawn.outline.size(), 40u);
  keep_picture("volume-preview");
  const Image before = picture();
  mode<OpenMode>().question()->slice = 4;
  frames(2);
  EXPECT_NE(picture(), before);
  mode<OpenMode>().question()->slice = 10;
  frames(2);
  const std::size_t outline = question.drawn.outline.size();
  const glm::dvec2 bar = control("##histogram", {}, child_of("question", "answers"));
  click(bar.x, bar.y);  // near its right end: above all but the last values
  frames(2);
  EXPECT_GT(question.iso, 150);
  EXPECT_NE(question.drawn.outline.size(), outline);
  const double iso = question.iso;
  click_control("Make the model", {}, "question");
  frame();
  wait_until_loaded();
  ASSERT_TRUE(got.volume);
  EXPECT_EQ(got.volume->iso, iso);
  EXPECT_TRUE(got.volume->labels.empty());
  EXPECT_TRUE(got.from_command_line);  // its looks and the rest of what was said hold
}

TEST_F(VolumeAsked, TheValueMovesWithTheMouseAndItsOutlineWithIt) {
  ask([](const LoadRequest&, const Progress&) { return volume_preview(ball(false)); });
  ASSERT_TRUE(mode<OpenMode>().question() && mode<OpenMode>().question()->preview);
  const VolumeQuestion& question = *mode<OpenMode>().question();
  const glm::dvec2 bar = control("##histogram", {}, child_of("question", "answers"));
  move(bar.x - 190, bar.y);
  press();
  frame();
  double before = -1;
  std::vector<std::size_t> outlines;
  for (int step = 0; step < 5; ++step) {
    move(bar.x - 190 + 35 * step, bar.y);
    frames(2);
    EXPECT_GT(question.iso, before);
    EXPECT_EQ(question.drawn.iso, question.iso);
    before = question.iso;
    outlines.push_back(question.drawn.outline.size());
  }
  release();
  frame();
  move(bar.x - 190, bar.y);  // without the button nothing moves
  frames(2);
  EXPECT_EQ(question.iso, before);
  EXPECT_GT(std::set<std::size_t>(outlines.begin(), outlines.end()).size(), 1u);
}

TEST_F(VolumeAsked, OfSeveralSeriesItIsAskedFirstWhichOne) {
  std::vector<std::string> previewed;
  ask([&previewed](const LoadRequest& request, const Progress&) {
    previewed.push_back(request.series);
    if (!request.series.empty()) return volume_preview(ball(false));
    VolumePreview several;
    several.series.resize(3);
    several.series[0] = {.modality = "CT",
                         .description = "Scout",
                         .columns = 512,
                         .rows = 512,
                         .slices = 2,
                         .first_file = "/data/A/IM0001",
                         .files = 2};
    several.series[1] = {.modality = "CT",
                         .description = "Bone 0.5",
                         .columns = 512,
                         .rows = 512,
                         .slices = 300,
                         .pixel_mm = std::array<double, 2>{0.25, 0.25},
                         .apart_mm = 0.5,
                         .first_file = "/data/B/IM0001",
                         .files = 300};
    several.series[2] = {
        .modality = "MR", .description = "Film", .trouble = "time-series", .first_file = "/data/C/IM0001", .files = 9};
    return several;
  });
  ASSERT_TRUE(mode<OpenMode>().question());
  EXPECT_EQ(mode<OpenMode>().question()->series.size(), 3u);
  EXPECT_FALSE(mode<OpenMode>().question()->preview);
  keep_picture("series-question");
  press_key(Key::enter);  // nothing to make yet
  frames(2);
  ASSERT_TRUE(mode<OpenMode>().question());
  click_control("2   CT   Bone 0.5", {"/data/B/IM0001"}, child_of("question", "series"));
  for (int i = 0; i < 500 && !(mode<OpenMode>().question() && mode<OpenMode>().question()->preview); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    frame();
  }
  frames(4);
  EXPECT_EQ(previewed, (std::vector<std::string>{"", "2"}));
  click_control("Make the model", {}, "question");
  frame();
  wait_until_loaded();
  EXPECT_EQ(got.series, "2");
  EXPECT_TRUE(got.volume && got.volume->iso);
  EXPECT_TRUE(got.from_command_line);
}

TEST_F(VolumeAsked, OfTheCtMolarOtsuFindsTheTooth) {
  const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
  if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file))
    GTEST_SKIP() << "the data set ct_molar is not here";
  ask([file](const LoadRequest&, const Progress&) { return volume_preview(read_volume(file.string())); });
  ASSERT_TRUE(mode<OpenMode>().question() && mode<OpenMode>().question()->preview);
  keep_picture("volume-preview-ct");
  EXPECT_FALSE(mode<OpenMode>().question()->of_labels());
  EXPECT_GT(mode<OpenMode>().question()->iso, 60);  // 120 is what the examples take
  EXPECT_LT(mode<OpenMode>().question()->iso, 160);
}

TEST_F(VolumeAsked, ListsTheLabelsOfALabelMap) {
  ask([](const LoadRequest&, const Progress&) { return volume_preview(ball(true)); });
  ASSERT_TRUE(mode<OpenMode>().question() && mode<OpenMode>().question()->of_labels());
  keep_picture("label-map-preview");
  EXPECT_EQ(mode<OpenMode>().question()->labels, (std::set<std::int64_t>{1, 2}));
  mode<OpenMode>().question()->as_grey = true;
  frames(2);
  EXPECT_FALSE(mode<OpenMode>().question()->of_labels());
  mode<OpenMode>().question()->as_grey = false;
  mode<OpenMode>().question()->labels = {};
  frames(2);
  press_key(Key::enter);  // nothing to make
  frames(2);
  ASSERT_TRUE(mode<OpenMode>().question());
  mode<OpenMode>().question()->labels = {2};
  frames(2);
  click_control("Make the model", {}, "question");
  frame();
  wait_until_loaded();
  ASSERT_TRUE(got.volume);
  EXPECT_FALSE(got.volume->iso);
  EXPECT_EQ(got.volume->labels, std::vector<std::int64_t>{2});
}

TEST_F(VolumeAsked, WhatCannotBeReadIsSaidAtOnce) {
  ask([](const LoadRequest&, const Progress&) -> VolumePreview {
    throw FileError("tooth.nrrd", "its pixels end early", "Fetch it again.");
  });
  EXPECT_FALSE(mode<OpenMode>().question());
  EXPECT_NE(viewer().state().trouble.find("end early"), std::string::npos);
}

TEST_F(VolumeAsked, AnAnswerNeedNotWaitForThePicture) {
  std::atomic<bool> stopped = false;
  make_viewer({.load =
                   [this](const LoadRequest& request, const Progress&) {
                     got = request;
                     return toy_tooth();
                   },
               .wants_level = is_nrrd,
               .preview = [&stopped](const LoadRequest&, const Progress& progress) -> VolumePreview {
                 while (!progress.stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                 stopped = true;
                 throw Cancelled();
               }});
  viewer().open({.file = "/data/tooth.nrrd", .volume = {}});
  frames(3);
  click_control("Make the model", {}, "question");
  frame();
  wait_until_loaded();
  EXPECT_EQ(got.volume.value().iso, 120.0);
  for (int i = 0; i < 500 && !stopped; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    frame();
  }
  EXPECT_TRUE(stopped);
}

TEST_F(Loading, AViewerMayEndWhileItLoads) {
  std::atomic<bool> stopped = false;
  make_viewer({.load = endless(stopped)}).open({});
  frame();
  make_viewer();  // ends the first
  EXPECT_TRUE(stopped);
}

}  // namespace
}  // namespace odontoscope::testing_support
