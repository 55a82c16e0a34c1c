#pragma once
// Where the bytes of a DICOM file come from. Inner part of dicom_walk.h and of volume/dicom_file.h.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

namespace odontoscope {

/// Bytes at any place of a file, or of what lies unpacked in memory; read through a window, since most pieces are a few
/// bytes long.
class DicomSource {
 public:
  explicit DicomSource(const std::string& path) : in_(path, std::ios::binary) {
    in_.seekg(0, std::ios::end);
    size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(in_.tellg(), 0));
  }

  /// Borrowed: they must outlive it.
  explicit DicomSource(std::string_view bytes) : size_(bytes.size()), at_hand_(bytes) {}
  DicomSource(const DicomSource&) = delete;
  DicomSource& operator=(const DicomSource&) = delete;

  void hold(std::string unpacked) {
    window_ = std::move(unpacked);
    at_hand_ = window_;
    first_ = 0;
    size_ = window_.size();
    in_.close();
  }

  std::uint64_t size() const { return size_; }

  bool read(std::uint64_t at, char* to, std::size_t count) {
    if (at > size_ || count > size_ - at) return false;
    if (at < first_ || at + count > first_ + at_hand_.size()) {
      if (count >= piece) return read_plain(at, to, count);
      window_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(piece, size_ - at)));
      first_ = at;
      at_hand_ = {};
      if (!read_plain(at, window_.data(), window_.size())) return false;
      at_hand_ = window_;
    }
    std::memcpy(to, at_hand_.data() + (at - first_), count);
    return true;
  }

 private:
  static constexpr std::size_t piece = 1u << 14;

  bool read_plain(std::uint64_t at, char* to, std::size_t count) {
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(at));
    return static_cast<bool>(in_.read(to, static_cast<std::streamsize>(count)));
  }

  std::ifstream in_;
  std::uint64_t size_ = 0, first_ = 0;
  std::string window_;
  std::string_view at_hand_;  // from first_ on: the window, or all
};

}  // namespace odontoscope
