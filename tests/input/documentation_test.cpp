// docs/formats.md knows every cause that is thrown, and throws in nobody's name that it does not know.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "recon/core/read_file.h"
#include "recon/input/links.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "tests/input/corpus.h"

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

/// First column of the tables that are headed "cause".
std::set<std::string> documented_causes() {
  std::istringstream text(read_file((source_folder() / "docs/formats.md").string()));
  const std::regex row("^\\| `([a-z0-9-]+)` \\|");
  std::set<std::string> causes;
  bool in_table = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("| cause |")) in_table = true;
    if (line.empty()) in_table = false;
    std::smatch match;
    if (in_table && std::regex_search(line, match, row)) causes.insert(match[1]);
  }
  return causes;
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

/// Examples are "`name.json...: message [cause]`", with the name of a file of the corpus: each must be what is said
/// today.
TEST(Documentation, QuotesRealMessages) {
  const std::regex example("`([a-z0-9-]+\\.[a-z0-9-]+\\.json)(:[^`]*\\[[a-z0-9-]+\\])`");
  const std::string text = read_file((source_folder() / "docs/formats.md").string());
  const ContourStack linked = ordered(read_stack((corpus::folder() / "links_stack.json").string())).stack;
  int examples = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), example), end; it != end; ++it, ++examples) {
    const std::string name = (*it)[1];
    const bool links = !std::filesystem::exists(corpus::folder() / "bad" / name);
    const std::string file = (corpus::folder() / (links ? "bad_links" : "bad") / name).string();
    try {
      if (links) {
        validate_links(read_links(file), linked, file);
      } else {
        validate(read_stack(file));
      }
      ADD_FAILURE() << name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), file + (*it)[2].str());
    }
  }
  EXPECT_GE(examples, 25);
}

}  // namespace
}  // namespace odontoscope
