// The DB method as a user meets it: broken models are written, and said to be broken.

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class DbMethod : public ProgramTest {
 protected:
  /// Two squares nearly touching with a corner each, under and over a block: cracks with the classic tables.
  void SetUp() override {
    const std::string squares =
        R"([{"points":[[0,0],[4,0],[4,4],[0,4]]},{"points":[[4.05,4.05],[8,4.05],[8,8],[4.05,8]]}])";
    const std::string block = R"([{"points":[[0,0],[8,0],[8,8],[0,8]]}])";
    given("corners.json", R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[{"z":0,"contours":)" +
                              squares + R"(},{"z":1,"contours":)" + block + R"(},{"z":2,"contours":)" + squares +
                              "}]}");
  }
  nlohmann::json report(const std::string& name) const { return nlohmann::json::parse(bytes_of(name)); }
};

TEST_F(DbMethod, WritesCrackedModelsAndSaysSo) {
  const Ending made = odontoscope({"reconstruct", "corners.json", "--method", "db", "--grid", "24", "-o", "a.glb", "-o",
                                   "a.stl", "-o", "a.ply", "--report", "a.json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(made.says("not certified")) << made.out;
  EXPECT_TRUE(made.says("boundary edges")) << made.out;
  const auto said = report("a.json");
  EXPECT_EQ(said.at("method"), "db");
  EXPECT_FALSE(said.at("certified").get<bool>());
  EXPECT_FALSE(said.at("resampling").at("exact").get<bool>());
  EXPECT_GT(said.at("surface").at("boundary_edges"), 0);
  // What any judge finds in the files is what the report says.
  for (const char* file : {"a.glb", "a.stl", "a.ply"}) {
    EXPECT_EQ(odontoscope({"check", file, "--report", "found.json"}).exit_code, 1) << file;
    const auto found = report("found.json").at("surface");
    for (const char* key : {"triangles", "boundary_edges", "nonmanifold_edges", "misoriented_edges"}) {
      EXPECT_EQ(found.at(key), said.at("surface").at(key)) << file << " " << key;
    }
  }
}

TEST_F(DbMethod, ConsistentTableGivesASoundModel) {
  ASSERT_EQ(odontoscope({"reconstruct", "corners.json", "--method", "db", "--grid", "24x30", "--cases", "consistent",
                         "-o", "a.glb", "--report", "a.json"})
                .exit_code,
            0);
  EXPECT_TRUE(report("a.json").at("certified").get<bool>());
  EXPECT_EQ(report("a.json").at("db").at("grid").at("rows"), 30);
  EXPECT_EQ(odontoscope({"check", "a.glb"}).exit_code, 0);
}

TEST_F(DbMethod, DecimatesAndTellsFromWhat) {
  ASSERT_EQ(odontoscope({"reconstruct", "corners.json", "--method", "db", "--grid", "40", "--decimate", "300", "-o",
                         "a.stl", "--report", "a.json"})
                .exit_code,
            0);
  const auto said = report("a.json");
  EXPECT_LE(said.at("surface").at("triangles"), 300);
  EXPECT_GT(said.at("db").at("decimation").at("structures").at(0).at("before").at("triangles"), 3000);
}

TEST_F(DbMethod, ASplitPartsWhatItIsPutBetween) {
  ASSERT_EQ(odontoscope({"reconstruct", "corners.json", "--method", "db", "--grid", "24", "--cases", "consistent",
                         "--split", "0.5", "--split", "1.5", "-o", "a.stl", "--report", "a.json"})
                .exit_code,
            0);
  EXPECT_EQ(report("a.json").at("surface").at("shells").size(), 5u);  // two squares, the block, two squares
}

TEST_F(DbMethod, AGridThatIsTooLargeIsRefusedBeforeMemoryIsTaken) {
  given("old.glb", "old");
  const Ending refused = odontoscope(
      {"reconstruct", "corners.json", "--method", "db", "--grid", "8192", "-o", "old.glb", "--split", "0.1"});
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_TRUE(refused.complains("At most")) << refused.err;
  EXPECT_EQ(bytes_of("old.glb"), "old");
}

TEST_F(DbMethod, CompareShowsTheMethodsSideBySide) {
  const Ending compared =
      odontoscope({"compare", "corners.json", "--grid", "40", "--report", "c.json", "--html", "c.html"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  for (const char* said :
       {"DT", "DB decimated", "boundary edges", "thinnest hole", "contours to surface", "seconds", "Wrote c.html"}) {
    EXPECT_TRUE(compared.says(said)) << said;
  }
  EXPECT_EQ(report("c.json").at("methods").size(), 3u);
  EXPECT_EQ(bytes_of("c.html").substr(0, 15), "<!DOCTYPE html>");
  // Either everything that needs drawing or a line that says why not.
  const bool drawn = bytes_of("c.html").find("data:image/png") != std::string::npos;
  EXPECT_NE(drawn, compared.says("No pictures"));
  EXPECT_EQ(drawn, compared.says("seen through"));
  EXPECT_EQ(drawn, report("c.json").at("methods").at(0).contains("seen_through"));
  if (drawn) {
    EXPECT_EQ(report("c.json").at("methods").at(0).at("seen_through").at("culled"), 0);
  }
}

TEST_F(DbMethod, CompareRefusesOtherEndingsAndItsInputAsOutput) {
  const std::vector<std::string> before = folder.names();
  EXPECT_EQ(odontoscope({"compare", "corners.json", "--html", "c.htm"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"compare", "corners.json", "--report", "corners.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"compare", "corners.json", "--report", "missing/c.json"}).exit_code, 4);
  EXPECT_EQ(odontoscope({"compare", "scan.nrrd"}).exit_code, 2);
  EXPECT_EQ(folder.names(), before);
}

TEST_F(DbMethod, CanalPlotsSurvivalOverTheGrid) {
  const Ending canal =
      odontoscope({"canal", "--grid", "24", "--grid", "72", "-o", "canal.svg", "--report", "canal.json"});
  ASSERT_EQ(canal.exit_code, 0) << canal.err;
  EXPECT_TRUE(canal.says("DT:          open")) << canal.out;
  EXPECT_TRUE(canal.says("DB grid   24: closed")) << canal.out;
  EXPECT_TRUE(canal.says("DB grid   72: open")) << canal.out;
  EXPECT_EQ(bytes_of("canal.svg").substr(0, 4), "<svg");
  EXPECT_EQ(report("canal.json").at("db").size(), 2u);
  EXPECT_EQ(odontoscope({"canal", "--width", "0", "-o", "other.svg"}).exit_code, 2);
  EXPECT_FALSE(exists("other.svg"));
}

TEST_F(DbMethod, BytesDoNotDependOnThreads) {
  for (const char* threads : {"1", "4"}) {
    ASSERT_EQ(odontoscope({"--threads", threads, "reconstruct", "corners.json", "--method", "db", "--decimate", "max",
                           "-o", std::string("with") + threads + ".glb"})
                  .exit_code,
              0);
  }
  EXPECT_GT(bytes_of("with1.glb").size(), 1000u);
  EXPECT_TRUE(bytes_of("with1.glb") == bytes_of("with4.glb"));
}

}  // namespace
}  // namespace odontoscope::testing_support
