#include "engine/app/spelling.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

namespace odontoscope::app {
namespace {

/// Letters to add, drop or change, and neighbours to swap, to get from one word to the other (Damerau and Levenshtein,
/// "optimal string alignment").
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> next(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      next[j] = std::min({row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        next[j] = std::min(next[j], before[j - 2] + 1);
    }
    before = std::move(row);
    row = std::move(next);
  }
  return row[b.size()];
}

std::optional<std::string> most_similar(const std::string& word, const std::vector<std::string>& known) {
  const std::size_t letters_for_one_slip = 3;
  std::optional<std::string> best;
  std::size_t fewest = word.size() / letters_for_one_slip + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance = edits(word, candidate);
    // A word that was cut short ("recon") is meant as well.
    const bool abbreviated = word.size() >= letters_for_one_slip && candidate.starts_with(word);
    if (distance == 0) return std::nullopt;
    if (distance < fewest || (abbreviated && !best)) {
      best = candidate;
      fewest = std::min(fewest, distance);
    }
  }
  return best;
}

}  // namespace

std::optional<std::string> similar_option(const std::string& argument, const std::vector<const CLI::App*>& parsers) {
  if (!argument.starts_with('-')) return std::nullopt;
  std::string word = argument.substr(std::min(argument.find_first_not_of('-'), argument.size()));
  word = word.substr(0, word.find('='));
  if (word.size() < 2) return std::nullopt;
  std::vector<std::string> names;
  for (const CLI::App* parser : parsers) {
    for (const CLI::Option* option : parser->get_options()) {
      names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
    }
  }
  // One dash instead of two is a slip as well.
  const bool one_dash = !argument.starts_with("--");
  if (one_dash && std::find(names.begin(), names.end(), word) != names.end()) return "--" + word;
  const auto meant = most_similar(word, names);
  return meant ? std::optional("--" + *meant) : std::nullopt;
}

std::optional<std::string> similar_subcommand(const std::string& argument, const CLI::App& root) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : root.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(subcommand->get_name());
  }
  return most_similar(argument, names);
}

}  // namespace odontoscope::app
