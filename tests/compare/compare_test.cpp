// The comparison, and what is written of it.

#include "recon/compare/compare.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <stop_token>

#include "recon/compare/peak_memory.h"
#include "recon/core/error.h"
#include "recon/output/comparison_json.h"
#include "recon/output/comparison_page.h"
#include "tests/distance/shapes.h"

namespace odontoscope::test {
namespace {

CompareOptions coarse() {
  CompareOptions options;
  options.db.grid.columns = options.db.grid.rows = 40;
  options.distance.samples = 5'000;
  return options;
}

TEST(Compare, JudgesWhatTheEnginesMake) {
  const ContourStack stack = corners_under_a_block();
  const Comparison comparison = compare(stack, coarse());
  ASSERT_EQ(comparison.methods.size(), 3u);
  const ComparedMethod &dt = comparison.methods[0], &db = comparison.methods[1], &fewer = comparison.methods[2];
  EXPECT_EQ(dt.report.triangles, reconstruct(stack).solids.at(0).surface.triangles.size());
  EXPECT_TRUE(dt.certified);
  EXPECT_TRUE(dt.report.closed_oriented_manifold());
  EXPECT_EQ(db.report.triangles, reconstruct_by_distance(stack, coarse().db).surfaces.at(0).surface.triangles.size());
  EXPECT_FALSE(db.certified);
  EXPECT_GT(db.report.boundary_edges, 0u);
  EXPECT_LT(fewer.report.triangles, db.report.triangles);
  EXPECT_LT(dt.fit.contours_to_surface.largest, 1e-12);
  EXPECT_GT(db.fit.contours_to_surface.mean, 1e-4);
  for (const ComparedMethod& method : comparison.methods) EXPECT_GT(method.seconds, 0);
  EXPECT_EQ(comparison.pairs.size(), 3u);
  EXPECT_GT(comparison.pairs[0].distance.mean(), 0);
  // The extra layers of DB reach beyond DT's flat ends, so the way back is the longer one.
  EXPECT_GT(comparison.pairs[0].distance.b_to_a.largest, 0.1);
}

TEST(Compare, CountsStructuresWhoseTopologyIsImplied) {
  // A canal finer than the grid: DT has it, DB does not.
  const ContourStack canal = stack_of({{circle(3), circle(0.1)}, {circle(3), circle(0.1)}, {circle(3), circle(0.1)}});
  CompareOptions options = coarse();
  options.db.grid.columns = options.db.grid.rows = 12;
  options.db.cases = CaseTable::consistent;
  const Comparison comparison = compare(canal, options);
  EXPECT_EQ(comparison.methods[0].topology.as_implied, 1u);
  EXPECT_EQ(comparison.methods[0].verdict.substr(0, 5), "Green");
  EXPECT_EQ(comparison.methods[1].topology.known, 1u);
  EXPECT_EQ(comparison.methods[1].topology.as_implied, 0u);
  EXPECT_TRUE(comparison.methods[1].report.closed_oriented_manifold());
  options.db.grid.columns = options.db.grid.rows = 120;
  EXPECT_EQ(compare(canal, options).methods[1].topology.as_implied, 1u);
}

TEST(Compare, HasARowOfEachMeasureForEachMethod) {
  const Comparison comparison = compare(corners_under_a_block(), coarse());
  const std::vector<ComparisonRow> rows = comparison_rows(comparison);
  EXPECT_GE(rows.size(), 20u);
  for (const ComparisonRow& row : rows) EXPECT_EQ(row.values.size(), 3u) << row.what;
  EXPECT_EQ(rows[1].values, (std::vector<std::string>{
                                "yes", "no", comparison.methods[2].report.closed_oriented_manifold() ? "yes" : "no"}));
}

/// The report less what differs between runs.
nlohmann::json steady(const Comparison& comparison) {
  auto json = nlohmann::json::parse(comparison_json(comparison));
  json.erase("threads");
  for (auto& method : json["methods"]) {
    method.erase("seconds");
    method.erase("peak_memory_bytes");
  }
  return json;
}

TEST(Compare, DoesNotDependOnThreads) {
  CompareOptions options = coarse();
  options.dt.threads = 1;
  const auto one = steady(compare(corners_under_a_block(), options));
  options.dt.threads = 4;
  EXPECT_EQ(one, steady(compare(corners_under_a_block(), options)));
  EXPECT_EQ(one.at("methods").at(1).at("surface").at("boundary_edges").get<int>() > 0, true);
}

TEST(Compare, RefusesBadStacksAndStops) {
  EXPECT_THROW(compare(stack_of({{circle(2), circle(2, {1, 0})}, {circle(2)}}), {}), InputError);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(compare(corners_under_a_block(), coarse(), {{}, stop.get_token()}), Cancelled);
}

TEST(ComparisonPage, StandsAloneAndHoldsThePicturesThatItIsGiven) {
  Comparison comparison = compare(corners_under_a_block(), coarse());
  comparison.source = "<script>&\"";
  EXPECT_EQ(comparison_page(comparison).find("<img"), std::string::npos);
  comparison.methods[0].pictures.push_back({{'M', 'a', 'n'}, "from the side"});
  comparison.methods[1].pictures.push_back({{'M', 'a'}, "a < b"});
  comparison.methods[2].pictures.push_back({{'M'}, "c"});
  const std::string page = comparison_page(comparison);
  for (const char* held : {"data:image/png;base64,TWFu\"", "base64,TWE=\"", "base64,TQ==\"", "from the side",
                           "a &lt; b", "&lt;script&gt;&amp;&quot;", "boundary edges", "<svg"}) {
    EXPECT_NE(page.find(held), std::string::npos) << held;
  }
  EXPECT_EQ(page.find("<script>"), std::string::npos);
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"(http|/|\\.)"))) << "something outside the page";
}

TEST(PeakMemory, SeesWhatWasTouched) {
  constexpr std::size_t bytes = 64u << 20;
  const auto peak = peak_memory_of([] { std::vector<char>(bytes, 1).swap(*std::make_unique<std::vector<char>>()); });
  if (!peak) GTEST_SKIP() << "this system does not tell";
  EXPECT_GE(*peak, bytes * 9 / 10);
  EXPECT_LE(*peak, bytes * 2);
}

}  // namespace
}  // namespace odontoscope::test
