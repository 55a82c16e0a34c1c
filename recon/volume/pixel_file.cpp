#include "recon/volume/pixel_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;
using Bytes = std::span<const std::uint8_t>;

Place in_file(const std::string& file) {
  Place place;
  place.file = file;
  return place;
}

/// Takes pixels as they come, in pieces of any length; counts them and looks for floats that are not finite.
class PixelSink {
 public:
  PixelSink(const std::string& file, std::size_t skip, std::size_t wanted, FloatPixels floats)
      : file_(file), skip_(skip), wanted_(wanted), floats_(floats) {}

  bool full() const { return taken_ == wanted_; }
  std::size_t taken() const { return taken_; }

  void take(Bytes bytes) {
    const std::size_t skipped = std::min(skip_, bytes.size());
    skip_ -= skipped;
    bytes = bytes.subspan(skipped);
    bytes = bytes.first(std::min(bytes.size(), wanted_ - taken_));
    if (floats_.bytes_each != 0) {
      for (const std::uint8_t byte : bytes) take_float_byte(byte);
    } else {
      taken_ += bytes.size();
    }
  }

 private:
  void take_float_byte(std::uint8_t byte) {
    const std::size_t at = taken_++ % floats_.bytes_each;
    pending_[floats_.swapped ? floats_.bytes_each - 1 - at : at] = byte;
    if (at + 1 < floats_.bytes_each) return;
    double value = 0;
    if (floats_.bytes_each == sizeof(float)) {
      float single;
      std::memcpy(&single, pending_.data(), sizeof single);
      value = single;
    } else {
      std::memcpy(&value, pending_.data(), sizeof value);
    }
    if (std::isfinite(value)) return;
    throw InputError("not-finite", in_file(file_),
                     fmt::format("voxel number {} is not a finite number", (taken_ - 1) / floats_.bytes_each),
                     "replace undefined voxels by the value of their surroundings before contouring");
  }

  std::string file_;
  std::size_t skip_, wanted_;
  FloatPixels floats_;
  std::size_t taken_ = 0;
  std::array<std::uint8_t, sizeof(double)> pending_{};
};

/// Calls `take(bytes)` with the file's content from `offset` on until that returns false.
template <class Take>
void for_each_piece(const std::string& path, std::size_t offset, const Take& take) {
  constexpr std::size_t piece = 1u << 18;
  std::vector<std::uint8_t> buffer(piece);
  std::ifstream in(path, std::ios::binary);
  if (!in.seekg(static_cast<std::streamoff>(offset))) return;
  while (in) {
    in.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(piece));
    const auto got = static_cast<std::size_t>(in.gcount());
    if (got == 0 || !take(Bytes(buffer.data(), got))) return;
  }
}

/// zlib's inflate of a zlib or gzip stream, several gzip members in a row included.
class Inflater {
 public:
  explicit Inflater(const std::string& file) : file_(file) {
    constexpr int zlib_or_gzip = 15 + 32;
    if (inflateInit2(&stream_, zlib_or_gzip) != Z_OK) throw InternalError("zlib does not start");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// False once the sink is full or the data is at its end.
  bool take(Bytes packed, PixelSink& sink) {
    stream_.next_in = const_cast<Bytef*>(packed.data());
    stream_.avail_in = static_cast<uInt>(packed.size());
    int code = Z_OK;
    do {
      if (ended_ && inflateReset(&stream_) != Z_OK) throw InternalError("zlib does not go on");
      stream_.next_out = unpacked_.data();
      stream_.avail_out = static_cast<uInt>(unpacked_.size());
      code = inflate(&stream_, Z_NO_FLUSH);
      if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) {
        if (ended_) return false;  // padding after the last member
        throw InputError("damaged-volume", in_file(file_), "its compressed pixels cannot be unpacked",
                         "get a whole copy of the file");
      }
      ended_ = code == Z_STREAM_END;
      sink.take(Bytes(unpacked_.data(), unpacked_.size() - stream_.avail_out));
    } while (!sink.full() && (stream_.avail_out == 0 || (ended_ && stream_.avail_in > 0)));
    return !sink.full();
  }

 private:
  std::string file_;
  z_stream stream_{};
  bool ended_ = false;
  std::vector<std::uint8_t> unpacked_ = std::vector<std::uint8_t>(1u << 18);
};

[[noreturn]] void throw_truncated(const PixelFile& file, std::size_t bytes, std::size_t found) {
  throw InputError("truncated-volume", in_file(file.path),
                   fmt::format("the header promises {} bytes of pixels, the file has {}", bytes, found),
                   "get a whole copy of the file, or correct the sizes in its header");
}

}  // namespace

void check_pixel_file(const PixelFile& file, std::size_t bytes, FloatPixels floats) {
  std::error_code error;
  if (!fs::is_regular_file(file.path, error)) {
    throw FileError(file.path, "does not exist or is no plain file, but is to hold the pixels",
                    "put it where the header says");
  }
  const std::uintmax_t length = fs::file_size(file.path, error);
  if (error) throw FileError(file.path, "cannot be looked at: " + error.message(), "check its permissions");
  const bool packed = file.packing != PixelFile::Packing::raw;
  if (file.packed_bytes > length - std::min<std::uintmax_t>(file.offset, length)) {
    throw_truncated(file, file.packed_bytes, static_cast<std::size_t>(length));
  }
  const std::size_t skip = packed ? 0 : std::min<std::size_t>(file.offset, length);
  const std::size_t most = packed ? length * limits::compression_ratio : length - skip;
  if (most < bytes) throw_truncated(file, bytes, static_cast<std::size_t>(length - skip));
  if (file.packing == PixelFile::Packing::other) return;
  if (!packed && floats.bytes_each == 0) return;

  PixelSink sink(file.path, file.unpack_from_start ? file.offset : 0, bytes, floats);
  if (packed) {
    Inflater inflater(file.path);
    std::size_t left = file.packed_bytes != 0 ? file.packed_bytes : static_cast<std::size_t>(length);
    for_each_piece(file.path, file.unpack_from_start ? 0 : file.offset, [&](Bytes piece) {
      piece = piece.first(std::min(piece.size(), left));
      left -= piece.size();
      return inflater.take(piece, sink) && left > 0;
    });
  } else {
    for_each_piece(file.path, file.offset, [&](Bytes piece) {
      sink.take(piece);
      return !sink.full();
    });
  }
  if (!sink.full()) throw_truncated(file, bytes, sink.taken());
}

}  // namespace odontoscope
