#pragma once
// One image through one of ITK's ImageIO classes, with its header looked at before its pixels. Inner part of
// read_volume.h; the only header here that knows ITK.

#include <itkImageIOBase.h>

#include <string>
#include <vector>

#include "recon/volume/oriented_image.h"

namespace odontoscope {

/// Header of `file` as a FileImage without values, and the ImageIO that is ready to read its pixels.
struct OpenedImage {
  FileImage image;
  itk::ImageIOBase::Pointer io;
};

/// Throws InputError unreadable-volume, not-scalar, not-3d, pixel-type.
OpenedImage open_image(itk::ImageIOBase::Pointer io, const std::string& file);

/// Reads the pixels of an image that `open_image` opened and whose size was found acceptable, converted to float, to
/// `to`, which has room for all of them. Throws InputError unreadable-volume.
void read_pixels(const OpenedImage& opened, float* to);

/// Bytes of the pixels as the file has them.
std::size_t bytes_of_pixels(const OpenedImage& opened);

/// "header: what ITK says", on one line and not too long.
[[noreturn]] void throw_unreadable(const std::string& file, const std::string& part, const std::string& what);

}  // namespace odontoscope
