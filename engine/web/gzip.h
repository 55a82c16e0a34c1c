#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace odontoscope {

/// RFC 1952, without a time or a name: the same input gives the same bytes.
std::vector<std::uint8_t> gzip(std::string_view bytes);

}  // namespace odontoscope
