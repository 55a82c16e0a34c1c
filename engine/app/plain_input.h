#pragma once
// What can be told of an input before it is read.

#include <filesystem>
#include <string>
#include <utility>

#include "recon/core/error.h"

namespace odontoscope::app {

/// FileError for what is there but no plain file, where it is read more than once. An empty name is none.
inline void refuse_pipe(const std::string& file) {
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error) || std::filesystem::is_regular_file(file, error)) return;
  throw FileError(file, "is no plain file", "Give a file: it is read more than once");
}

/// InputError unknown-format for a plain file without a byte: no format is like that.
inline void refuse_empty(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || std::filesystem::file_size(file, error) > 0 || error) return;
  Place place;
  place.file = file;
  throw InputError("unknown-format", std::move(place), "the file is empty", "Write or copy it again");
}

}  // namespace odontoscope::app
