#pragma once
// The interface's typeface, embedded when the program was built (cmake/interface.cmake says which).

#include <span>

#include "recon/core/embedded_file.h"

namespace odontoscope {

/// Two TrueType or OpenType files: regular, bold.
std::span<const EmbeddedFile> font_files();

inline std::span<const unsigned char> bytes_of(const EmbeddedFile& file) {
  return {reinterpret_cast<const unsigned char*>(file.bytes.data()), file.bytes.size()};
}
inline std::span<const unsigned char> regular_font() { return bytes_of(font_files()[0]); }
inline std::span<const unsigned char> bold_font() { return bytes_of(font_files()[1]); }

}  // namespace odontoscope
