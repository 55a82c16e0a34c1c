#pragma once
// Small things that several subcommands ask of their parsers.

#include <CLI/CLI.hpp>

namespace odontoscope::app {

/// An option that may be given several times, with one value each time.
CLI::Option* repeatable(CLI::Option* option);

/// Validators that the help does not spell out.
CLI::Validator at_least_zero();
CLI::Validator whole_number_from_one_to(int largest);

}  // namespace odontoscope::app
