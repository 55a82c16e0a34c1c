#pragma once
// The options of a partition, for all commands that make models of contours.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace odontoscope::app {

/// As typed; not yet understood.
struct PartitionWords {
  bool wanted = false;        // --partition
  bool independent = false;   // --independent
  std::string priority;       // "A,B"; empty: none
  std::optional<double> gap;  // mm
};

/// --partition, --independent, --priority and --gap.
void add_partition_options(CLI::App& parser, PartitionWords& words);

/// "A,B" of an option. UsageError if that is no list of two or more names.
std::vector<std::string> names_in(const std::string& list, const std::string& option);

/// UsageError for --priority or --gap without --partition, for --partition and --independent at once, or a priority
/// that is no list.
void refuse_senseless(const PartitionWords& words);

}  // namespace odontoscope::app
