#include "recon/volume/byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

namespace odontoscope {

namespace fs = std::filesystem;

struct ByteSource::Unpacking {
  explicit Unpacking(Packing packing) {
    constexpr int window = 15, with_head = 32;
    if (inflateInit2(&stream, packing == Packing::bare ? -window : window + with_head) != Z_OK)
      throw InternalError("zlib does not start");
  }
  ~Unpacking() { inflateEnd(&stream); }
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;

  z_stream stream{};
  bool member_ended = false, over = false;
  std::vector<char> packed = std::vector<char>(1u << 16);
};

Place in_file(const std::string& file) {
  Place place;
  place.file = file;
  return place;
}

std::size_t check_plain_file(const std::string& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) throw FileError(file, "does not exist", "check the name");
  if (!fs::is_regular_file(status)) throw FileError(file, "is no plain file", "give a file of pixels");
  const std::uintmax_t length = fs::file_size(file, error);
  if (error) throw FileError(file, "cannot be looked at: " + error.message(), "check its permissions");
  return static_cast<std::size_t>(length);
}

bool is_gzip(const std::string& file) {
  std::array<char, 2> head{};
  std::ifstream in(file, std::ios::binary);
  return in.read(head.data(), head.size()) && head[0] == '\x1f' && head[1] == '\x8b';
}

ByteSource::ByteSource(const std::string& file, std::size_t offset, Packing packing, std::size_t packed_bytes)
    : file_(file), left_(packed_bytes), piece_(1u << 18) {
  check_plain_file(file);
  in_.open(file, std::ios::binary);
  if (!in_ || !in_.seekg(static_cast<std::streamoff>(offset)))
    throw FileError(file, "cannot be opened", "check its permissions");
  if (packing != Packing::none) unpacking_ = std::make_unique<Unpacking>(packing);
}

ByteSource::~ByteSource() = default;
ByteSource::ByteSource(ByteSource&&) noexcept = default;
ByteSource& ByteSource::operator=(ByteSource&&) noexcept = default;

std::size_t ByteSource::read(char* to, std::size_t count) {
  std::size_t done = 0;
  while (done < count) {
    if (at_ == filled_ && refill() == 0) break;
    const std::size_t some = std::min(count - done, filled_ - at_);
    std::memcpy(to + done, piece_.data() + at_, some);
    at_ += some;
    done += some;
  }
  return done;
}

std::size_t ByteSource::skip(std::size_t count) {
  std::size_t done = 0;
  while (done < count) {
    if (at_ == filled_ && refill() == 0) break;
    const std::size_t some = std::min(count - done, filled_ - at_);
    at_ += some;
    done += some;
  }
  return done;
}

/// The next piece; 0 at the end.
std::size_t ByteSource::refill() {
  const auto take = [this](std::vector<char>& into) {
    in_.read(into.data(), static_cast<std::streamsize>(std::min(into.size(), left_)));
    const auto got = static_cast<std::size_t>(in_.gcount());
    left_ -= got;
    return got;
  };
  at_ = filled_ = 0;
  if (!unpacking_) return filled_ = take(piece_);
  Unpacking& u = *unpacking_;
  u.stream.next_out = reinterpret_cast<Bytef*>(piece_.data());
  u.stream.avail_out = static_cast<uInt>(piece_.size());
  while (!u.over && u.stream.avail_out != 0) {
    if (u.stream.avail_in == 0) {
      u.stream.next_in = reinterpret_cast<Bytef*>(u.packed.data());
      u.stream.avail_in = static_cast<uInt>(take(u.packed));
      if (u.stream.avail_in == 0) break;
    }
    if (u.member_ended && inflateReset(&u.stream) != Z_OK) throw InternalError("zlib does not go on");
    const int code = inflate(&u.stream, Z_NO_FLUSH);
    if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) {
      u.over = u.member_ended;  // padding behind the last member
      if (u.over) break;
      throw InputError("damaged-volume", in_file(file_), "its compressed bytes cannot be unpacked",
                       "get a whole copy of the file");
    }
    u.member_ended = code == Z_STREAM_END;
  }
  return filled_ = piece_.size() - u.stream.avail_out;
}

}  // namespace odontoscope
