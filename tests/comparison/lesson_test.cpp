// The lesson says what is true, and its reader takes nothing else than a lesson.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/comparison/artefact_lesson.h"
#include "engine/comparison/ridges.h"
#include "recon/core/error.h"
#include "recon/delaunay/verdict.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/partition/reconstruct_structures.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::testing_support {
namespace {

std::string one_step(const std::string& changed = "", const std::string& by = "") {
  std::string text =
      R"({"format":"odontoscope.lesson","version":1,"title":"T","steps":[{"title":"A","words":"B","layout":"db",)"
      R"("db":{"grid":24,"field":"sign","cases":"consistent","decimate":"half"},"claims":[{"quantity":"cracks","at_most":0}],)"
      R"("scene":{"format":"odontoscope.scene","version":1,"wire":true}}]})";
  if (!changed.empty()) {
    const std::size_t at = text.find(changed);
    EXPECT_NE(at, std::string::npos) << changed;
    text.replace(at, changed.size(), by);
  }
  return text;
}

std::string cause_of(const std::string& text) {
  try {
    parse_artefact_lesson(text, "my-lesson.json");
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("my-lesson.json"), std::string::npos) << error.what();
    return error.cause();
  }
  return "none";
}

TEST(ArtefactLesson, IsReadAsWritten) {
  const ArtefactLesson lesson = parse_artefact_lesson(one_step(), "my-lesson.json");
  ASSERT_EQ(lesson.steps.size(), 1u);
  const ArtefactLessonStep& step = lesson.steps[0];
  EXPECT_EQ(step.title, "A");
  EXPECT_EQ(step.layout, ComparisonLayout::in_place);
  EXPECT_TRUE(step.shows_db);
  EXPECT_EQ(step.db, (ComparisonOptions{24, FieldKind::sign, CaseTable::consistent, ComparisonDecimation::half}));
  EXPECT_TRUE(step.scene_over({}).wire);
  EXPECT_FALSE(step.at_artefact);
}

TEST(ArtefactLesson, BadOnesAreRefusedInWords) {
  const std::vector<std::tuple<std::string, std::string, std::string>> cases = {
      {"odontoscope.lesson", "odontoscope.links", "wrong-format"},
      {"\"version\":1", "\"version\":2", "wrong-version"},
      {"\"title\":\"T\"", "\"title\":7", "wrong-type"},
      {"\"title\":\"T\"", "\"title\":\"\"", "bad-value"},
      {"\"title\":\"T\"", "\"titel\":\"T\"", "unknown-key"},
      {"\"title\":\"T\",", "", "missing-key"},
      {"\"title\":\"T\"", "\"title\":\"T\",\"title\":\"U\"", "repeated-key"},
      {"\"words\":\"B\"", "\"words\":\"" + std::string(lesson_limits::text + 1, 'x') + "\"", "bad-value"},
      {"\"layout\":\"db\"", "\"layout\":\"upside-down\"", "bad-value"},
      {"\"grid\":24", "\"grid\":24.5", "bad-value"},
      {"\"grid\":24", "\"grid\":100000", "bad-value"},
      {"\"grid\":24", "\"grid\":-24", "bad-value"},
      {"\"grid\":24", "\"grid\":\"24\"", "wrong-type"},
      {"\"grid\":24", "\"grid\":1e999", "not-finite"},
      {"\"sign\"", "\"signs\"", "bad-value"},
      {"\"quantity\":\"cracks\"", "\"quantity\":\"beauty\"", "bad-value"},
      {",\"at_most\":0", "", "missing-key"},
      {"[{\"quantity\":\"cracks\",\"at_most\":0}]", "[]", "bad-value"},
      {"[{\"quantity\":\"cracks\",\"at_most\":0}]", "{}", "wrong-type"},
      {"\"wire\":true", "\"wire\":3", "wrong-type"},
      {"odontoscope.scene", "odontoscope.scenery", "wrong-format"},
      {"\"wire\":true", "\"x\":" + std::string(70, '[') + std::string(70, ']'), "too-deep"},
      {"}]}", "", "unparsable"}};
  for (const auto& [changed, by, cause] : cases)
    EXPECT_EQ(cause_of(one_step(changed, by)), cause) << changed << " -> " << by.substr(0, 60);
  EXPECT_EQ(cause_of(""), "unparsable");
  EXPECT_EQ(cause_of("[]"), "wrong-format");
  EXPECT_EQ(cause_of(std::string(lesson_limits::bytes + 1, ' ')), "file-too-large");
  EXPECT_EQ(cause_of(std::string(100'000, '[')), "wrong-format");
}

TEST(ArtefactLesson, EveryPrefixIsRefused) {
  const std::string text = one_step();
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_NE(cause_of(text.substr(0, length)), "none") << length;
}

TEST(ArtefactLesson, WhatTheBuiltInOneClaimsIsTrue) {
  const ArtefactLesson lesson = artefact_lesson();
  EXPECT_GE(lesson.steps.size(), 5u);
  EXPECT_LE(lesson.steps.size(), 8u);
  DbPipeline pipeline(std::make_shared<const ContourStack>(sample_tooth(ToothKind::molar)));
  for (const ArtefactLessonStep& step : lesson.steps) {
    const auto made = pipeline.run(step.db);
    for (const Claim& claim : step.claims)
      EXPECT_TRUE(holds(claim, *made)) << step.title << ": " << claim.quantity << " of "
                                       << (claim.structure.empty() ? "all" : claim.structure) << " is "
                                       << quantity_of(*made, claim.quantity, claim.structure).value_or(-1);
    EXPECT_EQ(step.at_artefact && made->artefacts.empty(), false) << step.title;
  }
}

/// The part of a surface within so many mm of its lowest point.
SurfaceMesh near_the_tip(SurfaceMesh mesh, double within) {
  double low = std::numeric_limits<double>::max();
  for (const Point3& point : mesh.points) low = std::min(low, point.z);
  std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [&](PointIndex corner) { return mesh.points[corner].z > low + within; });
  });
  return mesh;
}

TEST(ArtefactLesson, WhatItSaysOfDtIsTrue) {
  const ContourStack stack = sample_tooth(ToothKind::molar);
  DbPipeline pipeline(std::make_shared<const ContourStack>(stack));
  const auto db = pipeline.run({.grid = 64, .cases = CaseTable::consistent});
  std::size_t triangles = 0, points = 0;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) points += contour.points.size();
  DbOptions by_grid;
  by_grid.grid.columns = by_grid.grid.rows = 64;
  by_grid.cases = CaseTable::consistent;
  const DbReconstruction whole = reconstruct_by_distance(stack, by_grid);
  ASSERT_EQ(whole.surfaces.at(0).structure, "dentine");
  const SurfaceMesh& dentine_by_grid = whole.surfaces[0].surface;
  const Reconstruction dt = reconstruct_structures(stack).reconstruction;  // as the viewer shows it
  EXPECT_EQ(verdict_of(dt), Verdict::green);
  for (const Solid& solid : dt.solids) {
    EXPECT_TRUE(solid.report.closed_oriented_manifold());
    triangles += solid.report.triangles;
    if (solid.structure == "pulp") {
      EXPECT_EQ(solid.report.shells.size(), 1u);  // its canals are in one piece
    }
    if (solid.structure == "dentine") {
      EXPECT_LT(4 * ridges_mm(near_the_tip(solid.surface, 5)), ridges_mm(near_the_tip(dentine_by_grid, 5)));
    }
  }
  const double for_each_point = static_cast<double>(triangles) / static_cast<double>(points);
  EXPECT_GT(for_each_point, 4);
  EXPECT_LT(for_each_point, 5);
  const auto finer = pipeline.run({.grid = 128, .cases = CaseTable::consistent});
  const double as_many = static_cast<double>(finer->triangles()) / static_cast<double>(db->triangles());
  EXPECT_GT(as_many, 2.5);
  EXPECT_LT(as_many, 3);
}

TEST(ArtefactLesson, ClaimsCanFail) {
  DbPipeline pipeline(std::make_shared<const ContourStack>(sample_tooth(ToothKind::molar)));
  const auto made = pipeline.run({.grid = 24, .cases = CaseTable::consistent});
  EXPECT_FALSE(holds({"cracks", "", 1, {}}, *made));
  EXPECT_FALSE(holds({"triangles", "", {}, 10}, *made));
  EXPECT_FALSE(holds({"triangles", "no such structure", 0, {}}, *made));
  EXPECT_FALSE(holds({"no such quantity", "", 0, {}}, *made));
}

}  // namespace
}  // namespace odontoscope::testing_support
