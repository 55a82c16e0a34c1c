// One name, one type: the linker takes the first of two types of one name, and what was compiled for the other reads it
// wrongly.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace odontoscope::test {
namespace {

/// Types that headers define at the left margin, each with its namespace: where they are defined.
using Definitions = std::map<std::string, std::vector<std::string>>;

void collect(std::istream& header, const std::string& file, Definitions& found) {
  static const std::regex space(R"(namespace ([\w:]+) \{.*)"),
      type(R"((?:struct|class|enum class|enum) (\w+)\b[^;]*\{.*)");
  std::string line, inside;
  std::smatch words;
  while (std::getline(header, line)) {
    if (std::regex_match(line, words, space))
      inside = words[1];
    else if (std::regex_match(line, words, type))
      found[inside + "::" + words[1].str()].push_back(file);
  }
}

TEST(Types, AreDefinedOnceInAllRooms) {
  Definitions found;
  for (const char* part : {"recon", "engine"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(ODONTOSCOPE_SOURCE) / part)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream header(entry.path());
      collect(header, entry.path().string(), found);
    }
  }
  EXPECT_GT(found.size(), 300u) << "no headers were found";
  for (const auto& [name, files] : found)
    EXPECT_EQ(files.size(), 1u) << name << " is defined in " << files.front() << " and " << files.back();
}

/// One word, one thing: a header's name says what it is about without its folder. Only limits are each room's own.
TEST(Headers, HaveNamesOfTheirOwn) {
  std::map<std::string, std::vector<std::string>> found;
  for (const char* part : {"recon", "engine"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(ODONTOSCOPE_SOURCE) / part))
      if (entry.path().extension() == ".h" && entry.path().filename() != "limits.h")
        found[entry.path().filename().string()].push_back(entry.path().string());
  EXPECT_GT(found.size(), 300u) << "no headers were found";
  for (const auto& [name, files] : found) EXPECT_EQ(files.size(), 1u) << files.front() << " and " << files.back();
}

TEST(Types, OfOneNameInTwoHeadersAreFound) {
  Definitions found;
  std::istringstream one("namespace odontoscope {\nstruct Box {\n};\n"),
      other("namespace odontoscope {\nclass Box final {\n};\n"),
      apart("namespace odontoscope::between {\nstruct Box {\n};\n"), named("namespace odontoscope {\nstruct Box;\n");
  collect(one, "one.h", found);
  collect(other, "other.h", found);
  collect(apart, "apart.h", found);
  collect(named, "named.h", found);
  EXPECT_EQ(found.at("odontoscope::Box").size(), 2u);
  EXPECT_EQ(found.at("odontoscope::between::Box").size(), 1u);
}

}  // namespace
}  // namespace odontoscope::test
