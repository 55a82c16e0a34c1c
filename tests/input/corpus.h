#pragma once
// The files of tests/corpus. A bad one is named for the error that it must give: "<cause>.<what is wrong>.json".

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "recon/core/read_file.h"

namespace odontoscope::corpus {

inline std::filesystem::path folder() { return ODONTOSCOPE_CORPUS; }

/// Sorted, so that messages come in the same order everywhere.
inline std::vector<std::filesystem::path> files(const char* subfolder) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder() / subfolder)) {
    if (entry.path().extension() == ".json") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

inline std::string expected_cause(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.'));
}

}  // namespace odontoscope::corpus
