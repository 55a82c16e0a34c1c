#pragma once
// Bytes as text (RFC 4648). For the .cpp files of this room only.

#include <string>
#include <string_view>

namespace odontoscope {

std::string base64(std::string_view bytes);

}  // namespace odontoscope
