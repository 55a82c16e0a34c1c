#include "recon/volume/dicom_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

constexpr std::size_t preamble = 128;
constexpr std::string_view mark = "DICM";
constexpr std::uint32_t undefined_length = 0xffffffff;

constexpr std::uint32_t tag(std::uint32_t group, std::uint32_t element) { return group << 16 | element; }
constexpr std::uint32_t storage_class = tag(0x0002, 0x0002), transfer_syntax = tag(0x0002, 0x0010),
                        series_uid = tag(0x0020, 0x000e);
constexpr std::uint32_t samples_per_pixel = tag(0x0028, 0x0002), frames = tag(0x0028, 0x0008),
                        rows = tag(0x0028, 0x0010), columns = tag(0x0028, 0x0011), bits_allocated = tag(0x0028, 0x0100),
                        pixel_data = tag(0x7fe0, 0x0010);
constexpr std::uint32_t item = tag(0xfffe, 0xe000), item_end = tag(0xfffe, 0xe00d), sequence_end = tag(0xfffe, 0xe0dd);

/// Elements that GDCM reads without asking how they are represented.
struct Expected {
  std::uint32_t tag;
  std::string_view vr;
};
constexpr std::array<Expected, 19> expected_representations{{{samples_per_pixel, "US"},
                                                             {tag(0x0028, 0x0004), "CS"},
                                                             {tag(0x0028, 0x0006), "US"},
                                                             {frames, "IS"},
                                                             {rows, "US"},
                                                             {columns, "US"},
                                                             {tag(0x0028, 0x0030), "DS"},
                                                             {bits_allocated, "US"},
                                                             {tag(0x0028, 0x0101), "US"},
                                                             {tag(0x0028, 0x0102), "US"},
                                                             {tag(0x0028, 0x0103), "US"},
                                                             {tag(0x0028, 0x1052), "DS"},
                                                             {tag(0x0028, 0x1053), "DS"},
                                                             {tag(0x0018, 0x0050), "DS"},
                                                             {tag(0x0018, 0x0088), "DS"},
                                                             {tag(0x0018, 0x1164), "DS"},
                                                             {tag(0x0020, 0x0032), "DS"},
                                                             {tag(0x0020, 0x0037), "DS"},
                                                             {series_uid, "UI"}}};

/// Classes of objects that are slices or volumes, whole families of them (CT, MR, secondary capture, 3D X-ray, PET):
/// one without pixels has lost them.
constexpr std::array<std::string_view, 5> image_classes{"1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.4",
                                                        "1.2.840.10008.5.1.4.1.1.7", "1.2.840.10008.5.1.4.1.1.13.1",
                                                        "1.2.840.10008.5.1.4.1.1.128"};

bool is_image_class(std::string_view name) {
  return std::any_of(image_classes.begin(), image_classes.end(), [name](std::string_view family) {
    return name.starts_with(family) && (name.size() == family.size() || name[family.size()] == '.');
  });
}

enum class Coding { explicit_vr, implicit_vr };

/// A tag with the length of its value; the value comes next.
struct Element {
  std::uint32_t tag = 0;
  std::array<char, 2> vr{};  // zeros where it is implied
  std::uint32_t length = 0;
  bool is(std::string_view name) const { return std::string_view(vr.data(), vr.size()) == name; }
  bool is_undefined() const { return length == undefined_length; }
};

/// The file's bytes with nothing read beyond a given end.
class Source {
 public:
  explicit Source(const std::string& file) : file_(file), in_(file, std::ios::binary) {
    in_.seekg(0, std::ios::end);
    size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(in_.tellg(), 0));
    seek(0);
  }

  std::uint64_t at() const { return at_; }
  std::uint64_t size() const { return size_; }

  void seek(std::uint64_t to) {
    at_ = to;
    in_.seekg(static_cast<std::streamoff>(to));
  }

  std::string take(std::uint64_t count, std::uint64_t end) {
    require(count, end);
    std::string bytes(count, '\0');
    if (!in_.read(bytes.data(), static_cast<std::streamsize>(count))) throw_truncated();
    at_ += count;
    return bytes;
  }

  void require(std::uint64_t count, std::uint64_t end) const {
    if (count > end - std::min(at_, end)) throw_truncated();
  }

  std::uint32_t number(std::size_t bytes, std::uint64_t end) {
    const std::string raw = take(bytes, end);
    std::uint32_t value = 0;
    for (std::size_t n = bytes; n-- > 0;) value = value << 8 | static_cast<unsigned char>(raw[n]);
    return value;
  }

  Place place() const {
    Place place;
    place.file = file_;
    place.byte = static_cast<std::size_t>(at_);
    return place;
  }

  [[noreturn]] void refuse(const std::string& wrong) const {
    throw InputError("unreadable-volume", place(), wrong, "convert the series with the program that wrote it");
  }

  [[noreturn]] void throw_truncated() const {
    throw InputError("truncated-volume", place(), "an element reaches beyond the end of what holds it",
                     "get a whole copy of the file");
  }

 private:
  std::string file_;
  std::ifstream in_;
  std::uint64_t size_ = 0, at_ = 0;
};

/// What an image says of its pixels.
struct Pixels {
  std::uint64_t rows = 0, columns = 0, frames = 1, samples = 1, bits = 0;
  bool there = false, compressed = false;
  std::uint64_t length = 0;
};

class Walk {
 public:
  explicit Walk(const std::string& file) : source_(file) {}

  DicomHeader run() {
    source_.seek(preamble + mark.size());
    walk_meta_information();
    while (source_.at() < source_.size()) walk_top_element(next(coding_, source_.size()));
    check_pixels();
    return {pixels_.rows > 0, series_};
  }

 private:
  void walk_meta_information() {
    std::string syntax;
    while (source_.at() + 4 <= source_.size()) {
      const std::uint64_t start = source_.at();
      const bool of_meta = source_.number(2, source_.size()) == 0x0002;
      source_.seek(start);
      if (!of_meta) break;
      const Element element = next(Coding::explicit_vr, source_.size());
      if (element.is_undefined()) source_.refuse("its meta information has an element without length");
      source_.require(element.length, source_.size());
      if (element.tag == transfer_syntax) {
        syntax = text(element);
      } else if (element.tag == storage_class) {
        is_image_class_ = is_image_class(text(element));
      } else {
        skip(element);
      }
    }
    constexpr std::string_view implicit_little = "1.2.840.10008.1.2", deflated = "1.2.840.10008.1.2.1.99",
                               big_endian = "1.2.840.10008.1.2.2";
    if (syntax.empty()) source_.refuse("it names no transfer syntax");
    if (syntax == deflated || syntax == big_endian)
      source_.refuse(fmt::format("transfer syntax {} is not supported", syntax));
    coding_ = syntax == implicit_little ? Coding::implicit_vr : Coding::explicit_vr;
  }

  Element next(Coding coding, std::uint64_t end) {
    Element element;
    const std::uint32_t group = source_.number(2, end);
    element.tag = tag(group, source_.number(2, end));
    if (coding == Coding::implicit_vr || group == 0xfffe) {
      element.length = source_.number(4, end);
      return element;
    }
    const std::string vr = source_.take(2, end);
    std::copy(vr.begin(), vr.end(), element.vr.begin());
    constexpr std::array<std::string_view, 13> long_ones{"OB", "OW", "OF", "OD", "OL", "OV", "SQ",
                                                         "UC", "UR", "UT", "UN", "SV", "UV"};
    constexpr std::array<std::string_view, 21> short_ones{"AE", "AS", "AT", "CS", "DA", "DS", "DT",
                                                          "FL", "FD", "IS", "LO", "LT", "PN", "SH",
                                                          "SL", "SS", "ST", "TM", "UI", "UL", "US"};
    if (std::find(long_ones.begin(), long_ones.end(), vr) != long_ones.end()) {
      source_.take(2, end);
      element.length = source_.number(4, end);
    } else if (std::find(short_ones.begin(), short_ones.end(), vr) != short_ones.end()) {
      element.length = source_.number(2, end);
    } else {
      source_.refuse(
          fmt::format("element ({:04x},{:04x}) has no value representation of DICOM", group, element.tag & 0xffff));
    }
    return element;
  }

  void check_representation(const Element& element) const {
    if (coding_ == Coding::implicit_vr) return;
    for (const Expected& expected : expected_representations) {
      if (element.tag != expected.tag || element.is(expected.vr)) continue;
      source_.refuse(fmt::format("element ({:04x},{:04x}) is not represented as {}", element.tag >> 16,
                                 element.tag & 0xffff, expected.vr));
    }
  }

  void walk_top_element(const Element& element) {
    check_representation(element);
    if (!element.is_undefined()) source_.require(element.length, source_.size());
    switch (element.tag) {
      case series_uid:
        series_ = text(element);
        return;
      case rows:
        pixels_.rows = small_number(element);
        return;
      case columns:
        pixels_.columns = small_number(element);
        return;
      case samples_per_pixel:
        pixels_.samples = small_number(element);
        return;
      case bits_allocated:
        pixels_.bits = small_number(element);
        return;
      case frames:
        pixels_.frames = decimal(element);
        return;
      case pixel_data:
        pixels_.there = true;
        pixels_.compressed = element.is_undefined();
        pixels_.length = element.length;
        if (pixels_.compressed) return walk_fragments();
        return skip(element);
      default:
        return walk_value(element, coding_, source_.size(), 0);
    }
  }

  void walk_value(const Element& element, Coding coding, std::uint64_t end, int depth) {
    if (element.is_undefined()) {
      // Of unknown representation and length: a sequence in implicit coding, says PS3.5, 6.2.2.
      walk_items(element.is("UN") ? Coding::implicit_vr : coding, end, depth + 1);
    } else {
      source_.require(element.length, end);
      if (!element.is("SQ")) return skip(element);
      const std::uint64_t own_end = source_.at() + element.length;
      while (source_.at() < own_end) walk_item(next(coding, own_end), coding, own_end, depth + 1);
    }
  }

  void walk_items(Coding coding, std::uint64_t end, int depth) {
    for (;;) {
      const Element element = next(coding, end);
      if (element.tag == sequence_end) return;
      walk_item(element, coding, end, depth);
    }
  }

  void walk_item(const Element& element, Coding coding, std::uint64_t end, int depth) {
    if (element.tag != item) source_.refuse("a sequence holds something else than items");
    if (depth > limits::dicom_nesting)
      source_.refuse(fmt::format("sequences lie in each other more than {} deep", limits::dicom_nesting));
    if (!element.is_undefined()) source_.require(element.length, end);
    const std::uint64_t own_end = element.is_undefined() ? end : source_.at() + element.length;
    while (element.is_undefined() || source_.at() < own_end) {
      const Element inner = next(coding, own_end);
      if (inner.tag == item_end && element.is_undefined()) return;
      walk_value(inner, coding, own_end, depth);
    }
  }

  void walk_fragments() {
    for (;;) {
      const Element element = next(coding_, source_.size());
      if (element.tag == sequence_end) return;
      if (element.tag != item || element.is_undefined()) source_.refuse("its compressed pixels are not in items");
      source_.require(element.length, source_.size());
      skip(element);
    }
  }

  void skip(const Element& element) { source_.seek(source_.at() + element.length); }

  /// A short text without its padding.
  std::string text(const Element& element) {
    constexpr std::uint32_t longest_uid = 64;
    if (element.length > longest_uid + 1) source_.refuse("a name or number in it is too long");
    std::string value = source_.take(element.length, source_.size());
    while (!value.empty() && (value.back() == ' ' || value.back() == '\0')) value.pop_back();
    return value;
  }

  std::uint64_t small_number(const Element& element) {
    if (element.length != 2) source_.refuse("a size in it is no 16-bit number");
    return source_.number(2, source_.size());
  }

  std::uint64_t decimal(const Element& element) {
    const std::string value = text(element);
    const std::size_t first = std::min(value.find_first_not_of(' '), value.size());
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(value.data() + first, value.data() + value.size(), number);
    if (error != std::errc{} || number == 0) source_.refuse("its number of frames is no whole number");
    return number;
  }

  void check_pixels() const {
    if (pixels_.rows == 0 && !is_image_class_) return;
    if (pixels_.rows == 0 || !pixels_.there) {
      throw InputError("truncated-volume", source_.place(), "the image's pixels are missing",
                       "get a whole copy of the file");
    }
    if (pixels_.samples != 1) {
      throw InputError("not-scalar", source_.place(),
                       fmt::format("each pixel has {} numbers (a colour)", pixels_.samples),
                       "give a grey-scale series");
    }
    constexpr std::array<std::uint64_t, 4> whole_bytes{8, 16, 32, 64};
    if (std::find(whole_bytes.begin(), whole_bytes.end(), pixels_.bits) == whole_bytes.end()) {
      source_.refuse(fmt::format("its pixels have {} bits", pixels_.bits));
    }
    if (pixels_.columns == 0) source_.refuse("it has no columns");
    if (pixels_.compressed) return;
    // At most 2^16 * 2^16 * 2^32 * 2^16 * 2^16: in floating point, since it overflows 64 bits.
    const double needed = static_cast<double>(pixels_.rows * pixels_.columns) * static_cast<double>(pixels_.frames) *
                          static_cast<double>(pixels_.samples * pixels_.bits) / 8;
    if (static_cast<double>(pixels_.length) >= needed) return;
    throw InputError("truncated-volume", source_.place(),
                     fmt::format("{} rows of {} pixels need {:.0f} bytes, it has {}", pixels_.rows, pixels_.columns,
                                 needed, pixels_.length),
                     "get a whole copy of the file");
  }

  Source source_;
  Coding coding_ = Coding::explicit_vr;
  std::string series_;
  bool is_image_class_ = false;
  Pixels pixels_;
};

}  // namespace

DicomHeader read_dicom_header(const std::string& file) { return Walk(file).run(); }

bool is_dicom_file(const std::string& path) {
  std::array<char, preamble + mark.size()> head{};
  std::ifstream in(path, std::ios::binary);
  return in.read(head.data(), head.size()) && std::string_view(head.data() + preamble, mark.size()) == mark;
}

}  // namespace odontoscope
