#pragma once
// What the fuzzers of readers have in common.

#include <cstdint>
#include <string_view>

#include "recon/core/error.h"

namespace odontoscope::fuzz {

inline std::string_view text(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

/// Runs `read`; bad input may be refused, anything else is a find.
template <class Read>
int refused_or_read(Read read) {
  try {
    read();
  } catch (const InputError&) {
  }
  return 0;
}

}  // namespace odontoscope::fuzz
