// docs/formats.md knows every cause that is thrown, and throws in nobody's name that it does not know.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "recon/core/read_file.h"

namespace odontoscope {
namespace {

std::filesystem::path source_folder() { return ODONTOSCOPE_SOURCE; }

std::set<std::string> all_matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) found.insert((*it)[1]);
  return found;
}

/// First argument of InputError's constructor and of the functions of ours that lead to it.
std::set<std::string> thrown_causes() {
  const std::regex thrown("(?:InputError|refuse)\\s*\\(\\s*\"([a-z0-9-]+)\"");
  std::set<std::string> causes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "recon")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    causes.merge(all_matches(read_file(entry.path().string()), thrown));
  }
  return causes;
}

/// Rows of the tables of causes: "| `cause` | ...".
std::set<std::string> documented_causes() {
  return all_matches(read_file((source_folder() / "docs/formats.md").string()),
                     std::regex("\\n\\| `([a-z0-9-]+)` \\|"));
}

TEST(Documentation, ListsEveryCause) {
  const std::set<std::string> thrown = thrown_causes(), documented = documented_causes();
  EXPECT_GE(thrown.size(), 30u);
  for (const std::string& cause : thrown) {
    EXPECT_TRUE(documented.contains(cause)) << "not in docs/formats.md: " << cause;
  }
}

TEST(Documentation, ListsNoCauseThatIsNotThrown) {
  const std::set<std::string> thrown = thrown_causes();
  for (const std::string& cause : documented_causes()) {
    EXPECT_TRUE(thrown.contains(cause)) << "in docs/formats.md but thrown nowhere: " << cause;
  }
}

}  // namespace
}  // namespace odontoscope
