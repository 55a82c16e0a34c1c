// docs/formats.md and the sources say the same: the causes listed are those thrown, the examples what is really said.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "recon/core/read_file.h"
#include "recon/input/links.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "tests/input/corpus.h"

namespace odontoscope {
namespace {

std::filesystem::path source_folder() { return ODONTOSCOPE_SOURCE; }

std::string formats_page() { return read_file((source_folder() / "docs/formats.md").string()); }

/// The word of small letters, digits and hyphens that `text` begins with after spaces, `open` and a quote; "" if none
/// does.
std::string word_behind(std::string_view text, std::string_view open) {
  const auto skip_spaces = [&text] { text.remove_prefix(std::min(text.find_first_not_of(" \n"), text.size())); };
  for (const char c : open) {
    skip_spaces();
    if (!text.starts_with(c)) return {};
    text.remove_prefix(1);
  }
  const std::size_t length = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-");
  if (length == std::string_view::npos || text[length] != open.back()) return {};
  return std::string(text.substr(0, length));
}

/// First argument of InputError's constructor, and of the functions named `refuse` and `fault` that lead to it, and
/// what declarations name as the cause of a fault.
std::set<std::string> thrown_causes() {
  std::set<std::string> causes;
  std::vector<std::filesystem::path> sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "recon"))
    sources.push_back(entry.path());
  sources.push_back(source_folder() / "engine/app/made_model.cpp");  // moves models by what is said on the command line
  sources.push_back(source_folder() / "engine/language/language_json.cpp");
  sources.push_back(source_folder() / "engine/navigate/notes_json.cpp");
  sources.push_back(source_folder() / "engine/navigate/question_json.cpp");
  for (const std::filesystem::path& source : sources) {
    if (source.extension() != ".cpp" && source.extension() != ".h") continue;
    const std::string text = read_file(source.string());
    for (const auto& [thrower, open] :
         std::initializer_list<std::pair<std::string_view, std::string_view>>{{"InputError", "(\""},
                                                                              {"refuse", "(\""},
                                                                              {"fault", "(\""},
                                                                              {".cause", "=\""},
                                                                              {".truncated", "=\""},
                                                                              {".unreadable", "=\""}}) {
      for (std::size_t at = text.find(thrower); at != std::string::npos; at = text.find(thrower, at + 1)) {
        causes.insert(word_behind(std::string_view(text).substr(at + thrower.size()), open));
      }
    }
  }
  causes.erase("");
  return causes;
}

/// First column of the tables that are headed "cause".
std::set<std::string> documented_causes() {
  std::istringstream text(formats_page());
  std::set<std::string> causes;
  bool in_table = false;
  for (std::string line; std::getline(text, line);) {
    if (line.empty()) in_table = false;
    if (in_table) causes.insert(word_behind(line, "|`"));
    if (line.starts_with("| cause |")) in_table = true;
  }
  causes.erase("");
  return causes;
}

/// "`name.json...: message [cause]`", with the name of a file of the corpus.
std::vector<std::string> examples() {
  const std::string text = formats_page();
  std::vector<std::string> found;
  for (std::size_t open = text.find('`'); open != std::string::npos;) {
    const std::size_t close = text.find('`', open + 1);
    const std::string code = text.substr(open + 1, close - open - 1);
    if (code.find(".json:") != std::string::npos && code.ends_with(']')) found.push_back(code);
    open = close == std::string::npos ? close : text.find('`', close + 1);
  }
  return found;
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

TEST(Documentation, QuotesRealMessages) {
  const ContourStack linked = ordered(read_stack((corpus::folder() / "links_stack.json").string())).stack;
  EXPECT_GE(examples().size(), 25u);
  for (const std::string& example : examples()) {
    const std::string name = example.substr(0, example.find(':'));
    const bool links = !std::filesystem::exists(corpus::folder() / "bad" / name);
    const std::filesystem::path folder = corpus::folder() / (links ? "bad_links" : "bad");
    const std::string file = (folder / name).string();
    try {
      if (links) {
        validate_links(read_links(file), linked, file);
      } else {
        validate(read_stack(file));
      }
      ADD_FAILURE() << name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), (folder / example).string());
    }
  }
}

}  // namespace
}  // namespace odontoscope
