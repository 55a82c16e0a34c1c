#pragma once
// The bytes that a volume's header points to: are they all there? Inner part of read_volume.h.

#include <cstddef>
#include <string>

namespace odontoscope {

/// How a volume's pixels lie in a file.
struct PixelFile {
  enum class Packing { raw, deflate, other };

  std::string path;
  /// Where they begin, counted in the unpacked file where `unpack_from_start`.
  std::size_t offset = 0;
  Packing packing = Packing::raw;
  /// The whole file is packed, header included (NIfTI .gz), and not only what follows `offset`.
  bool unpack_from_start = false;
  /// How many packed bytes follow `offset`; 0: all up to the file's end.
  std::size_t packed_bytes = 0;
};

/// Floating-point pixels that are to be looked at for NaN and infinity.
struct FloatPixels {
  std::size_t bytes_each = 0;  // 4 or 8; 0: the pixels are whole numbers
  bool swapped = false;        // stored in the other byte order
};

/// Throws FileError if the file is missing or no plain file; InputError truncated-volume if it holds fewer than `bytes`
/// bytes of pixels (deflated data is unpacked to count them; other packings are held to limits::compression_ratio),
/// damaged-volume if unpacking fails, not-finite if one of `floats` is NaN or infinite.
void check_pixel_file(const PixelFile& file, std::size_t bytes, FloatPixels floats = {});

}  // namespace odontoscope
