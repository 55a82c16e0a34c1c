#pragma once
// Reading what may keep one waiting: a pipe that nobody has written to yet can still be given up. POSIX.

#include <cstddef>
#include <stop_token>
#include <string>

namespace odontoscope {

/// Opens for reading without waiting for a pipe's other end. Returns the descriptor, or -1 with errno set.
int open_to_read(const std::string& file);

/// Up to `count` bytes, at least one unless it is the end; -1 with errno set if they cannot be read. Waits as long as it takes, and throws Cancelled soon after a
/// stop was requested.
std::ptrdiff_t read_some(int descriptor, char* to, std::size_t count, const std::stop_token& stop);

}  // namespace odontoscope
