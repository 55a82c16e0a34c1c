#pragma once
// Numbers as bytes, least significant first, as all binary formats here want them.

#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

namespace odontoscope {

static_assert(std::endian::native == std::endian::little, "binary writers copy memory as it is");

template <typename Number>
void append(std::string& bytes, Number number) {
  static_assert(std::is_arithmetic_v<Number>);
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

}  // namespace odontoscope
