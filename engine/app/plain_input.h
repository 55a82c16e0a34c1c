#pragma once
// Files that are read more than once, and so can be no pipes.

#include <filesystem>
#include <string>

#include "recon/core/error.h"

namespace odontoscope::app {

/// FileError for what is there but no plain file. An empty name is none.
inline void refuse_pipe(const std::string& file) {
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error) || std::filesystem::is_regular_file(file, error)) return;
  throw FileError(file, "is no plain file", "Give a file: it is read more than once");
}

}  // namespace odontoscope::app
