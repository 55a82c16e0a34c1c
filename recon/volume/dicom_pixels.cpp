#include "recon/volume/dicom_pixels.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <numeric>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/decode_apart.h"

namespace odontoscope {
namespace {

PixelType stored_type(const DicomImage& image) {
  if (image.file.pixels.tag == dicom::float_pixels) return PixelType::float32;
  if (image.file.pixels.tag == dicom::double_pixels) return PixelType::float64;
  if (image.bits_allocated == 8) return PixelType::uint8;
  return image.bits_allocated == 16 ? PixelType::uint16 : PixelType::uint32;
}

/// Of the bits that are allocated those that are stored count, the highest of them as a sign if there is one.
void convert(const DicomImage& image, const DicomFrame& frame, const char* raw, bool swapped, float* to) {
  const PixelType type = stored_type(image);
  const std::size_t count = image.pixels();
  if (type == PixelType::float32 || type == PixelType::float64)
    return convert_pixels(type, swapped, frame.slope, frame.intercept, raw, count, to);
  const std::size_t each = bytes_of(type);
  const unsigned low = image.high_bit + 1 - image.bits_stored;
  const std::uint64_t mask = (std::uint64_t{1} << image.bits_stored) - 1,
                      sign = std::uint64_t{1} << (image.bits_stored - 1);
  for (std::size_t n = 0; n < count; ++n) {
    std::uint64_t bits = 0;
    for (std::size_t b = 0; b < each; ++b) {
      const bool lowest_first = swapped != (std::endian::native == std::endian::little);
      const std::size_t at = lowest_first ? each - 1 - b : b;
      bits = bits << 8 | static_cast<unsigned char>(raw[n * each + at]);
    }
    bits = bits >> low & mask;
    const double value = image.is_signed && (bits & sign) != 0
                             ? static_cast<double>(bits) - static_cast<double>(mask) - 1
                             : static_cast<double>(bits);
    to[n] = static_cast<float>(frame.slope * value + frame.intercept);
  }
}

/// `count` bytes of plain pixels from `from` on. Words (VR OW) differ between byte orders within each word
/// (PS3.5, 6.2), whatever a pixel takes: they are turned, so that pixels are little-endian.
void read_plain(const DicomImage& image, DicomBytes& bytes, std::uint64_t from, std::size_t count, std::string& to) {
  const DicomPixels& pixels = image.file.pixels;
  to.resize(count);
  if (!image.file.big_endian || !pixels.words) return bytes.read(pixels.at + from, to.data(), count);
  const std::uint64_t first = from / 2 * 2, end = (from + count + 1) / 2 * 2;
  std::string pairs(static_cast<std::size_t>(end - first), '\0');
  bytes.read(pixels.at + first, pairs.data(), pairs.size());
  for (std::size_t n = 0; n < count; ++n) to[n] = pairs[static_cast<std::size_t>(from - first + n) ^ 1u];
}

/// Numbers of the first fragment of each frame, and one behind the last.
std::vector<std::size_t> first_fragments(const DicomImage& image) {
  const DicomPixels& pixels = image.file.pixels;
  const std::size_t frames = image.frames.size(), pieces = pixels.fragments.size();
  std::vector<std::size_t> first;
  if (frames == 1) return {0, pieces};
  if (pieces == frames) {
    first.resize(frames + 1);
    std::iota(first.begin(), first.end(), std::size_t{0});
    return first;
  }
  // Offsets count from the first fragment's item on; so do, alike, those between values.
  for (const std::uint32_t offset : pixels.offset_table) {
    const std::uint64_t at = pixels.fragments.front().at + offset;
    const auto found = std::lower_bound(pixels.fragments.begin(), pixels.fragments.end(), at,
                                        [](const auto& f, std::uint64_t x) { return f.at < x; });
    if (found == pixels.fragments.end() || found->at != at) break;
    const auto n = static_cast<std::size_t>(found - pixels.fragments.begin());
    if (!first.empty() && n <= first.back()) break;
    first.push_back(n);
  }
  if (first.size() != frames || first.front() != 0) {
    throw InputError("unreadable-volume", in_file(image.file.path),
                     "it does not tell which pieces of its compressed pixels make which frame",
                     "store it uncompressed, or with a table of offsets");
  }
  first.push_back(pieces);
  return first;
}

/// Reads the planes of one image after the other; what belongs to the file is looked up once for each.
class Reader {
 public:
  explicit Reader(const Progress& progress) : progress_(progress) {}

  std::vector<float> read(const std::vector<DicomPlane>& planes) {
    pixels_ = planes.front().image->pixels();
    std::vector<float> values;
    values.reserve(pixels_ * planes.size());
    for (const DicomPlane& plane : planes) {
      progress_.check();
      progress_.tell("read", static_cast<double>(values.size()) / static_cast<double>(pixels_ * planes.size()));
      if (plane.image->file.pixels.encapsulated) {
        // What is decoded in one go has one size.
        if (!planes_.empty() && planes_.back().image->bits_allocated != plane.image->bits_allocated) decode(values);
        collect(plane);
        values.resize(values.size() + pixels_);
        if (pending_bytes_ >= limits::decoding_batch) decode(values);
        continue;
      }
      decode(values);
      open(*plane.image);
      const std::size_t bytes = pixels_ * plane.image->bits_allocated / 8;
      read_plain(*plane.image, *bytes_, plane.frame * bytes, bytes, raw_);
      const bool big = plane.image->file.big_endian && !plane.image->file.pixels.words,
                 swapped = big != (std::endian::native == std::endian::big);
      values.resize(values.size() + pixels_);
      convert(*plane.image, plane.image->frames[plane.frame], raw_.data(), swapped,
              values.data() + values.size() - pixels_);
    }
    decode(values);
    return values;
  }

 private:
  void open(const DicomImage& image) {
    if (opened_ == &image) return;
    bytes_ = std::make_unique<DicomBytes>(image.file);
    if (image.file.pixels.encapsulated) first_ = first_fragments(image);
    opened_ = &image;
  }

  void collect(const DicomPlane& plane) {
    const DicomImage& image = *plane.image;
    if (!is_decodable(image.file.syntax)) {
      throw InputError("unreadable-volume", in_file(image.file.path),
                       fmt::format("its pixels are compressed as {}, which is not read here", image.file.syntax),
                       "store it uncompressed");
    }
    open(image);
    CompressedFrame frame{image.file.path,
                          image.file.syntax,
                          image.photometric,
                          static_cast<unsigned>(image.rows),
                          static_cast<unsigned>(image.columns),
                          image.bits_allocated,
                          image.bits_stored,
                          image.high_bit,
                          image.is_signed,
                          {}};
    for (std::size_t n = first_[plane.frame]; n < first_[plane.frame + 1]; ++n) {
      const DicomPixels::Fragment& piece = image.file.pixels.fragments[n];
      const std::size_t before = frame.bytes.size();
      frame.bytes.resize(before + piece.length);
      bytes_->read(piece.at, frame.bytes.data() + before, piece.length);
    }
    pending_bytes_ += frame.decoded_bytes() + frame.bytes.size();
    frames_.push_back(std::move(frame));
    planes_.push_back(plane);
  }

  /// The planes that were collected are the last of `values`.
  void decode(std::vector<float>& values) {
    if (frames_.empty()) return;
    const std::vector<std::string> decoded = decode_apart(frames_, progress_);
    float* to = values.data() + values.size() - frames_.size() * pixels_;
    for (std::size_t n = 0; n < planes_.size(); ++n, to += pixels_)
      convert(*planes_[n].image, planes_[n].image->frames[planes_[n].frame], decoded[n].data(), false, to);
    frames_.clear();
    planes_.clear();
    pending_bytes_ = 0;
  }

  const Progress& progress_;
  std::size_t pixels_ = 0;
  const DicomImage* opened_ = nullptr;
  std::unique_ptr<DicomBytes> bytes_;
  std::vector<std::size_t> first_;
  std::string raw_;
  std::vector<CompressedFrame> frames_;
  std::vector<DicomPlane> planes_;
  std::size_t pending_bytes_ = 0;
};

}  // namespace

/// Compressed frames that are few bytes and become more than a gigabyte are made to fill memory.
void check_plausible(const std::vector<DicomPlane>& planes) {
  const std::size_t voxels = planes.size() * planes.front().image->pixels();
  if (voxels <= limits::plausible_voxels) return;
  std::uint64_t packed = 0, plain = 0;
  const DicomImage* last = nullptr;
  for (const DicomPlane& plane : planes) {
    if (!plane.image->file.pixels.encapsulated) return;
    plain += plane.image->pixels() * plane.image->bits_allocated / 8;
    if (plane.image == last) continue;
    for (const DicomPixels::Fragment& piece : plane.image->file.pixels.fragments) packed += piece.length;
    last = plane.image;
  }
  if (packed == 0 || plain / packed <= limits::suspicious_ratio) return;
  throw InputError("too-well-packed", in_file(planes.front().image->file.path),
                   fmt::format("{} compressed bytes would become {} voxels: no scan packs like that", packed, voxels),
                   "crop it, or store it uncompressed");
}

void read_bits(const DicomImage& image, std::size_t frame, DicomBytes& bytes, std::vector<float>& to) {
  const std::uint64_t first = std::uint64_t{frame} * image.pixels(), end = first + image.pixels();
  std::string raw;
  read_plain(image, bytes, first / 8, static_cast<std::size_t>((end + 7) / 8 - first / 8), raw);
  to.resize(image.pixels());
  for (std::size_t n = 0; n < to.size(); ++n) {
    const std::uint64_t bit = first % 8 + n;
    to[n] = static_cast<float>(static_cast<unsigned char>(raw[bit / 8]) >> (bit % 8) & 1);
  }
}

std::vector<float> read_planes(const std::vector<DicomPlane>& planes, const Progress& progress) {
  check_plausible(planes);
  return Reader(progress).read(planes);
}

}  // namespace odontoscope
