#pragma once
// The interface's typeface, embedded when the program was built (third_party/interface.cmake says which).

#include <span>

namespace odontoscope {

/// The bytes of a TrueType or OpenType file.
std::span<const unsigned char> regular_font();
std::span<const unsigned char> bold_font();

}  // namespace odontoscope
