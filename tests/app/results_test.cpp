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
    ASSERT_EQ(odontoscope({"--threads", threads, "reconstruct", "tooth.json", "--triangles", "4000", "-o",
                           name + ".glb", "-o", name + ".stl", "-o", name + ".ply", "-o", name + ".vtu"})
                  .exit_code,
              0);
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

/// Square pillars of five slices each, the upper ones beside the lower one.
std::string pillars(const std::vector<double>& upper_left) {
  std::string slices;
  for (int k = 0; k < 10; ++k) {
    std::string contours;
    for (const double left : k < 5 ? std::vector{0.0} : upper_left) {
      const double right = left + 1;
      contours += (contours.empty() ? "" : ",") +
                  ("{\"structure\":\"root canal\",\"points\":[[" + std::to_string(left) + ",0],[" +
                   std::to_string(right) + ",0],[" + std::to_string(right) + ",1],[" + std::to_string(left) + ",1]]}");
    }
    slices += (k > 0 ? "," : "") + ("{\"z\":" + std::to_string(k) + ",\"contours\":[" + contours + "]}");
  }
  return "{\"format\":\"odontoscope.contours\",\"version\":1,\"unit\":\"mm\",\"slices\":[" + slices + "]}";
}

std::vector<std::string> options_in(const std::string& words, const std::string& option) {
  std::vector<std::string> values;
  for (std::size_t at = words.find(option + " '"); at != words.npos; at = words.find(option + " '", at + 1)) {
    const std::size_t begin = at + option.size() + 2;
    values.push_back(words.substr(begin, words.find('\'', begin) - begin));
  }
  return values;
}

TEST_F(Results, AnAmberVerdictWarnsAndItsOwnOptionEndsThat) {
  given("canal.json", pillars({1.5, -1.5}));
  const Ending amber = odontoscope(
      {"reconstruct", "canal.json", "--correspondence", "medial", "-o", "amber.ply", "--report", "amber.json"});
  EXPECT_EQ(amber.exit_code, 0) << amber.err;
  EXPECT_TRUE(amber.says("Amber: certified, but look at 1 place.")) << amber.out;
  EXPECT_TRUE(amber.complains("warning: root canal, slices 4 and 5 (z 4 to 5 mm)")) << amber.err;
  EXPECT_TRUE(exists("amber.ply"));
  EXPECT_EQ(nlohmann::json::parse(bytes_of("amber.json")).at("verdict"), "amber");
  const std::vector<std::string> links = options_in(amber.err, "--link");
  ASSERT_EQ(links.size(), 2u) << amber.err;
  for (const std::string& link : links) {
    const Ending green = odontoscope({"reconstruct", "canal.json", "--correspondence", "medial", "-o", "green.ply",
                                      "--link", link, "--report", "green.json", "--strict"});
    EXPECT_EQ(green.exit_code, 0) << green.err;
    EXPECT_FALSE(green.complains("warning")) << green.err;
    EXPECT_TRUE(green.says("Green: ")) << green.out;
    EXPECT_EQ(nlohmann::json::parse(bytes_of("green.json")).at("verdict"), "green");
  }
}

TEST_F(Results, StrictWritesNoAmberModel) {
  given("canal.json", pillars({1.5}));
  const Ending strict =
      odontoscope({"reconstruct", "canal.json", "--correspondence", "medial", "-o", "canal.ply", "--strict"});
  EXPECT_EQ(strict.exit_code, 1) << strict.err;
  EXPECT_TRUE(strict.complains("warning: root canal")) << strict.err;
  EXPECT_TRUE(strict.complains("Nothing was written")) << strict.err;
  EXPECT_FALSE(exists("canal.ply"));
  const std::vector<std::string> apart = options_in(strict.err, "--unlink");
  ASSERT_EQ(apart.size(), 1u) << strict.err;
  EXPECT_EQ(odontoscope({"reconstruct", "canal.json", "--correspondence", "medial", "-o", "canal.ply", "--strict",
                         "--unlink", apart.front()})
                .exit_code,
            0);
  EXPECT_TRUE(exists("canal.ply"));
}

TEST_F(Results, OnlyTheFirstPlacesAreToldOnTheTerminal) {
  std::string many;  // specks, each in one slice, beside a pillar
  for (int k = 0; k < 12; ++k) {
    const std::string x = std::to_string(3 + 4 * (k % 5));
    const std::string speck = k % 2 == 0 ? "" : ",{\"points\":[[" + x + ",9],[" + x + ".5,9],[" + x + ".5,9.5]]}";
    many +=
        (k > 0 ? "," : "") + ("{\"z\":" + std::to_string(k) + ",\"contours\":[{\"points\":[[0,0],[1,0],[1,1],[0,1]]}" +
                              speck + ",{\"points\":[[" + x + ",-9],[" + x + ".5,-9],[" + x + ".5,-8.5]]}]}");
  }
  given("specks.json", "{\"format\":\"odontoscope.contours\",\"version\":1,\"unit\":\"mm\",\"slices\":[" + many + "]}");
  const Ending ending = odontoscope({"reconstruct", "specks.json", "--correspondence", "medial", "-o", "specks.ply",
                                     "--report", "specks-report.json"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  std::size_t warnings = 0;
  for (std::size_t at = ending.err.find("warning: "); at != std::string::npos;
       at = ending.err.find("warning: ", at + 1))
    ++warnings;
  EXPECT_EQ(warnings, 8u) << ending.err;
  EXPECT_TRUE(ending.complains("and 10 more in the report")) << ending.err;
  EXPECT_EQ(nlohmann::json::parse(bytes_of("specks-report.json")).at("attention").size(), 18u);
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
