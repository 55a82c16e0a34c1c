// --elements: what the program says, writes and refuses.

#include <nlohmann/json.hpp>

#include "recon/elements/fill.h"
#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class ElementsCommand : public ProgramTest {
 protected:
  void SetUp() override { given("cube.json", cube_stack()); }
};

TEST_F(ElementsCommand, WritesAndReportsThem) {
  if (!elements::can_fill()) GTEST_SKIP() << "built without TetGen (libtet1.5-dev)";
  const Ending made = odontoscope({"reconstruct", "cube.json", "--elements", "0.25", "-o", "cube.msh", "-o", "cube.inp",
                                   "-o", "cube.stl", "--report", "report.json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(made.says("elements of about 0.25 mm")) << made.out;
  EXPECT_TRUE(made.says("before it was meshed anew")) << made.out;
  const auto report = nlohmann::json::parse(bytes_of("report.json"));
  const auto& elements = report.at("elements");
  EXPECT_EQ(elements.at("size"), 0.25);
  EXPECT_EQ(elements.at("asked"), 0.25);
  const auto& one = elements.at("structures").at(0);
  EXPECT_GT(one.at("count"), 100);
  EXPECT_EQ(one.at("count"), report.at("tetrahedra").at("kept"));
  EXPECT_NEAR(one.at("exact_volume").get<double>(), 1, 1e-9);
  EXPECT_NEAR(one.at("volume").get<double>(), 1, 0.01);
  EXPECT_LT(one.at("elements_to_exact").at("largest"), 0.05);
  EXPECT_GT(report.at("tetrahedra").at("dihedral_min_deg"), 5);
  EXPECT_TRUE(report.at("certified").get<bool>());
  EXPECT_EQ(odontoscope({"check", "cube.stl"}).exit_code, 0);
  EXPECT_NE(bytes_of("cube.inp").find("_LOWEST"), std::string::npos);
}

TEST_F(ElementsCommand, QualityChoosesASize) {
  if (!elements::can_fill()) GTEST_SKIP() << "built without TetGen (libtet1.5-dev)";
  const Ending made = odontoscope({"reconstruct", "cube.json", "--elements", "quality", "-o", "cube.vtu"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(made.says("elements of about 0.1")) << made.out;
}

TEST_F(ElementsCommand, WhatMakesNoSenseIsRefusedBeforeAnyWork) {
  for (const char* size : {"0", "-1", "nan", "inf", "small", "1mm", "0.001", "1e9", ""}) {
    const Ending refused = odontoscope({"reconstruct", "cube.json", "--elements", size, "-o", "cube.msh"});
    EXPECT_EQ(refused.exit_code, 2) << size;
    EXPECT_FALSE(exists("cube.msh")) << size;
  }
  EXPECT_EQ(
      odontoscope({"reconstruct", "cube.json", "--elements", "0.2", "--triangles", "100", "-o", "cube.msh"}).exit_code,
      2);
  EXPECT_EQ(
      odontoscope({"reconstruct", "cube.json", "--elements", "0.2", "--method", "db", "-o", "cube.stl"}).exit_code, 2);
}

}  // namespace
}  // namespace odontoscope::testing_support
