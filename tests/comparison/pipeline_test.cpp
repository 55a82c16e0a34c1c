// What runs again after a change, what a cancelled run leaves, and that the artefacts are those that the engine
// reports.
#include <gtest/gtest.h>

#include <chrono>
#include <glm/geometric.hpp>
#include <set>
#include <thread>

#include "engine/comparison/artefact_lesson.h"
#include "engine/comparison/db_worker.h"
#include "engine/comparison/ridges.h"
#include "engine/navigate/screen.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::testing_support {
namespace {

using Stages = std::vector<ComparisonStage>;
constexpr ComparisonStage grid = ComparisonStage::grid, field = ComparisonStage::field,
                          surface = ComparisonStage::surface, decimation = ComparisonStage::decimation,
                          inspection = ComparisonStage::inspection;

std::shared_ptr<const ContourStack> molar() {
  static const auto stack =
      std::make_shared<const ContourStack>(sample_tooth(ToothKind::molar, {.walls = SampleWalls::apart}));
  return stack;
}

ComparisonOptions coarse() { return {.grid = 40}; }

TEST(DbPipeline, RunsAgainOnlyFromWhatChanged) {
  DbPipeline pipeline(molar());
  ComparisonOptions options = coarse();
  EXPECT_EQ(pipeline.run(options)->ran, (Stages{grid, field, surface, decimation, inspection}));
  EXPECT_EQ(pipeline.run(options)->ran, Stages{});
  options.decimation = ComparisonDecimation::tenth;
  EXPECT_EQ(pipeline.run(options)->ran, (Stages{decimation, inspection}));
  options.cases = CaseTable::consistent;
  EXPECT_EQ(pipeline.run(options)->ran, (Stages{surface, decimation, inspection}));
  options.field = FieldKind::sign;
  EXPECT_EQ(pipeline.run(options)->ran, (Stages{field, surface, decimation, inspection}));
  options.grid = 44;
  EXPECT_EQ(pipeline.run(options)->ran, (Stages{grid, field, surface, decimation, inspection}));
}

TEST(DbPipeline, ComesToWhatTheEngineComesToWhateverTheWayThere) {
  DbPipeline pipeline(molar());
  ComparisonOptions options = coarse();
  for (const auto cases : {CaseTable::consistent, CaseTable::classic, CaseTable::classic_unoriented})
    for (const auto kind : {FieldKind::sign, FieldKind::hybrid}) {
      options.cases = cases;
      options.field = kind;
      const auto made = pipeline.run(options);
      DbOptions engine;
      engine.grid.columns = engine.grid.rows = options.grid;
      engine.cases = cases;
      engine.field.kind = kind;
      const DbReconstruction whole = reconstruct_by_distance(*molar(), engine);
      ASSERT_EQ(made->structures.size(), whole.surfaces.size());
      for (std::size_t i = 0; i < whole.surfaces.size(); ++i) {
        const SurfaceReport &ours = made->structures[i].report, &theirs = whole.surfaces[i].report;
        EXPECT_EQ(made->structures[i].structure, whole.surfaces[i].structure);
        EXPECT_EQ(ours.triangles, theirs.triangles);
        EXPECT_EQ(ours.boundary_edges, theirs.boundary_edges);
        EXPECT_EQ(ours.misoriented_edges, theirs.misoriented_edges);
        EXPECT_EQ(ours.shells.size(), theirs.shells.size());
      }
    }
}

TEST(DbPipeline, ACancelledRunHarmsNothing) {
  DbPipeline pipeline(molar());
  ComparisonOptions options = coarse();
  pipeline.run(options);
  options.grid = 64;
  for (int stop_after = 0; stop_after < 6; ++stop_after) {
    std::stop_source stop;
    int told = 0;
    const Progress progress{[&](std::string_view, double) {
                              if (++told > 12 * stop_after) stop.request_stop();
                            },
                            stop.get_token()};
    EXPECT_THROW(pipeline.run(options, progress), Cancelled) << stop_after;
  }
  const auto after = pipeline.run(options);
  const auto fresh = DbPipeline(molar()).run(options);
  EXPECT_EQ(after->triangles(), fresh->triangles());
  EXPECT_EQ(after->misoriented(), fresh->misoriented());
  EXPECT_EQ(after->model.parts[0].positions, fresh->model.parts[0].positions);
}

TEST(DbWorker, TheNewestWishCounts) {
  DbWorker worker(molar());
  for (const std::size_t points : {192, 160, 128, 96, 40}) worker.want({.grid = points});
  std::optional<DbWorker::Outcome> outcome;
  for (int i = 0; i < 6000 && !outcome; ++i) {
    EXPECT_TRUE(worker.working());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    outcome = worker.take();
  }
  ASSERT_TRUE(outcome && outcome->result);
  EXPECT_EQ(outcome->result->options.grid, 40u);
  EXPECT_FALSE(worker.working());
  EXPECT_FALSE(worker.take());
}

TEST(DbWorker, AskingNeverWaits) {
  DbWorker worker(molar());
  worker.want({.grid = 192});
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // in the middle of it
  worker.want({.grid = 188});
  EXPECT_FALSE(worker.take());
  EXPECT_TRUE(worker.working());
  worker.leave();
  for (int i = 0; i < 6000 && !worker.gone(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(worker.gone());
  EXPECT_FALSE(worker.take());
}

TEST(DbWorker, TellsTrouble) {
  auto empty = std::make_shared<const ContourStack>(ContourStack{{{0, {}}, {1, {}}}, "empty"});
  DbWorker worker(empty);
  worker.want({});
  std::optional<DbWorker::Outcome> outcome;
  for (int i = 0; i < 2000 && !outcome; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    outcome = worker.take();
  }
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->result);
  EXPECT_THROW(std::rethrow_exception(outcome->trouble), Error);
}

TEST(Artefacts, AreTheFacesOfTheDefects) {
  DbPipeline pipeline(molar());
  const auto made = pipeline.run({.grid = 64, .cases = CaseTable::classic});
  EXPECT_EQ(made->cracks(), 140u);              // docs/distance.md
  EXPECT_EQ(made->artefacts.size(), 140u / 4);  // a crack is the four edges round a face
  for (const ComparisonArtefact& artefact : made->artefacts) {
    EXPECT_EQ(artefact.kind, DefectKind::crack);
    ASSERT_TRUE(artefact.reason);
    EXPECT_TRUE(artefact.reason->ambiguous_face);
    EXPECT_NE(in_words(artefact, CaseTable::classic).find("Table classic"), std::string::npos);
    EXPECT_NEAR(glm::length(artefact.outward), 1, 1e-9);
  }
}

TEST(Artefacts, CracksComeFirstAndEachOnce) {
  DbPipeline pipeline(molar());
  const auto made = pipeline.run({.grid = 64});
  std::set<std::tuple<std::string, int, double, double, double>> places;
  bool misoriented = false;
  for (const ComparisonArtefact& artefact : made->artefacts) {
    misoriented = misoriented || artefact.kind == DefectKind::misoriented;
    EXPECT_TRUE(!misoriented || artefact.kind == DefectKind::misoriented);
    places.insert({artefact.structure, static_cast<int>(artefact.kind), artefact.at.x, artefact.at.y, artefact.at.z});
  }
  EXPECT_TRUE(misoriented);
  EXPECT_GT(places.size(), made->artefacts.size() * 9 /
                               10);  // faces of different cells may share a middle, where points fall together
  const auto& last = made->artefacts;
  double far = 0;
  for (std::size_t i = 1; i <= 50; ++i)
    far += glm::distance(last[last.size() - i].at, last[last.size() - i - 1].at) / 50;
  EXPECT_GT(far, 3);  // mm: one leads across the tooth, not to the neighbour
}

TEST(Artefacts, AreSeenFromWhereTheCameraGoes) {
  DbPipeline pipeline(molar());
  const auto made = pipeline.run({.grid = 64, .cases = CaseTable::classic});
  Scene scene = usual_scene(made->model, 1);
  scene.back_faces = BackFaces::show;
  std::size_t seen = 0;
  for (const ComparisonArtefact& artefact : made->artefacts) {
    for (Look& look : scene.looks) look = {look.structure, look.colour, 1, look.structure == artefact.structure};
    const Camera camera = camera_at(artefact, made->spacing_mm, scene.camera, *made->pickable, scene);
    EXPECT_NO_THROW(validate(camera, "artefact"));
    EXPECT_LT(glm::length(*place_of(camera, artefact.at)), 1e-6);  // in the middle
    const auto before = pick(*made->pickable, scene, {camera.position, -axes_of(camera).towards_eye});
    seen += !before || before->distance_mm > glm::distance(camera.position, artefact.at) - 2 * made->spacing_mm;
  }
  EXPECT_EQ(seen, made->artefacts.size());
}

TEST(Artefacts, CracksOnBroadWallsComeFirst) {
  DbPipeline pipeline(molar());
  const auto made = pipeline.run({.grid = 64, .cases = CaseTable::classic});
  Scene scene = usual_scene(made->model, 1);
  std::size_t before = 8, least = 8;
  for (const ComparisonArtefact& artefact : made->artefacts) {
    for (Look& look : scene.looks) look.visible = look.structure == artefact.structure;
    const std::size_t wall = wall_around(artefact, made->spacing_mm, *made->pickable, scene);
    EXPECT_LE(wall, before);
    before = least = wall;
  }
  EXPECT_LT(least, 8u) << "there is nothing to put in order";
}

TEST(Artefacts, DecimatedOnesHaveNoCellsToName) {
  DbPipeline pipeline(std::make_shared<const ContourStack>(sample_tooth(ToothKind::molar)));
  const auto made = pipeline.run({.grid = 64, .cases = CaseTable::classic, .decimation = ComparisonDecimation::tenth});
  EXPECT_EQ(made->artefacts.size(), made->cracks() + made->misoriented() + made->nonmanifold());
  std::size_t drawn = 0;
  for (const LineSet& set : made->faulty_edges) drawn += set.points.size() / 2;
  EXPECT_EQ(drawn, made->artefacts.size());
  EXPECT_EQ(made->nonmanifold(), 4u);  // neighbours in the list of crowded edges
  ASSERT_FALSE(made->artefacts.empty());
  EXPECT_FALSE(made->artefacts[0].reason);
  EXPECT_NE(in_words(made->artefacts[0], CaseTable::classic).find("Decimation"), std::string::npos);
}

TEST(Ridges, OfABoxAreItsEdges) {
  const SurfaceMesh box{{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}},
                        {{0, 2, 1},
                         {0, 3, 2},
                         {4, 5, 6},
                         {4, 6, 7},
                         {0, 1, 5},
                         {0, 5, 4},
                         {1, 2, 6},
                         {1, 6, 5},
                         {2, 3, 7},
                         {2, 7, 6},
                         {3, 0, 4},
                         {3, 4, 7}}};
  EXPECT_DOUBLE_EQ(ridges_mm(box), 4 * (2 + 3 + 5));
  SurfaceMesh turned = box;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);  // flat is flat, whichever way it is wound
  EXPECT_DOUBLE_EQ(ridges_mm(turned), 4 * (2 + 3 + 5));
  EXPECT_EQ(ridges_mm(box, 100), 0);
}

}  // namespace
}  // namespace odontoscope::testing_support
