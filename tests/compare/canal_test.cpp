// A thin canal: DT keeps it at any width, DB needs a grid that is fine enough.

#include "recon/compare/canal.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "recon/core/error.h"
#include "recon/input/validate.h"
#include "recon/output/canal_plot.h"
#include "recon/output/comparison_json.h"

namespace odontoscope {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Canal, IsOpenInDtAtEveryWidth) {
  for (const double width : {0.05, 0.1, 0.25, 0.7, 2.0}) {
    SCOPED_TRACE(width);
    EXPECT_NO_THROW(validate(tooth_with_canal({width})));
    const CanalExperiment experiment = canal_experiment({.tooth = {width}, .grids = {8}});
    EXPECT_TRUE(experiment.dt.open_through);
    EXPECT_EQ(experiment.dt.open_slices, experiment.slices);
    EXPECT_FALSE(experiment.db.at(0).open_through);
  }
}

TEST(Canal, NeedsAGridPointInEverySectionOfIt) {
  const CanalExperiment experiment = canal_experiment({.grids = {16, 32, 48, 64, 96, 128}});
  // Half a diagonal of a cell is at most the canal's radius from 59 points on: each section then holds a grid point.
  for (const CanalResult& result : experiment.db) {
    SCOPED_TRACE(result.grid);
    EXPECT_EQ(result.open_through, result.grid >= 59);
    EXPECT_EQ(result.open_slices == experiment.slices, result.grid >= 59);
  }
  EXPECT_LT(experiment.db[0].open_slices, experiment.db[2].open_slices);
}

TEST(Canal, AWiderOneSurvivesOnCoarserGrids) {
  EXPECT_TRUE(canal_experiment({.tooth = {0.6}, .grids = {32}}).db.at(0).open_through);
  EXPECT_FALSE(canal_experiment({.tooth = {0.25}, .grids = {32}}).db.at(0).open_through);
}

TEST(Canal, RefusesWidthsThatMakeNoSense) {
  for (const double width : {0.0, -1.0, 3.0, std::nan("")}) EXPECT_THROW(tooth_with_canal({width}), UsageError);
}

TEST(Canal, PlotAndNumbersShowEveryGrid) {
  const CanalExperiment experiment = canal_experiment({.grids = {20, 40, 70}});
  const std::string plot = canal_plot(experiment);
  EXPECT_EQ(count(plot, "<title>grid "), 3u);
  EXPECT_EQ(count(plot, "<svg"), count(plot, "</svg>"));
  EXPECT_NE(plot.find("DT: open all the way"), std::string::npos);
  const auto numbers = nlohmann::json::parse(canal_json(experiment));
  EXPECT_EQ(numbers.at("db").size(), 3u);
  EXPECT_EQ(numbers.at("db").at(2).at("grid"), 70);
  EXPECT_EQ(numbers.at("db").at(2).at("open_through"), true);
  EXPECT_EQ(numbers.at("dt").at("genus"), 1);
}

}  // namespace
}  // namespace odontoscope
