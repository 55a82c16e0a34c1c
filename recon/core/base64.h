#pragma once
// Bytes as text, and back (RFC 4648).

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace odontoscope {

/// Padded, in one line.
std::string base64(std::string_view bytes);
inline std::string base64(std::span<const std::uint8_t> bytes) {
  return base64(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

/// Padded or not, in this alphabet or the URL's; nothing, if any other character is in it.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace odontoscope
