// Many inputs, one report: what fails stops nothing, and the same call again does only what is left.

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Batch : public ProgramTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder / "teeth/below");
    given("teeth/cube.json", cube_stack());
    given("teeth/two words.json", cube_stack("[[0,0],[2,0],[2,2],[0,2]]"));
    given("teeth/flat.json", cube_stack("[[0,0],[1,0],[2,0]]"));
    given("list.txt",
          "# teeth\n\nteeth/cube.json --between delaunay\r\n  \"teeth/two "
          "words.json\"\nteeth/flat.json\nteeth/missing.json\n");
  }
  nlohmann::json report(const std::string& name = "out/batch.json") { return nlohmann::json::parse(bytes_of(name)); }
  std::filesystem::file_time_type written(const std::string& name) {
    return std::filesystem::last_write_time(folder / name);
  }
};

TEST_F(Batch, OfAListGoesOnAfterFailures) {
  const Ending ending =
      odontoscope({"batch", "list.txt", "-o", "out", "--format", ".stl", "--format", "vtu", "--jobs", "2"});
  EXPECT_EQ(ending.exit_code, 1) << ending.err;
  EXPECT_TRUE(ending.says("4 inputs: 2 made, 2 failed")) << ending.out;
  EXPECT_TRUE(ending.complains("teeth/flat.json: ")) << ending.err;
  for (const char* file : {"out/cube.stl", "out/cube.vtu", "out/cube.report.json", "out/two words.stl"})
    EXPECT_TRUE(exists(file)) << file;
  EXPECT_FALSE(exists("out/flat.stl"));
  const auto told = report();
  EXPECT_EQ(told["counts"], (nlohmann::json{{"inputs", 4}, {"made", 2}, {"kept", 0}, {"amber", 0}, {"failed", 2}}));
  EXPECT_EQ(told["items"][0]["words"], (nlohmann::json{"--between", "delaunay"}));
  EXPECT_EQ(told["items"][1]["name"], "two words");
  EXPECT_EQ(told["items"][1]["verdict"], "green");
  EXPECT_TRUE(told["items"][1]["certified"]);
  EXPECT_GT(told["items"][1]["triangles"], 8);
  EXPECT_GT(told["items"][1]["tetrahedra"], 4);
  EXPECT_EQ(told["items"][2]["exit"], 3);
  EXPECT_EQ(told["items"][2]["cause"], "zero-area");
  EXPECT_EQ(told["items"][3]["exit"], 4);
  EXPECT_NE(told["items"][3]["message"].get<std::string>().find("teeth/missing.json: cannot be read"),
            std::string::npos)
      << told["items"][3];
}

TEST_F(Batch, AgainKeepsWhatIsDoneAndTriesTheRest) {
  EXPECT_EQ(odontoscope({"batch", "list.txt", "-o", "out"}).exit_code, 1);
  const auto then = written("out/cube.glb"), other = written("out/two words.glb");
  given("teeth/flat.json", cube_stack());
  given("teeth/missing.json", cube_stack());
  Ending ending = odontoscope({"batch", "list.txt", "-o", "out"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(ending.says("4 inputs: 4 made (2 before), 0 failed")) << ending.out;
  EXPECT_EQ(written("out/cube.glb"), then);
  EXPECT_TRUE(report()["items"][0]["kept"]);
  EXPECT_FALSE(report()["items"][2]["kept"]);

  given("teeth/cube.json", cube_stack("[[0,0],[3,0],[3,3],[0,3]]"));  // another input
  std::filesystem::remove(folder / "out/flat.glb");                   // an output that went
  given("out/missing.batch.json",
        "{\"format\":\"odontoscope.batch-item\",\"version\":1,\"input\":3}");  // a record that is none
  ending = odontoscope({"batch", "list.txt", "-o", "out"});
  EXPECT_TRUE(ending.says("4 made (1 before)")) << ending.out;
  EXPECT_NE(written("out/cube.glb"), then);
  EXPECT_EQ(written("out/two words.glb"), other);
  EXPECT_TRUE(odontoscope({"batch", "list.txt", "-o", "out", "--with", "--triangles 8"}).says("4 made, "))
      << "other words";
  EXPECT_TRUE(odontoscope({"batch", "list.txt", "-o", "out", "--with", "--triangles 8", "--anew"}).says("4 made, "));
}

TEST_F(Batch, InPartsComesToTheSameAsInOne) {
  for (const char* part : {"1/3", "2/3", "3/3"}) odontoscope({"batch", "list.txt", "-o", "out", "--part", part});
  EXPECT_EQ(report("out/batch-1-of-3.json")["counts"]["inputs"], 2);
  EXPECT_EQ(report("out/batch-3-of-3.json")["counts"]["inputs"], 1);
  const Ending ending = odontoscope({"batch", "list.txt", "-o", "out"});
  EXPECT_TRUE(ending.says("4 inputs: 2 made (2 before), 2 failed")) << ending.out;
}

TEST_F(Batch, OfPatternsAndFilesOfOneName) {
  given("teeth/below/cube.json", cube_stack());
  const Ending ending = odontoscope({"batch", "teeth/c*.json", "teeth/below/*.json", "-o", "out"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_TRUE(exists("out/teeth-cube.glb"));
  EXPECT_TRUE(exists("out/below-cube.glb"));
}

TEST_F(Batch, WithAHangGoesOn) {
  const Ending ending = odontoscope({"batch", "teeth/cube.json", "-o", "out", "--timeout", "0"});
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_EQ(report()["items"][0]["ending"], "hang");
  EXPECT_EQ(odontoscope({"batch", "teeth/cube.json", "-o", "out"}).exit_code, 0);
}

TEST_F(Batch, WithStrictTellsThatNothingWasWritten) {
  EXPECT_EQ(odontoscope({"batch", "teeth/cube.json", "-o", "out"}).exit_code, 0);
  const Ending ending = odontoscope({"batch", "teeth/cube.json", "-o", "out", "--with", "--strict --triangles 2"});
  EXPECT_EQ(ending.exit_code, 1) << ending.out;
  EXPECT_EQ(report()["items"][0]["exit"], 1);
  EXPECT_FALSE(report()["items"][0]["made"]);
  EXPECT_EQ(report()["counts"]["failed"], 1);
  EXPECT_NE(report()["items"][0]["message"].get<std::string>().find("Nothing was written"), std::string::npos)
      << report();
  EXPECT_EQ(odontoscope({"batch", "teeth/cube.json", "-o", "out", "--with", "--triangles 2"}).exit_code, 0)
      << "missed, but written";
}

TEST_F(Batch, ThatMakesNoSenseIsRefusedBeforeAnyWork) {
  given("quote.txt", "teeth/cube.json --between 'delaunay\n");
  given("output.txt", "teeth/cube.json -o x.glb\n");
  given("zero.txt", std::string("teeth/cube.json\0x\n", 17));
  given("empty.txt", "# nothing\n");
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"none*.json"},
                                             {"teeth/cube.json", "teeth/cube.json"},
                                             {"quote.txt"},
                                             {"zero.txt"},
                                             {"output.txt"},
                                             {"empty.txt"},
                                             {"list.txt", "--part", "4/3"},
                                             {"list.txt", "--part", "x"},
                                             {"list.txt", "--format", ".docx"},
                                             {"list.txt", "--with", "--report x.json"},
                                             {"list.txt", "--jobs", "0"}}) {
    std::vector<std::string> call{"batch", "-o", "out"};
    call.insert(call.end(), words.begin(), words.end());
    EXPECT_EQ(odontoscope(call).exit_code, 2) << words.front() << " " << words.back();
  }
  EXPECT_FALSE(exists("out"));
  EXPECT_EQ(odontoscope({"batch", "missing.txt", "-o", "out"}).exit_code, 4);
  EXPECT_EQ(odontoscope({"batch", "teeth/cube.json", "-o", "list.txt"}).exit_code, 4);
}

TEST_F(Batch, StoppedGoesOnFromThere) {
  for (int n = 0; n < 200; ++n) given("teeth/many" + std::to_string(n) + ".json", cube_stack());
  const Ending ending = run({.arguments = {"batch", "teeth/many*.json", "-o", "out", "--jobs", "1"},
                             .folder = folder.path().string(),
                             .signals = {SIGINT},
                             .pause = std::chrono::milliseconds(50)});
  EXPECT_EQ(ending.exit_code, 130) << ending.out << ending.err;
  EXPECT_TRUE(ending.complains("of 200 inputs. The same call goes on from there.")) << ending.err;
  EXPECT_FALSE(exists("out/batch.json"));
  const Ending again = odontoscope({"batch", "teeth/many?.json", "-o", "out"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(again.says(" before)")) << again.out;
}

}  // namespace
}  // namespace odontoscope::testing_support
