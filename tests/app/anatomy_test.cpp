// Anatomy and films as a user meets them.

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class AnatomyCommand : public ProgramTest {
 protected:
  void SetUp() override {
    given("block.json", R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[
      {"z":0,"contours":[{"points":[[0,0],[8,0],[8,8],[0,8]]}]},{"z":2,"contours":[{"points":[[0,0],[8,0],[8,8],[0,8]]}]}]})");
  }
};

TEST_F(AnatomyCommand, TellsTheSamplePremolarsCanalsByName) {
  ASSERT_EQ(odontoscope({"sample", "premolar", "-o", "p.json"}).exit_code, 0);
  const Ending told = odontoscope({"anatomy", "p.json", "-o", "a.json", "-o", "a.csv"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(told.says("buccal canal")) << told.out;
  EXPECT_TRUE(told.says("Vertucci I")) << told.out;
  const auto made = nlohmann::json::parse(bytes_of("a.json"));
  EXPECT_EQ(made.at("format"), "odontoscope.anatomy");
  EXPECT_EQ(made.at("source"), "p.json");
  ASSERT_EQ(made.at("canals").size(), 2u);
  EXPECT_EQ(made.at("roots").size(), 2u);
  EXPECT_GT(made.at("canals")[0].at("length"), 10);
  const std::string csv = bytes_of("a.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  // The same from the mesh of it.
  ASSERT_EQ(odontoscope({"reconstruct", "p.json", "-o", "p.glb"}).exit_code, 0);
  EXPECT_TRUE(odontoscope({"anatomy", "p.glb"}).says("lingual canal"));
  // And on one thread the same bytes.
  ASSERT_EQ(odontoscope({"anatomy", "p.json", "--threads", "1", "-o", "b.json"}).exit_code, 0);
  EXPECT_EQ(bytes_of("b.json"), bytes_of("a.json"));
}

/// All numbers of a canal but for places and how far they may be off.
void figures_in(const nlohmann::json& value, const std::string& path, std::map<std::string, double>& figures) {
  if (value.is_number()) figures[path] = value;
  if (!value.is_structured()) return;
  for (const auto& [key, part] : value.items())
    if (key != "at" && key != "orifice" && key != "end" && key != "uncertainty")
      figures_in(part, path + "/" + key, figures);
}

TEST_F(AnatomyCommand, TellsTheSameOfAModelInAFile) {
  const std::vector<std::pair<std::string, std::string>> teeth{
      {"premolar", "0.3"}, {"incisor", "0.25"}, {"molar", "0.35"}};
  for (const auto& [tooth, spacing] : teeth) {
    ASSERT_EQ(odontoscope({"sample", tooth, "--slice-spacing", spacing, "-o", "t.json"}).exit_code, 0);
    ASSERT_EQ(odontoscope({"anatomy", "t.json", "-o", "contours.json"}).exit_code, 0);
    ASSERT_EQ(odontoscope({"reconstruct", "t.json", "-o", "t.glb", "-o", "t.gltf"}).exit_code, 0);
    const auto contours = nlohmann::json::parse(bytes_of("contours.json"));
    EXPECT_NEAR(contours.at("slice_spacing").get<double>(), std::stod(spacing), 1e-4);
    for (const std::string file : {"t.glb", "t.gltf"}) {
      if (file == "t.gltf" && tooth != "premolar") continue;
      ASSERT_EQ(odontoscope({"anatomy", file, "-o", "model.json"}).exit_code, 0);
      const auto model = nlohmann::json::parse(bytes_of("model.json"));
      // The slices given, whatever was interpolated between them.
      EXPECT_NEAR(model.at("slice_spacing").get<double>(), std::stod(spacing), 1e-4) << file;
      ASSERT_EQ(model.at("canals").size(), contours.at("canals").size()) << tooth;
      EXPECT_EQ(model.at("ahmed"), contours.at("ahmed")) << tooth;
      for (std::size_t c = 0; c < model.at("canals").size(); ++c) {
        std::map<std::string, double> one, other;
        figures_in(contours.at("canals")[c], "", one);
        figures_in(model.at("canals")[c], "", other);
        EXPECT_GE(one.size(), 12u);
        EXPECT_EQ(one.size(), other.size()) << tooth;
        for (const auto& [figure, value] : one) {
          // As good as straight: the radius of a bow of a few hundredths of a millimetre over the whole canal is any
          // large number.
          constexpr double straight = 5e-4;  // 1 / mm
          if (figure.ends_with("smallest_bend_radius"))
            EXPECT_NEAR(1 / value, 1 / other[figure], std::max(0.02 / value, straight))
                << figure << " of the " << tooth << " in " << file;
          else
            EXPECT_NEAR(value, other[figure], 0.02 * value) << figure << " of the " << tooth << " in " << file;
        }
      }
    }
  }
}

TEST_F(AnatomyCommand, TellsTheLengthsThatThePageTells) {
  ASSERT_EQ(odontoscope({"sample", "premolar", "--slice-spacing", "0.35", "-o", "p.json"}).exit_code, 0);
  const Ending page = odontoscope({"web", "p.json", "-o", "p.html"});
  if (page.exit_code == 2 && page.complains("was built without its web page")) GTEST_SKIP() << page.err;
  ASSERT_EQ(page.exit_code, 0) << page.err;
  const std::string html = bytes_of("p.html"), begins = "id=\"description\">";
  const std::size_t from = html.find(begins) + begins.size();
  const auto tours = nlohmann::json::parse(html.substr(from, html.find("</script>", from) - from)).at("tours");
  ASSERT_EQ(odontoscope({"anatomy", "p.json", "-o", "a.json"}).exit_code, 0);
  const auto canals = nlohmann::json::parse(bytes_of("a.json")).at("canals");
  ASSERT_EQ(tours.size(), canals.size());
  for (std::size_t c = 0; c < canals.size(); ++c) {
    EXPECT_EQ(tours[c].at("name"), canals[c].at("name"));
    EXPECT_NEAR(tours[c].at("length_mm").get<double>(), canals[c].at("length").get<double>(), 1e-9);
  }
}

TEST_F(AnatomyCommand, WithoutAVoidSaysSoAndEndsWithOne) {
  const Ending told = odontoscope({"anatomy", "block.json"});
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_TRUE(told.says("No void inside")) << told.out;
}

TEST_F(AnatomyCommand, RefusesWhatMakesNoSense) {
  const std::vector<std::string> before = folder.names();
  EXPECT_EQ(odontoscope({"anatomy", "block.json", "-o", "a.txt"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"anatomy", "block.json", "-o", "block.json"}).exit_code, 2);
  EXPECT_EQ(odontoscope({"anatomy", "missing.json"}).exit_code, 4);
  EXPECT_EQ(odontoscope({"render", "block.json", "--tour", "canal-1", "-o", "film.avi"}).exit_code, 2);
  EXPECT_TRUE(odontoscope({"render", "block.json", "--tour", "canal-1", "-o", "film.avi"}).complains("tour.mp4"));
  EXPECT_EQ(odontoscope({"render", "block.json", "--tour", "canal-1", "--turntable", "3", "-o", "."}).exit_code, 2);
  EXPECT_EQ(odontoscope({"render", "block.json", "--frames", "3", "-o", "a.png"}).exit_code, 2);
  EXPECT_EQ(folder.names(), before);
}

}  // namespace
}  // namespace odontoscope::testing_support
