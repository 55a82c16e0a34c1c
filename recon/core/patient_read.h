#pragma once
// Reading what may keep one waiting: a pipe that nobody has written to yet can still be given up.

#include <cstddef>
#include <stop_token>
#include <string>

#include "recon/core/system_files.h"

namespace odontoscope {

/// Up to `count` bytes, at least one unless it is the end; -1 with errno set if they cannot be read. Waits as long as
/// it takes, and throws Cancelled soon after a stop was requested.
std::ptrdiff_t read_some(const system::Descriptor& from, char* to, std::size_t count, const std::stop_token& stop);

}  // namespace odontoscope
