#pragma once
// Which file holds a volume's pixels, and is it long enough for what the header claims? Asked before memory is. Inner part of
// read_volume.h.

#include <cstddef>
#include <string>

namespace odontoscope {

enum class VolumeFormat { nrrd, meta_image, nifti };

/// Throws InputError truncated-volume if `bytes` of pixels cannot come out of the file that the header at `path` points to
/// (itself or another), many-data-files if it points to more than one; FileError if that one is missing or no plain file.
void check_data_file(const std::string& path, VolumeFormat format, std::size_t bytes);

}  // namespace odontoscope
