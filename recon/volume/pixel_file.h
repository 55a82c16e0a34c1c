#pragma once
// The bytes that a volume's header points to, as numbers. Inner part of read_volume.h.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "recon/core/progress.h"

namespace odontoscope {

enum class PixelType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t bytes_of(PixelType type);

/// How a volume's pixels lie in files.
struct PixelFiles {
  /// `deflate`: zlib or gzip. `text`: numbers between blanks. `hex`: two digits a byte.
  enum class Encoding { raw, deflate, text, hex };

  /// In order; each holds the same share of the pixels.
  std::vector<std::string> paths;
  Encoding encoding = Encoding::raw;
  /// The whole file is packed, header included: offset and skips count in the unpacked one.
  bool packed_whole = false;
  /// Where the pixels begin, or where the skips do.
  std::size_t offset = 0;
  /// Then so many lines and, behind them and unpacked, so many bytes are passed over.
  std::size_t line_skip = 0, byte_skip = 0;
  /// Instead: the pixels are the file's end, whatever comes before.
  bool at_end = false;
  /// How many packed bytes there are; 0: all up to the file's end.
  std::size_t packed_bytes = 0;

  PixelType type = PixelType::uint8;
  /// Stored in the byte order that is not this machine's.
  bool swapped = false;
  /// Value = slope * stored + intercept.
  double slope = 1, intercept = 0;
};

/// Throws FileError for files that are missing or no plain files; InputError truncated-volume where they cannot hold
/// `count` pixels (packed ones: not even at limits::compression_ratio), too-well-packed where few bytes are to become
/// very many (limits::suspicious_ratio). Nothing is unpacked for it.
void check_pixel_files(const PixelFiles& files, std::size_t count);

/// Calls `visit` with the pixels, converted, in the file's order, a run of them after the other. Throws and tells as
/// read_pixels does.
void for_each_run(const PixelFiles& files, std::size_t count, const Progress& progress,
                  const std::function<void(const float* values, std::size_t count)>& visit);

/// The pixels, converted. Memory is taken as they come. Throws what check_pixel_files throws, InputError damaged-volume
/// if unpacking fails or a number is none, truncated-volume. Stage "read".
std::vector<float> read_pixels(const PixelFiles& files, std::size_t count, const Progress& progress);

/// `count` stored numbers to `to`; `raw` holds bytes_of(type) * count bytes.
void convert_pixels(PixelType type, bool swapped, double slope, double intercept, const char* raw, std::size_t count,
                    float* to);

/// Throws FileError if this machine has not so many bytes of memory left for `file`'s volume: told before they are
/// taken.
void check_memory(const std::string& file, std::size_t voxels);

}  // namespace odontoscope
