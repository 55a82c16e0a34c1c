// Work off the frame thread: progress, cancelling, errors in words, and frames that go on meanwhile.
#include <atomic>
#include <chrono>
#include <new>
#include <thread>

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
  EXPECT_GT(viewer.patience(), 0);          // no busy waiting either
  EXPECT_LT(viewer.patience(), 0.1);
}

TEST_F(Loading, ANewOneReplacesOneThatRuns) {
  std::atomic<bool> stopped = false;
  const Loader first = endless(stopped);
  make_viewer({.load = [&first](const LoadRequest& request, const Progress& progress) { return request.file == "first" ? first(request, progress) : toy_tooth(); }});
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
    EXPECT_NE(viewer().state().trouble.find(memory ? "memory" : "map::at"), std::string::npos) << viewer().state().trouble;
  }
}

TEST_F(Loading, AVolumeIsAskedAbout) {
  LoadRequest got;
  make_viewer({.load = [&got](const LoadRequest& request, const Progress&) { got = request; return toy_tooth(); },
               .is_volume = [](const std::string& file) { return file.ends_with(".nrrd"); }});
  viewer().handle(FilesDropped{{"/data/tooth.nrrd"}});
  frames(3);
  ASSERT_TRUE(viewer().state().question);
  EXPECT_FALSE(viewer().loading());
  keep_picture("volume-question");
  viewer().state().question->iso = 130;
  click_control("Make the model", {}, "question");
  frame();
  wait_until_loaded();
  EXPECT_EQ(got.file, "/data/tooth.nrrd");
  EXPECT_EQ(got.iso, 130.0);
  EXPECT_TRUE(viewer().state().shown);
}

TEST_F(Loading, AViewerMayEndWhileItLoads) {
  std::atomic<bool> stopped = false;
  make_viewer({.load = endless(stopped)}).open({});
  frame();
  make_viewer();   // ends the first
  EXPECT_TRUE(stopped);
}

}  // namespace
}  // namespace odontoscope::testing_support
