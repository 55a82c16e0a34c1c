#pragma once
// Small things that several subcommands ask of their parsers.

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "recon/core/lower_case.h"
#include "recon/core/named.h"

namespace odontoscope::app {

/// An option that may be given several times, with one value each time.
CLI::Option* repeatable(CLI::Option* option);

/// Validators that the help does not spell out.
CLI::Validator at_least_zero();
CLI::Validator whole_number_from_one_to(int largest);
CLI::Validator one_of(const std::vector<std::string>& words);

/// An option whose value is one of a few words in small letters, each with its meaning; "Molar" is "molar".
template <typename Meaning>
CLI::Option* add_choice(CLI::App& parser, const std::string& name, Meaning& chosen,
                        const std::vector<std::pair<std::string, Meaning>>& choices, const std::string& description) {
  std::vector<std::string> words;
  for (const auto& [word, meaning] : choices) words.push_back(word);
  const auto choose = [&chosen, choices](const std::string& typed) {
    for (const auto& [word, meaning] : choices) {
      if (word == lower_case(typed)) chosen = meaning;
    }
  };
  return parser.add_option_function<std::string>(name, choose, description)->check(one_of(words));
}

/// The same with the table of an enum's words.
template <typename Meaning, typename Value, std::size_t count>
CLI::Option* add_choice(CLI::App& parser, const std::string& name, Meaning& chosen,
                        const NameTable<Value, count>& table, const std::string& description) {
  std::vector<std::pair<std::string, Meaning>> choices;
  for (const Named<Value>& one : table) choices.emplace_back(one.word, one.value);
  return add_choice<Meaning>(parser, name, chosen, choices, description);
}

}  // namespace odontoscope::app
