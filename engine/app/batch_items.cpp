#include "engine/app/batch_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/core/read_file.h"
#include "recon/core/system_files.h"

namespace odontoscope::app {
namespace {

namespace fs = std::filesystem;

/// A list is text that somebody made; an index of a million scans is the most that one folder of results can hold.
constexpr std::size_t most_list_bytes = 256u << 20, most_inputs = 1'000'000;

bool is_list(const std::string& source) {
  const std::string name = lower_case(source);
  return name.ends_with(".txt") || name.ends_with(".list");
}

bool is_pattern(const std::string& source) {
  std::error_code error;
  return source.find_first_of("*?[") != source.npos && !fs::exists(source, error);
}

void add_matching(const std::string& pattern, std::vector<BatchItem>& items) {
  const auto found = system::files_matching(pattern);
  if (!found) throw FileError(pattern, "cannot be looked for", "Check the folders' permissions");
  for (const std::string& file : *found) items.push_back({file, {}, {}});
  if (found->empty())
    throw UsageError(fmt::format("nothing matches {}", pattern),
                     "Give files, a pattern that matches some, or a list of them");
}

void add_listed(const std::string& list, std::vector<BatchItem>& items) {
  const std::string text = read_file(list, most_list_bytes);
  std::size_t number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string_view line = std::string_view(text).substr(from, end - from);
    from = end + 1;
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('#')) continue;
    std::vector<std::string> words = words_in_line(line, fmt::format("{}:{}", list, number));
    if (words.empty()) continue;
    std::string input = std::move(words.front());
    words.erase(words.begin());
    items.push_back({std::move(input), std::move(words), {}});
    if (items.size() > most_inputs) break;
  }
}

/// "tooth" for "scans/tooth.nii.gz" and "scans/tooth/".
std::string bare_name(const fs::path& input) {
  fs::path name = input.has_filename() ? input.filename() : input.parent_path().filename();
  if (lower_case(name.extension().string()) == ".gz") name = name.stem();
  return name.has_stem() ? name.stem().string() : name.string();
}

/// Folders above an input, the nearest first.
std::vector<std::string> folders_above(const fs::path& input) {
  fs::path path = fs::absolute(input).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  std::vector<std::string> folders;
  for (path = path.parent_path(); path.has_filename(); path = path.parent_path())
    folders.push_back(path.filename().string());
  return folders;
}

void name_apart(std::vector<BatchItem*>& alike) {
  std::vector<std::vector<std::string>> above;
  for (const BatchItem* item : alike) above.push_back(folders_above(item->input));
  std::vector<std::size_t> taken(alike.size(), 0);
  for (;;) {
    std::map<std::string, std::vector<std::size_t>> by_name;
    for (std::size_t n = 0; n < alike.size(); ++n) by_name[alike[n]->name].push_back(n);
    bool all_apart = true;
    for (const auto& [name, members] : by_name) {
      if (members.size() < 2) continue;
      all_apart = false;
      for (const std::size_t n : members) {
        if (taken[n] == above[n].size())
          throw UsageError(fmt::format("{} and {} would both be called {}", alike[members[0]]->input,
                                       alike[members[1]]->input, name),
                           "Leave one out, or call it otherwise");
        alike[n]->name = above[n][taken[n]++] + "-" + alike[n]->name;
      }
    }
    if (all_apart) return;
  }
}

/// Those named alike by their last part get longer names together; a longer name might be another's, so the whole is
/// looked at once more.
void name_all(std::vector<BatchItem>& items) {
  std::map<std::string, std::vector<BatchItem*>> by_name;
  for (BatchItem& item : items) {
    item.name = bare_name(item.input);
    by_name[item.name].push_back(&item);
  }
  for (auto& [name, alike] : by_name)
    if (alike.size() > 1) name_apart(alike);
  std::map<std::string, const BatchItem*> taken;
  for (const BatchItem& item : items) {
    const auto [other, is_new] = taken.emplace(item.name, &item);
    if (!is_new)
      throw UsageError(fmt::format("{} and {} would both be called {}", other->second->input, item.input, item.name),
                       "Call one of them otherwise");
  }
}

}  // namespace

std::vector<std::string> words_in_line(std::string_view line, const std::string& what) {
  if (line.find('\0') != line.npos)
    throw UsageError(fmt::format("{}: there is a byte 0 in it", what), "Give a list that is text");
  std::vector<std::string> words;
  bool within = false;
  char quote = 0;
  for (std::size_t n = 0; n < line.size(); ++n) {
    const char c = line[n];
    const bool blank = quote == 0 && (c == ' ' || c == '\t');
    if (blank) {
      within = false;
      continue;
    }
    if (!within) words.emplace_back();
    within = true;
    if (c == quote)
      quote = 0;
    else if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else if (c == '\\' && quote != '\'' && n + 1 < line.size())
      words.back() += line[++n];
    else
      words.back() += c;
  }
  if (quote != 0)
    throw UsageError(fmt::format("{}: a quote does not end", what), "Write quotes in pairs, or \\' and \\\"");
  return words;
}

std::vector<BatchItem> batch_items(const std::vector<std::string>& sources) {
  std::vector<BatchItem> items;
  for (const std::string& source : sources) {
    if (is_pattern(source))
      add_matching(source, items);
    else if (is_list(source))
      add_listed(source, items);
    else
      items.push_back({source, {}, {}});
    if (items.size() > most_inputs) {
      Place place;
      place.file = source;
      throw InputError("too-many-inputs", place, fmt::format("these are more than {} inputs", most_inputs),
                       "Part them into several batches");
    }
  }
  if (items.empty()) throw UsageError("that names no input", "Give files, a pattern, or a list of them");
  name_all(items);
  return items;
}

}  // namespace odontoscope::app
