// What is to be seen while the first model is being made.
#include "engine/app/draft.h"

#include <atomic>
#include <chrono>
#include <glm/common.hpp>
#include <set>
#include <thread>

#include "recon/sample/sample_tooth.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

using Drafts = ViewerTest;

/// Gives something to look at, and ends once it is let.
Loader with_a_draft(const std::atomic<bool>& let, bool fails = false) {
  return [&let, fails](const LoadRequest& request, const Progress& progress) {
    if (request.show_meanwhile) {
      LoadedModel draft = toy_tooth();
      draft.title = "Draft";
      request.show_meanwhile(std::move(draft));
    }
    while (!let) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      progress.check();
    }
    if (fails) throw UsageError("no", "Never.");
    return toy_tooth();
  };
}

TEST_F(Drafts, ADraftIsShownUntilTheModelIsThere) {
  std::atomic<bool> let = false;
  make_viewer({.load = with_a_draft(let), .with_drafts = true}).open({});
  for (int i = 0; i < 300 && !viewer().state().shown; ++i) {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_TRUE(viewer().state().shown);
  EXPECT_TRUE(viewer().state().origin.draft);
  EXPECT_EQ(viewer().state().shown->title, "Draft");
  EXPECT_TRUE(viewer().loading());
  keep_picture("draft");
  const Area area = viewer().panes().front().area;
  drag(area.left + 200, area.top + 200, area.left + 300, area.top + 220);  // it can be turned,
  const Camera turned = viewer().state().scene.camera;
  let = true;
  wait_until_loaded();
  EXPECT_FALSE(viewer().state().origin.draft);
  EXPECT_EQ(viewer().state().shown->title, "Toy tooth");
  EXPECT_EQ(viewer().state().scene.camera, turned);  // and the model goes on from there
}

/// From nothing to the picture; a machine that draws in software and has other work may take a little longer than the
/// second that is aimed at.
TEST_F(Drafts, TheSamplesDraftIsSeenSoon) {
  std::atomic<bool> let = false;
  size_ = {1280, 800};
  const auto start = std::chrono::steady_clock::now();
  make_viewer({.load =
                   [&let](const LoadRequest& request, const Progress& progress) {
                     request.show_meanwhile(app::draft_of_sample("Sample molar", progress));
                     while (!let) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                     return toy_tooth();
                   },
               .with_drafts = true})
      .open({});
  while (!viewer().state().shown && std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) frame();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("first_picture_ms", static_cast<int>(1000 * seconds));
  EXPECT_TRUE(viewer().state().origin.draft);
  EXPECT_LT(seconds, 5);
  keep_picture("sample-draft");
  let = true;
  wait_until_loaded();
}

TEST_F(Drafts, ADraftIsShownOnlyToWhomWantsItAndHasNothingElse) {
  std::atomic<bool> let = true;
  make_viewer({.load = [](const LoadRequest& request, const Progress&) {
    EXPECT_FALSE(request.show_meanwhile);
    return toy_tooth();
  }}).open({});
  wait_until_loaded();
  std::atomic<int> wanted = 0;
  make_viewer({.load =
                   [&](const LoadRequest& request, const Progress&) {
                     if (request.show_meanwhile) ++wanted;
                     return toy_tooth();
                   },
               .with_drafts = true})
      .open({});
  wait_until_loaded();
  viewer().open({});
  wait_until_loaded();
  EXPECT_EQ(wanted, 1);
}

TEST_F(Drafts, ADraftGoesWithAModelThatCannotBeMade) {
  std::atomic<bool> let = false;
  make_viewer({.load = with_a_draft(let, true), .with_drafts = true}).open({});
  for (int i = 0; i < 300 && !viewer().state().shown; ++i) {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  let = true;
  wait_until_loaded();
  EXPECT_FALSE(viewer().state().shown);
  EXPECT_TRUE(viewer().failure());
  EXPECT_NE(viewer().state().trouble, "");
}

TEST(Draft, OfTheSampleMolarIsATooth) {
  const auto draft = app::draft_of(sample_tooth(ToothKind::molar), "Sample molar", {});
  ASSERT_TRUE(draft);
  EXPECT_EQ(draft->title, "Sample molar");
  EXPECT_EQ(draft->certificate.verdict, Certificate::Verdict::look_here);
  EXPECT_NE(draft->certificate.headline.find("draft"), std::string::npos);
  EXPECT_GT(draft->triangles, 2000u);
  EXPECT_LT(draft->triangles, 40'000u);
  EXPECT_GT(draft->model.bounds_mm.high.z - draft->model.bounds_mm.low.z, 20);
  EXPECT_TRUE(draft->pickable);
}

/// Who changes the sample tooth has to make its draft anew.
TEST(Draft, OfTheSampleIsThereAtOnceAndStillItsOwn) {
  const ContourStack stack = sample_tooth(ToothKind::molar);
  const auto start = std::chrono::steady_clock::now();
  const LoadedModel draft = app::draft_of_sample("Sample molar", {});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("milliseconds", static_cast<int>(1000 * seconds));
  EXPECT_LT(seconds, 1);
  std::set<std::string> structures, drafted;
  glm::dvec3 low(1e9), high(-1e9);
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) {
      structures.insert(contour.structure);
      for (const Point2& p : contour.points) {
        low = glm::min(low, glm::dvec3(p.x, p.y, slice.z));
        high = glm::max(high, glm::dvec3(p.x, p.y, slice.z));
      }
    }
  for (const ModelPart& part : draft.model.parts)
    if (!part.cavity) drafted.insert(part.structure);
  EXPECT_EQ(drafted, structures);
  constexpr double off = 0.3;  // what simplifying and the ends beyond the last slices come to
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(draft.model.bounds_mm.low[k], low[k], off);
    EXPECT_NEAR(draft.model.bounds_mm.high[k], high[k], off);
  }
  EXPECT_EQ(draft.certificate.verdict, Certificate::Verdict::look_here);
}

TEST(Draft, IsNotMadeOfLittleOrOfWhatCannotBe) {
  ContourStack stack = sample_tooth(ToothKind::molar);
  for (Slice& slice : stack.slices)
    for (Contour& contour : slice.contours)
      std::swap(contour.points[0], contour.points[contour.points.size() / 2]);  // crosses itself
  EXPECT_FALSE(app::draft_of(stack, "x", {}));
  stack.slices.resize(10);
  EXPECT_FALSE(app::draft_of(stack, "x", {}));
}

}  // namespace
}  // namespace odontoscope::testing_support
