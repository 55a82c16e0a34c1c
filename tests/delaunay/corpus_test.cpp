// Every failure that was ever found, and small instructive stacks: tests/corpus/engine/*.json, each with a line in
// expected.json.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/delaunay/engine_checks.h"
#include "tests/support/stack_text.h"
#include "tests/support/variants.h"

namespace odontoscope::test {
namespace {

using nlohmann::json;
const std::filesystem::path folder = ODONTOSCOPE_ENGINE_CORPUS;

json lines() { return json::parse(std::ifstream(folder / "expected.json")); }

ReconstructOptions options_of(const json& line) {
  ReconstructOptions options;
  const std::string criterion = line.value("correspondence", "medial");
  for (Correspondence c :
       {Correspondence::reverse, Correspondence::medial, Correspondence::overlap, Correspondence::tracked})
    if (criterion == name(c)) options.correspondence = c;
  for (const json& link : line.value("links", json::array()))
    options.links.push_back(
        {link.value("structure", "tooth"), link.at("slice"), link.at("lower"), link.at("upper"), link.at("connect")});
  return options;
}

TEST(Corpus, EveryFileHasALineAndEveryLineAFile) {
  std::set<std::string> files, named;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json" && entry.path().filename() != "expected.json")
      files.insert(entry.path().filename().string());
  for (const json& line : lines()) named.insert(line.at("file").get<std::string>());
  EXPECT_EQ(files, named);
}

TEST(Corpus, IsCertifiedFromEverySide) {
  for (const json& line : lines()) {
    const std::string file = line.at("file");
    SCOPED_TRACE(file + ": " + line.value("why", ""));
    const ContourStack stack = read_stack_file((folder / file).string());
    ReconstructOptions options = options_of(line);
    if (!line.contains("refused")) {
      EXPECT_EQ(outcome_of(stack, options).failure, "") << "blended";
    }
    options.between = Between::delaunay;  // a raster between slices does not turn with them
    if (line.contains("refused")) {
      try {
        reconstruct(stack, options);
        ADD_FAILURE() << "accepted";
      } catch (const InputError& error) {
        EXPECT_EQ(error.cause(), line.at("refused").get<std::string>());
      }
      continue;
    }
    const Outcome usual = outcome_of(stack, options);
    EXPECT_EQ(usual.failure, "");
    if (line.contains("most_tetrahedra")) {
      EXPECT_LE(reconstruct(stack, options).counts.kept, line.at("most_tetrahedra"));
    }
    if (line.contains("shells")) {
      EXPECT_EQ(usual.topology, shells(line.at("shells").get<std::vector<std::string>>()));
    }
    if (!options.links.empty()) continue;  // links name slices and contours by number
    for (const Variant& variant : variants_of(stack, line.value("seed", 1u))) {
      const Outcome seen = outcome_of(variant.stack, options);
      EXPECT_EQ(seen.failure, "") << variant.name;
      if (line.value("general_position", false) || variant.keeps_order_of_points) {
        EXPECT_EQ(seen.topology, usual.topology) << variant.name;
      }
    }
  }
}

}  // namespace
}  // namespace odontoscope::test
