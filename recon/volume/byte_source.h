#pragma once
// A file's bytes from front to back, unpacked where they are packed, a piece at a time: nothing is held or taken on a
// header's word. Inner part of read_volume.h.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "recon/core/error.h"

namespace odontoscope {

class ByteSource {
 public:
  /// `zlib_or_gzip` tells the two apart; several gzip members in a row are one stream. `bare` is deflate with neither's
  /// head.
  enum class Packing { none, zlib_or_gzip, bare };
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

  /// From `offset` on, of which at most `packed_bytes` are taken. Throws FileError unless it is a plain file that can
  /// be read.
  explicit ByteSource(const std::string& file, std::size_t offset = 0, Packing packing = Packing::none,
                      std::size_t packed_bytes = all);
  ~ByteSource();
  ByteSource(ByteSource&&) noexcept;
  ByteSource& operator=(ByteSource&&) noexcept;

  /// Fewer than `count` only at the end. Throws InputError damaged-volume where unpacking fails.
  std::size_t read(char* to, std::size_t count);
  /// How many were there to be passed over, up to `count`.
  std::size_t skip(std::size_t count);
  /// False at the end.
  bool next(char& byte) { return read(&byte, 1) == 1; }

 private:
  struct Unpacking;
  std::size_t refill();

  std::string file_;
  std::ifstream in_;
  std::size_t left_ = all;
  std::vector<char> piece_;
  std::size_t at_ = 0, filled_ = 0;
  std::unique_ptr<Unpacking> unpacking_;
};

/// Throws FileError if `file` is missing, no plain file (pipes and devices never end) or cannot be opened. Returns its
/// length.
std::size_t check_plain_file(const std::string& file);

/// Does it begin as gzip does?
bool is_gzip(const std::string& file);

/// A place that knows its file alone.
Place in_file(const std::string& file);

}  // namespace odontoscope
