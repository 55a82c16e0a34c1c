#pragma once
// Reading a file whole, with its size bounded.

#include <cstddef>
#include <stop_token>
#include <string>

#include "recon/core/limits.h"

namespace odontoscope {

/// The bytes of `file`. Regular files and pipes are read; FileError if it is missing, a folder, a device, or cannot
/// be read; InputError "file-too-large" if it holds more than `most_bytes` (nothing beyond that is read).
/// Waits for pipes, and throws Cancelled soon after a stop was requested.
std::string read_file(const std::string& file, std::size_t most_bytes = limits::file_bytes,
                      const std::stop_token& stop = {});

}  // namespace odontoscope
