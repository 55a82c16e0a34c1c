#include "recon/volume/pixel_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/free_memory.h"
#include "recon/core/limits.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/text_header.h"

namespace odontoscope {
namespace {

using Encoding = PixelFiles::Encoding;

[[noreturn]] void throw_truncated(const std::string& file, const std::string& wanted, const std::string& found) {
  throw InputError("truncated-volume", in_file(file),
                   fmt::format("the header promises {}, the file has {}", wanted, found),
                   "get a whole copy of the file, or correct the sizes in its header");
}

template <class T>
void convert_as(bool swapped, double slope, double intercept, const char* raw, std::size_t count, float* to) {
  const bool scaled = slope != 1 || intercept != 0;
  for (std::size_t n = 0; n < count; ++n) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, raw + n * sizeof(T), sizeof(T));
    if (swapped) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    to[n] = static_cast<float>(scaled ? slope * static_cast<double>(value) + intercept : static_cast<double>(value));
  }
}

ByteSource opened(const PixelFiles& files, const std::string& path, std::size_t bytes) {
  if (files.packed_whole) {
    ByteSource source(path, 0, ByteSource::Packing::zlib_or_gzip);
    source.skip(files.offset);
    return source;
  }
  std::size_t offset = files.offset;
  if (files.at_end) {
    const std::size_t length = check_plain_file(path);
    if (length < bytes) throw_truncated(path, fmt::format("{} bytes of pixels", bytes), fmt::format("{}", length));
    offset = length - bytes;
  }
  if (files.line_skip == 0) {
    const bool packed = files.encoding == Encoding::deflate;
    return ByteSource(path, offset, packed ? ByteSource::Packing::zlib_or_gzip : ByteSource::Packing::none,
                      files.packed_bytes == 0 ? ByteSource::all : files.packed_bytes);
  }
  // Lines are skipped in the file as it lies, and what is behind them may be packed.
  ByteSource lines(path, offset);
  std::size_t skipped = 0;
  for (std::size_t n = 0; n < files.line_skip; ++n) {
    for (char c = 0; c != '\n' && lines.next(c);) ++skipped;
  }
  PixelFiles rest = files;
  rest.offset = offset + skipped;
  rest.line_skip = 0;
  return opened(rest, path, bytes);
}

/// Raw bytes of pixels whatever they are written as.
class Decoder {
 public:
  Decoder(const PixelFiles& files, const std::string& path, std::size_t bytes)
      : source_(opened(files, path, bytes)), path_(path), encoding_(files.encoding) {
    source_.skip(files.byte_skip);
  }

  std::size_t read(char* to, std::size_t count) {
    if (encoding_ != Encoding::hex) return source_.read(to, count);
    std::size_t done = 0;
    for (int high, low; done < count && (high = digit()) >= 0 && (low = digit()) >= 0;)
      to[done++] = static_cast<char>(high * 16 + low);
    return done;
  }

  /// False at the end.
  bool number(double& value) {
    const auto is_blank = [](char c) { return c == ' ' || c == ',' || (c >= '\t' && c <= '\r'); };
    char c = ' ';
    while (is_blank(c)) {
      if (!source_.next(c)) return false;
    }
    word_.clear();
    do {
      word_ += c;
      if (word_.size() > limits::quoted_length) break;
    } while (source_.next(c) && !is_blank(c));
    if (!number_of(word_, value)) {
      throw InputError("damaged-volume", in_file(path_), "its pixels are not written as numbers",
                       "get a whole copy of the file");
    }
    return true;
  }

 private:
  int digit() {
    for (char c; source_.next(c);) {
      if (c >= '0' && c <= '9') return c - '0';
      if (c >= 'a' && c <= 'f') return c - 'a' + 10;
      if (c >= 'A' && c <= 'F') return c - 'A' + 10;
      if (c != ' ' && (c < '\t' || c > '\r')) {
        throw InputError("damaged-volume", in_file(path_), "its pixels are not written as hexadecimal digits",
                         "get a whole copy of the file");
      }
    }
    return -1;
  }

  ByteSource source_;
  std::string path_, word_;
  Encoding encoding_;
};

using Visit = std::function<void(const float* values, std::size_t count)>;

constexpr std::size_t pixels_at_once = 1u << 16;

void visit_texts(Decoder& decoder, const PixelFiles& files, const std::string& path, std::size_t count,
                 const Visit& visit) {
  std::vector<float> some;
  for (std::size_t n = 0; n < count; ++n) {
    double value = 0;
    if (!decoder.number(value)) throw_truncated(path, fmt::format("{} numbers", count), fmt::format("{}", n));
    some.push_back(static_cast<float>(files.slope * value + files.intercept));
    if (some.size() < pixels_at_once && n + 1 < count) continue;
    visit(some.data(), some.size());
    some.clear();
  }
}

void visit_bytes(Decoder& decoder, const PixelFiles& files, const std::string& path, std::size_t count,
                 const Visit& visit) {
  const std::size_t each = bytes_of(files.type);
  std::vector<char> raw(pixels_at_once * each);
  std::vector<float> values(pixels_at_once);
  for (std::size_t n = 0; n < count;) {
    const std::size_t some = std::min(pixels_at_once, count - n);
    const std::size_t got = decoder.read(raw.data(), some * each);
    if (got < some * each)
      throw_truncated(path, fmt::format("{} bytes of pixels", count * each), fmt::format("{}", n * each + got));
    convert_pixels(files.type, files.swapped, files.slope, files.intercept, raw.data(), some, values.data());
    visit(values.data(), some);
    n += some;
  }
}

/// What the pixels of one file take, and at most come from.
void check_file(const PixelFiles& files, const std::string& path, std::size_t count) {
  const std::size_t length = check_plain_file(path), bytes = count * bytes_of(files.type);
  const bool packed = files.packed_whole || files.encoding == Encoding::deflate;
  if (files.packed_bytes > length - std::min(files.offset, length)) {
    throw_truncated(path, fmt::format("{} packed bytes", files.packed_bytes), fmt::format("{}", length));
  }
  const std::size_t before = files.at_end || files.packed_whole ? 0 : std::min(files.offset, length);
  const std::size_t there = length - before;
  std::size_t most = there;
  if (packed)
    most = there > ByteSource::all / limits::compression_ratio ? ByteSource::all : there * limits::compression_ratio;
  else if (files.encoding == Encoding::hex)
    most = there / 2;
  else if (files.encoding == Encoding::text)
    most = (there + 1) / 2 * bytes_of(files.type);
  if (most < bytes)
    throw_truncated(path, fmt::format("{} bytes of pixels", bytes), fmt::format("{}", packed ? there : most));
  const bool large = count > limits::plausible_voxels;
  if (packed && large && bytes / limits::suspicious_ratio > there) {
    throw InputError(
        "too-well-packed", in_file(path),
        fmt::format("its {} bytes would become {} voxels, more than {} bytes from each one: no scan packs like that",
                    there, count, limits::suspicious_ratio),
        "crop it, or store it unpacked if it is really so");
  }
}

}  // namespace

std::size_t bytes_of(PixelType type) {
  switch (type) {
    case PixelType::int8:
    case PixelType::uint8:
      return 1;
    case PixelType::int16:
    case PixelType::uint16:
      return 2;
    case PixelType::int32:
    case PixelType::uint32:
    case PixelType::float32:
      return 4;
    case PixelType::int64:
    case PixelType::uint64:
    case PixelType::float64:
      return 8;
  }
  throw InternalError("a pixel type that is none");
}

void convert_pixels(PixelType type, bool swapped, double slope, double intercept, const char* raw, std::size_t count,
                    float* to) {
  switch (type) {
    case PixelType::int8:
      return convert_as<std::int8_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::uint8:
      return convert_as<std::uint8_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::int16:
      return convert_as<std::int16_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::uint16:
      return convert_as<std::uint16_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::int32:
      return convert_as<std::int32_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::uint32:
      return convert_as<std::uint32_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::int64:
      return convert_as<std::int64_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::uint64:
      return convert_as<std::uint64_t>(swapped, slope, intercept, raw, count, to);
    case PixelType::float32:
      return convert_as<float>(swapped, slope, intercept, raw, count, to);
    case PixelType::float64:
      return convert_as<double>(swapped, slope, intercept, raw, count, to);
  }
}

void check_pixel_files(const PixelFiles& files, std::size_t count) {
  if (files.paths.empty()) throw InternalError("a volume without files");
  if (count % files.paths.size() != 0) {
    throw InputError("unreadable-volume", in_file(files.paths.front()),
                     fmt::format("{} voxels are to lie in {} files, which makes no whole number for each", count,
                                 files.paths.size()),
                     "correct the header's sizes or its list of files");
  }
  for (const std::string& path : files.paths) check_file(files, path, count / files.paths.size());
}

void for_each_run(const PixelFiles& files, std::size_t count, const Progress& progress,
                  const std::function<void(const float* values, std::size_t count)>& visit) {
  check_pixel_files(files, count);
  const std::size_t each = count / files.paths.size();
  std::size_t done = 0;
  for (const std::string& path : files.paths) {
    progress.check();
    progress.tell("read", static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(count, 1)));
    Decoder decoder(files, path, each * bytes_of(files.type));
    if (files.encoding == Encoding::text)
      visit_texts(decoder, files, path, each, visit);
    else
      visit_bytes(decoder, files, path, each, visit);
    done += each;
  }
}

std::vector<float> read_pixels(const PixelFiles& files, std::size_t count, const Progress& progress) {
  std::vector<float> values;
  for_each_run(files, count, progress, [&](const float* some, std::size_t how_many) {
    values.reserve(count);  // only as much of it is really taken as pixels come
    values.insert(values.end(), some, some + how_many);
  });
  return values;
}

void check_memory(const std::string& file, std::size_t voxels) {
  check_memory(file, static_cast<double>(voxels) * sizeof(float),
               "crop it to the tooth or resample it more coarsely (with another program, if this one cannot even read "
               "it), or use a larger machine");
}

}  // namespace odontoscope
