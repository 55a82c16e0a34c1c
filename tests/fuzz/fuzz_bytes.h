#pragma once
// What the fuzzers of readers have in common.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "recon/core/error.h"

namespace odontoscope::fuzz {

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program, which is a find, unless `holds`.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// Runs `read`; bad input may be refused, and a file that it names may be missing. Anything else is a find.
template <class Read>
int refused_or_read(Read read) {
  try {
    read();
  } catch (const InputError&) {
  } catch (const FileError&) {
  }
  return 0;
}

/// The bytes as a file in memory, for readers that want a name.
class File {
 public:
  File(const std::uint8_t* data, std::size_t size) : number_(::memfd_create("fuzz", 0)) {
    require(number_ >= 0 && ::write(number_, data, size) == static_cast<ssize_t>(size));
  }
  ~File() { ::close(number_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
};

}  // namespace odontoscope::fuzz
