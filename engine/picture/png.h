#pragma once
// PNG in and out.

#include <string>

#include "engine/picture/image.h"

namespace odontoscope {

/// The file's bytes. The same picture gives the same bytes.
std::string png_bytes(const Image& image);

/// Writes the whole file or nothing. Throws FileError.
void write_png(const Image& image, const std::string& file);

/// Reads a PNG of at most `most_picture_side` pixels a side as 8 bit RGBA; 16 bits are reduced, grey and palettes
/// expanded. Throws FileError (cannot be read) or InputError: not-a-png, picture-too-large.
Image read_png(const std::string& file);

}  // namespace odontoscope
