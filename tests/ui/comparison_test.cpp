// DB mode: DT and DB of the same tooth, driven by keys and mouse.
#include <chrono>
#include <glm/geometric.hpp>
#include <thread>

#include "engine/navigate/screen.h"
#include "engine/picture/image_difference.h"
#include "engine/viewer/compare/compare_panel.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/sample/sample_tooth.h"
#include "tests/ui/driver.h"
#include "tests/ui/teeth.h"

namespace odontoscope::testing_support {
namespace {

/// The sample molar with its contours, as the program's loader delivers it.
LoadedModel load(const SampleOptions& options) {
  LoadedModel made;
  made.title = "Sample molar";
  made.overlays.contours = sample_tooth(ToothKind::molar, options);
  std::vector<NamedSurface> surfaces;
  for (Solid& solid : reconstruct(made.overlays.contours).solids) {
    made.triangles += solid.surface.triangles.size();
    surfaces.push_back({solid.structure, std::move(solid.surface)});
  }
  made.model = make_model(surfaces);
  made.overlays.faulty_edges = faulty_edges(surfaces, made.model);
  made.scene = usual_scene(made.model, 1.2);
  made.scene.occlusion.on = false;
  made.pickable = std::make_shared<const Pickable>(made.model);
  made.certificate = {Certificate::Verdict::certified, "Certified: closed, manifold, facing outwards", {}};
  return made;
}

/// Coarse enough to be made in a moment.
const LoadedModel& molar() {
  static const LoadedModel loaded = load({.slice_spacing = 0.35, .point_spacing = 0.5});
  return loaded;
}

class Lab : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (IsSkipped()) return;
    size_ = {900, 640};
    viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) { return molar(); }});
  }
  ComparisonState& compared() { return mode<CompareMode>().state(); }
  /// From the menu, where it is the last of the lessons.
  void begin_lesson() {
    type(U'g');
    type(U'6');
    frame();
  }
  void wait_until_made() {
    for (int i = 0; i < 6000; ++i) {
      frame(0);
      if (compared().made && compared().made->options == compared().wanted) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(compared().made && compared().made->options == compared().wanted);
    frames(3);
  }
  void settle() { frames(9, 0.06); }
};

/// The share of a pane's pixels, below its labels and above the dialog, that two pictures show differently.
double share_that_differs(const Image& a, const Image& b, const Area& area) {
  std::size_t differ = 0, all = 0;
  for (int y = static_cast<int>(area.top) + 160; y < static_cast<int>(area.top + area.height) - 60; ++y)
    for (int x = static_cast<int>(area.left); x < static_cast<int>(area.left + area.width); ++x) {
      ++all;
      const auto p = a.pixel(x, y), q = b.pixel(x, y);
      differ += p[0] != q[0] || p[1] != q[1] || p[2] != q[2];
    }
  return static_cast<double>(differ) / static_cast<double>(all);
}

TEST_F(Lab, OneKeyLeadsInAndOutAgain) {
  const Scene before = viewer().state().scene;
  type(U'd');
  EXPECT_TRUE(compared().on);
  EXPECT_EQ(viewer().panes().size(), 1u);  // DT stays until DB is ready
  EXPECT_FALSE(viewer().panes()[0].db);
  keep_picture("comparison-making");
  wait_until_made();
  ASSERT_EQ(viewer().panes().size(), 2u);
  EXPECT_FALSE(viewer().panes()[0].db);
  EXPECT_TRUE(viewer().panes()[1].db);
  EXPECT_EQ(viewer().panes()[0].camera, viewer().panes()[1].camera);
  EXPECT_EQ(viewer().state().scene.back_faces, BackFaces::cull);
  keep_picture("comparison-both");
  type(U'd');
  EXPECT_FALSE(compared().on);
  EXPECT_EQ(viewer().panes().size(), 1u);
  EXPECT_EQ(viewer().state().scene, before);
}

TEST_F(Lab, ThePanelHasAButtonForIt) {
  click_control("Compare with DB (D)");
  EXPECT_TRUE(compared().on);
  wait_until_made();
  click_control("Split", {"layout"});
  EXPECT_EQ(compared().layout, ComparisonLayout::split);
  click_control("DT", {"layout"});
  frame();
  ASSERT_EQ(viewer().panes().size(), 1u);
  EXPECT_FALSE(viewer().panes()[0].db);
  click_control("Two-sided", {"comparison faces"});
  EXPECT_EQ(viewer().state().scene.back_faces, BackFaces::show);
  click_control("Leave DB mode (D)");
  EXPECT_FALSE(compared().on);
}

TEST_F(Lab, IsOnlyForWhatHasContours) {
  viewer_with_tooth();  // three balls that came from nowhere
  type(U'd');
  EXPECT_FALSE(compared().on);
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices[0].words.find("contours"), std::string::npos);
}

/// The paper's lesson.
TEST_F(Lab, HolesOfTheUnorientedTableVanishWhenBothSidesAreDrawn) {
  type(U'd');
  wait_until_made();
  ASSERT_EQ(compared().made->options.cases, CaseTable::classic_unoriented);
  const Area dt = viewer().panes()[0].area, db = viewer().panes()[1].area;
  frames(4);
  const Image culled = picture();
  type(U'b');
  const Image both_sides = picture();
  keep_picture("comparison-two-sided");
  EXPECT_GT(share_that_differs(culled, both_sides, db), 0.05);
  EXPECT_LT(share_that_differs(culled, both_sides, dt),
            1e-4);  // single pixels on a rim, where front and back are equally deep
  // A table whose cases are turned over has no such holes.
  type(U'b');
  type(U'b');
  compared().wanted.cases = CaseTable::consistent;
  wait_until_made();
  const Image oriented = picture();
  type(U'b');
  EXPECT_EQ(share_that_differs(oriented, picture(), db), 0);
}

TEST_F(Lab, ASplitViewShowsWhatEachMethodShowsInPlace) {
  type(U'd');
  wait_until_made();
  type(U'x');
  frames(3);
  ASSERT_TRUE(!viewer().panes()[0].db);
  const Image dt = picture();
  type(U'x');
  frames(3);
  ASSERT_TRUE(viewer().panes()[0].db);
  const Image db = picture();
  keep_picture("comparison-in-place");
  compared().layout = ComparisonLayout::split;
  frames(3);
  const Image split = picture();
  keep_picture("comparison-split");
  Area left = viewer().panes()[0].shown(), right = viewer().panes()[1].shown();
  left.width -= 20;  // the line
  right.left += 20;
  right.width -= 20;
  EXPECT_EQ(share_that_differs(split, dt, left), 0);
  EXPECT_EQ(share_that_differs(split, db, right), 0);
  EXPECT_GT(share_that_differs(split, dt, right), 0.02);
  // The line follows the hand, and the tooth does not.
  const Camera still = viewer().state().scene.camera;
  const double line = right.left - 20, y = 300;
  drag(line, y, line - 200, y);
  EXPECT_NEAR(viewer().panes()[1].shown().left, line - 200, 2);
  EXPECT_EQ(viewer().state().scene.camera, still);
  drag(line + 100, y, line + 160, y);
  EXPECT_NE(viewer().state().scene.camera, still);
}

TEST_F(Lab, LinkedCamerasTurnTogether) {
  type(U'd');
  wait_until_made();
  const Area right = viewer().panes()[1].area;
  const Camera before = viewer().state().scene.camera;
  drag(right.left + 200, 400, right.left + 260, 420);
  EXPECT_NE(viewer().state().scene.camera, before);
  EXPECT_EQ(viewer().panes()[0].camera, viewer().panes()[1].camera);
  // What is pointed at is the method's that one points at.
  move(right.left + right.width / 2, 250);  // the crown
  EXPECT_TRUE(viewer().pointing().hit);
}

TEST_F(Lab, ASliderRunsOnlyWhatItTouchesWhileThePictureStays) {
  type(U'd');
  wait_until_made();
  const auto first = compared().made;
  EXPECT_EQ(first->ran.size(), 5u);
  click_control("Consistent", {"cases"});
  frame();
  EXPECT_EQ(compared().made, first);  // until the next is ready
  EXPECT_EQ(viewer().panes().size(), 2u);
  wait_until_made();
  EXPECT_EQ(compared().made->ran,
            (std::vector{ComparisonStage::surface, ComparisonStage::decimation, ComparisonStage::inspection}));
  EXPECT_EQ(compared().made->cracks() + compared().made->misoriented(), 0u);
  click_control("1/10", {"decimation"});
  wait_until_made();
  EXPECT_EQ(compared().made->ran, (std::vector{ComparisonStage::decimation, ComparisonStage::inspection}));
  EXPECT_LT(compared().made->triangles(), first->triangles() / 9);
  const glm::dvec2 slider = control("Grid points across");
  drag(slider.x - 150, slider.y, slider.x - 190,
       slider.y);  // a run for each place that it passes, all but the last outdated
  wait_until_made();
  EXPECT_LT(compared().made->options.grid, 64u);
  EXPECT_EQ(compared().made->options.grid % 4, 0u);
}

TEST_F(Lab, FramesGoOnWhileItWorks) {
  type(U'd');
  wait_until_made();
  viewer().state().settings.panel = false;
  compared().wanted.grid = 160;
  frame();
  int waited = 0;
  for (; compared().run.working && waited < 100000; ++waited) {
    EXPECT_EQ(compared().made->options.grid, 64u);
    EXPECT_LT(viewer().wait_timeout(), 0.1);
    frame(0);
  }
  EXPECT_GT(waited, 3);
  wait_until_made();
}

TEST_F(Lab, TheNextArtefactIsFlownToAndExplained) {
  type(U'd');
  compared().wanted.cases = CaseTable::classic;
  wait_until_made();
  const Camera before = viewer().state().scene.camera;
  type(U'n');
  ASSERT_TRUE(compared().artefact);
  EXPECT_EQ(viewer().wait_timeout(), 0);  // on its way
  settle();
  const ComparisonArtefact& first = compared().made->artefacts[0];
  EXPECT_LT(glm::distance(viewer().state().scene.camera.target, first.at), 1e-6);
  EXPECT_GT(glm::distance(viewer().state().scene.camera.position, before.position), 1);
  EXPECT_TRUE(viewer().state().scene.overlays.edges);
  const std::string words = in_words(first, compared().made->options.cases);
  EXPECT_NE(words.find("Table classic:"), std::string::npos) << words;
  EXPECT_NE(words.find("crack"), std::string::npos) << words;
  keep_picture("comparison-artefact");
  type(U'n');
  settle();
  EXPECT_EQ(compared().artefact, 1u);
  type(U'v');
  type(U'v');
  settle();
  EXPECT_EQ(compared().artefact, compared().made->artefacts.size() - 1);
  press_key(Key::escape);
  EXPECT_FALSE(compared().artefact);
  for (const Look& look : viewer().state().scene.looks) EXPECT_TRUE(look.visible);
}

TEST_F(Lab, WithoutArtefactsItSaysSo) {
  type(U'd');
  compared().wanted.cases = CaseTable::consistent;
  wait_until_made();
  type(U'n');
  EXPECT_FALSE(compared().artefact);
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("no artefact"), std::string::npos);
}

TEST_F(Lab, CountsOfDtAreThoseOfItsSurface) {
  const FaultyEdges dt = faulty_edges_of(molar());
  EXPECT_EQ(dt.cracks + dt.misoriented + dt.nonmanifold, 0u);
  LoadedModel broken = molar();
  broken.overlays.faulty_edges = {{LineKind::boundary_edge, "pulp", std::vector<glm::vec3>(6)},
                                  {LineKind::misoriented_edge, "pulp", std::vector<glm::vec3>(2)}};
  EXPECT_EQ(faulty_edges_of(broken).cracks, 3u);
  EXPECT_EQ(faulty_edges_of(broken).misoriented, 1u);
}

TEST_F(Lab, TheLessonGoesStepByStep) {
  size_ = {1280, 800};
  viewer_with_tooth(
      {.load = [](const LoadRequest&, const Progress&) { return load({}); }});  // its claims are of the sample as it is
  begin_lesson();
  ASSERT_TRUE(compared().lesson);
  const std::size_t steps = compared().lesson->steps.size();
  press_key(Key::page_up);
  EXPECT_EQ(compared().step, 0u);
  for (std::size_t i = 0; i < steps; ++i) {
    const ArtefactLessonStep& step = compared().lesson->steps[i];
    EXPECT_EQ(compared().step, i);
    EXPECT_EQ(compared().wanted, step.db);
    EXPECT_EQ(compared().layout, step.layout);
    wait_until_made();
    settle();
    EXPECT_EQ(compared().artefact.has_value(), step.at_artefact) << step.title;
    for (const Claim& claim : step.claims) EXPECT_TRUE(holds(claim, *compared().made)) << step.title;
    keep_picture("lesson-" + std::to_string(i + 1));
    press_key(Key::page_down);
  }
  EXPECT_EQ(compared().step, steps - 1);
  press_key(Key::page_up);
  EXPECT_EQ(compared().step, steps - 2);
  press_key(Key::escape);
  EXPECT_FALSE(compared().lesson);
  EXPECT_TRUE(compared().on);
}

/// With the model as the program makes it, whose dentine has its cavity as a part of its own.
TEST_F(Lab, TheCrackOfTheLessonIsLookedAtInBothHalves) {
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) { return sample_tooth_loaded(); }});
  begin_lesson();
  press_key(Key::page_down);
  press_key(Key::page_down);
  wait_until_made();
  settle();
  ASSERT_TRUE(compared().artefact);
  ASSERT_EQ(viewer().panes().size(), 2u);
  keep_picture("lesson-crack");
  for (const ViewPane& pane : viewer().panes()) {
    int met = 0;  // not in the very middle, which is the crack
    for (const double across : {0.4, 0.6})
      for (const double down : {0.4, 0.6}) {
        move(pane.area.left + pane.area.width * across, pane.area.top + pane.area.height * down);
        met += viewer().pointing().hit.has_value();
      }
    EXPECT_GE(met, 3) << (pane.db ? "DB" : "DT");
  }
}

TEST_F(Lab, TheLessonLoadsTheSampleMolarFirst) {
  std::vector<std::string> loaded;
  viewer_with_tooth({.load = [&loaded](const LoadRequest& request, const Progress&) {
    loaded.push_back(request.file);
    return molar();
  }});
  viewer().open({.file = "another.json"});
  wait_until_loaded();
  begin_lesson();
  frame();
  wait_until_loaded();
  EXPECT_EQ(loaded, (std::vector<std::string>{"", "another.json", ""}));
  EXPECT_TRUE(compared().lesson);
}

TEST_F(Lab, AnotherModelEndsIt) {
  type(U'd');
  compared().wanted.grid = 192;
  frames(2);
  viewer().open({});
  wait_until_loaded();
  EXPECT_FALSE(compared().on);
  EXPECT_FALSE(compared().made);
  type(U'd');
  compared().wanted.grid = 32;
  wait_until_made();
}

TEST_F(Lab, TroubleIsSaidAndThePictureStays) {
  viewer_with_tooth({.load = [](const LoadRequest&, const Progress&) {
    LoadedModel loaded = molar();
    for (Contour& contour : loaded.overlays.contours.slices[5].contours) contour.points.resize(2);
    return loaded;
  }});
  type(U'd');
  for (int i = 0; i < 2000 && compared().trouble.empty(); ++i) {
    frame(0);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_NE(compared().trouble.find("slice 5"), std::string::npos) << compared().trouble;
  EXPECT_FALSE(compared().run.working);
  EXPECT_EQ(viewer().panes().size(), 1u);
  keep_picture("comparison-trouble");
}

}  // namespace
}  // namespace odontoscope::testing_support
