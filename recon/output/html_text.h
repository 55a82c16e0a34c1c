#pragma once
// What the writers of web pages have in common.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace odontoscope {

/// Text as text, in an element or in a quoted attribute, whatever is in it.
std::string escaped_html(std::string_view text);

/// RFC 4648, padded, in one line.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace odontoscope
