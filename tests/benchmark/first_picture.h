#pragma once
// From the start of a program to its first PNG, by the wall clock.

#include <optional>
#include <string>
#include <vector>

namespace odontoscope {

/// Median of `runs` runs in seconds; nothing if the program cannot be run or fails. Its words are thrown away.
std::optional<double> seconds_to_run(const std::vector<std::string>& words, int runs);

}  // namespace odontoscope
