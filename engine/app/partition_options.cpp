#include "engine/app/partition_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/core/error.h"

namespace odontoscope::app {

void add_partition_options(CLI::App& parser, PartitionWords& words) {
  const std::string group = "Partition";
  constexpr double widest = 1e6;  // mm: more than any input
  parser.add_flag("--partition", words.wanted, "One complex: structures share their faces, without gap or overlap")
      ->group(group);
  parser
      .add_flag("--independent", words.independent,
                "Each structure by itself, even where structures share walls or overlap")
      ->group(group);
  parser
      .add_option("--priority", words.priority, "Who keeps the place where structures overlap; default: the inner one")
      ->type_name("A,B,...")
      ->group(group);
  parser.add_option("--gap", words.gap, "Void narrower than this between two structures is closed")
      ->type_name("MM")
      ->check(CLI::Range(0.0, widest).description(""))
      ->group(group);
}

std::vector<std::string> names_in(const std::string& list, const std::string& option) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    names.push_back(list.substr(from, comma - from));
    from = comma + 1;
  }
  if (names.size() >= 2) return names;
  throw UsageError(fmt::format("{} {}: that is no list of two or more structures", option, list),
                   fmt::format("For example {} pulp,dentine", option));
}

void refuse_senseless(const PartitionWords& words) {
  if (words.wanted && words.independent)
    throw UsageError("--partition and --independent are opposites", "Use one of the two");
  if (!words.wanted && (!words.priority.empty() || words.gap))
    throw UsageError("--priority and --gap are about --partition", "Add --partition, or leave them out");
  if (!words.priority.empty()) names_in(words.priority, "--priority");
}

}  // namespace odontoscope::app
