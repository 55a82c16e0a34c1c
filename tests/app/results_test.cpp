// What the program makes when all is well.

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Results : public ProgramTest {};

TEST_F(Results, SampleThenReconstructThenCheckThenReport) {
  ASSERT_EQ(odontoscope({"sample", "molar", "-o", "molar.json"}).exit_code, 0);
  const Ending made = odontoscope({"reconstruct", "molar.json", "-o", "molar.glb", "-o", "molar.stl", "-o", "molar.ply",
                                   "-o", "molar.vtu", "--report", "report.json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(made.says("ertified")) << made.out;
  const auto report = nlohmann::json::parse(bytes_of("report.json"));
  EXPECT_TRUE(report.at("certified").get<bool>());
  EXPECT_EQ(report.at("surface").at("boundary_edges"), 0);
  EXPECT_EQ(report.at("surface").at("misoriented_edges"), 0);
  for (const char* mesh : {"molar.glb", "molar.stl", "molar.ply"}) {
    const Ending checked = odontoscope({"check", mesh});
    EXPECT_EQ(checked.exit_code, 0) << mesh << ": " << checked.out << checked.err;
  }
}

TEST_F(Results, BytesDoNotDependOnThreads) {
  ASSERT_EQ(odontoscope({"sample", "incisor", "-o", "tooth.json"}).exit_code, 0);
  for (const char* threads : {"1", "2", "5"}) {
    const std::string name = std::string("with") + threads;
    ASSERT_EQ(odontoscope({"--threads", threads, "reconstruct", "tooth.json", "--triangles", "4000", "-o", name + ".glb",
                           "-o", name + ".stl", "-o", name + ".ply", "-o", name + ".vtu"}).exit_code, 0);
    for (const char* ending : {".glb", ".stl", ".ply", ".vtu"}) {
      EXPECT_GT(bytes_of(name + ending).size(), 1000u);
      EXPECT_TRUE(bytes_of(name + ending) == bytes_of(std::string("with1") + ending)) << name << ending;
    }
  }
}

TEST_F(Results, SampleIsTheSameEachTime) {
  ASSERT_EQ(odontoscope({"sample", "premolar", "-o", "a.json"}).exit_code, 0);
  ASSERT_EQ(odontoscope({"sample", "premolar", "-o", "b.json", "--threads", "1"}).exit_code, 0);
  EXPECT_TRUE(bytes_of("a.json") == bytes_of("b.json"));
}

TEST_F(Results, QuietSaysNothing) {
  given("cube.json", cube_stack());
  const Ending quiet = odontoscope({"reconstruct", "cube.json", "-o", "cube.stl", "--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(quiet.err, "");
  EXPECT_TRUE(exists("cube.stl"));
}

TEST_F(Results, LogHoldsNoTerminalCodes) {
  given("cube.json", cube_stack());
  const Ending logged = odontoscope({"reconstruct", "cube.json", "-o", "cube.stl"});
  EXPECT_EQ(logged.exit_code, 0);
  EXPECT_EQ(logged.err.find('\r'), std::string::npos);
  EXPECT_EQ(logged.err.find('\033'), std::string::npos);
}

TEST_F(Results, CheckOfASoundStack) {
  given("cube.json", cube_stack());
  const Ending checked = odontoscope({"check", "cube.json"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_TRUE(checked.says("2 slices")) << checked.out;
}

TEST_F(Results, CheckFindsAnOpenMeshWanting) {
  given("open.stl",
        "solid open\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n"
        "  endloop\n endfacet\nendsolid open\n");
  const Ending checked = odontoscope({"check", "open.stl"});
  EXPECT_EQ(checked.exit_code, 1) << checked.out << checked.err;
  EXPECT_TRUE(checked.says("3 boundary edges")) << checked.out;
  EXPECT_EQ(odontoscope({"check", "open.stl", "--quiet"}).exit_code, 1);
}

TEST_F(Results, CheckGoesByContentNotByName) {
  given("cube.stl", cube_stack());
  const Ending checked = odontoscope({"check", "cube.stl"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_TRUE(checked.says("2 slices")) << checked.out;
}

TEST_F(Results, LinksOfTheReportCanBeGivenBack) {
  given("cube.json", cube_stack());
  ASSERT_EQ(odontoscope({"reconstruct", "cube.json", "-o", "a.stl", "--report", "report.json"}).exit_code, 0);
  const auto made = nlohmann::json::parse(bytes_of("report.json")).at("links");
  ASSERT_EQ(made.size(), 1u);
  nlohmann::json links{{"format", "odontoscope.links"}, {"version", 1}, {"links", made}};
  given("same.json", links.dump());
  EXPECT_EQ(odontoscope({"reconstruct", "cube.json", "--links", "same.json", "-o", "b.stl"}).exit_code, 0);
  EXPECT_TRUE(bytes_of("a.stl") == bytes_of("b.stl"));
  links.at("links").at(0).at("connect") = false;
  given("apart.json", links.dump());
  EXPECT_EQ(odontoscope({"reconstruct", "cube.json", "--links", "apart.json", "-o", "c.stl"}).exit_code, 0);
  EXPECT_FALSE(bytes_of("a.stl") == bytes_of("c.stl"));
}

}  // namespace
}  // namespace odontoscope::testing_support
