#pragma once
// What a mistyped word on the command line was probably meant to be.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace odontoscope::app {

/// The long option of one of `parsers` that is spelt like `argument`, unless it is one of them or like none.
std::optional<std::string> similar_option(const std::string& argument, const std::vector<const CLI::App*>& parsers);

/// The subcommand of `root` that is spelt like `argument`.
std::optional<std::string> similar_subcommand(const std::string& argument, const CLI::App& root);

}  // namespace odontoscope::app
