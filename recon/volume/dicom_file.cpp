#include "recon/volume/dicom_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "recon/core/limits.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_source.h"
#include "recon/volume/dicom_wanted.h"
#include "recon/volume/text_header.h"

namespace odontoscope {

namespace {

constexpr std::size_t preamble = 128;
constexpr std::string_view mark = "DICM";
constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint64_t item_head = 8;  // a tag and a length
constexpr std::uint32_t storage_class = dicom::tag(0x0002, 0x0002), transfer_syntax = dicom::tag(0x0002, 0x0010);
constexpr std::uint32_t item_tag = dicom::tag(0xfffe, 0xe000), item_end = dicom::tag(0xfffe, 0xe00d),
                        sequence_end = dicom::tag(0xfffe, 0xe0dd);

/// A tag with the length of its value; the value comes next.
struct Head {
  std::uint32_t tag = 0;
  std::array<char, 2> vr{};
  std::uint32_t length = 0;
  bool is(std::string_view name) const { return std::string_view(vr.data(), vr.size()) == name; }
  bool is_undefined() const { return length == undefined_length; }
};

constexpr std::array<std::string_view, 13> long_ones{"OB", "OW", "OF", "OD", "OL", "OV", "SQ",
                                                     "UC", "UR", "UT", "UN", "SV", "UV"};
constexpr std::array<std::string_view, 21> short_ones{"AE", "AS", "AT", "CS", "DA", "DS", "DT", "FL", "FD", "IS", "LO",
                                                      "LT", "PN", "SH", "SL", "SS", "ST", "TM", "UI", "UL", "US"};

template <class Names>
bool is_one_of(std::string_view vr, const Names& names) {
  return std::find(names.begin(), names.end(), vr) != names.end();
}

template <class Source>
class Walk {
 public:
  Walk(Source& source, DicomFile& file) : source_(source), file_(file) {}

  /// The data set from `at` on; stops behind the pixels, after which nothing is wanted.
  void run(std::uint64_t at) {
    at_ = at;
    const std::uint64_t end = source_.size();
    while (at_ < end && file_.pixels.tag == 0) {
      const Head head = next(file_.implicit_vr, end);
      if (dicom::is_pixels(head.tag))
        take_pixels(head, end);
      else
        take(head, file_.implicit_vr, end, 0, file_.data);
    }
  }

  /// Group 2, always explicit and little-endian. Returns where the data set begins.
  std::uint64_t run_meta_information(std::uint64_t at) {
    at_ = at;
    const std::uint64_t end = source_.size();
    while (at_ + 4 <= end) {
      const std::uint64_t start = at_;
      if (number(2, end) != 0x0002) {
        at_ = start;
        break;
      }
      at_ = start;
      const Head head = next(false, end);
      if (head.is_undefined()) refuse("its meta information has an element without length");
      if (head.tag == transfer_syntax)
        file_.syntax = padded_text(value(head, end));
      else if (head.tag == storage_class)
        file_.storage_class = padded_text(value(head, end));
      else
        skip(head.length, end);
    }
    return at_;
  }

  void be_big_endian() { big_endian_ = true; }

 private:
  Place place() const {
    Place place = in_file(file_.path);
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

  void require(std::uint64_t count, std::uint64_t end) const {
    if (at_ > end || count > end - at_) throw_truncated();
  }

  void skip(std::uint64_t count, std::uint64_t end) {
    require(count, end);
    at_ += count;
  }

  void take_bytes(char* to, std::size_t count, std::uint64_t end) {
    require(count, end);
    if (!source_.read(at_, to, count)) throw_truncated();
    at_ += count;
  }

  std::uint32_t number(std::size_t bytes, std::uint64_t end) {
    std::array<char, 4> raw{};
    take_bytes(raw.data(), bytes, end);
    if (big_endian_) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(bytes));
    std::uint32_t value = 0;
    for (std::size_t n = bytes; n-- > 0;) value = value << 8 | static_cast<unsigned char>(raw[n]);
    return value;
  }

  Head next(bool implicit_vr, std::uint64_t end) {
    Head head;
    const std::uint32_t group = number(2, end);
    head.tag = dicom::tag(group, number(2, end));
    if (implicit_vr || group == 0xfffe) {
      head.length = number(4, end);
      return head;
    }
    take_bytes(head.vr.data(), 2, end);
    const std::string_view vr(head.vr.data(), 2);
    if (is_one_of(vr, long_ones)) {
      skip(2, end);
      head.length = number(4, end);
    } else if (is_one_of(vr, short_ones)) {
      head.length = number(2, end);
    } else {
      refuse(fmt::format("element ({:04x},{:04x}) has no value representation of DICOM", group, head.tag & 0xffff));
    }
    return head;
  }

  std::string value(const Head& head, std::uint64_t end) {
    if (head.length > limits::dicom_value)
      refuse(fmt::format("element ({:04x},{:04x}) is too long", head.tag >> 16, head.tag & 0xffff));
    require(head.length, end);
    std::string bytes(head.length, '\0');
    take_bytes(bytes.data(), bytes.size(), end);
    return bytes;
  }

  static std::string padded_text(std::string text) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    return text;
  }

  /// One element into `data` if it is wanted; whatever it is, walked through.
  void take(const Head& head, bool implicit_vr, std::uint64_t end, int depth, DicomDataSet& data) {
    if (dicom::is_pixels(head.tag) && head.is_undefined()) return skip_fragments(implicit_vr, end);  // of an icon
    // Of unknown representation and length: a sequence in implicit coding, says PS3.5, 6.2.2.
    const bool inner_implicit = implicit_vr || (head.is("UN") && head.is_undefined());
    const bool wanted_sequence = !in_records_ && is_wanted_sequence(head.tag);
    const bool is_sequence =
        head.is("SQ") || head.is_undefined() || (wanted_sequence && (implicit_vr || head.is("UN")));
    if (!head.is_undefined() && head.length % 2 != 0) file_.odd_lengths = true;
    if (is_sequence) refuse_odd(head);
    if (!is_sequence) {
      if (in_records_ ? !dicom::is_wanted_of_record(head.tag) : !dicom::is_wanted(head.tag))
        return skip(head.length, end);
      keep({head.tag, head.vr, big_endian_, value(head, end), {}}, data);
      return;
    }
    DicomElement sequence{head.tag, head.vr, big_endian_, {}, {}};
    std::vector<DicomDataSet>* items = wanted_sequence ? &sequence.items : nullptr;
    const bool of_records = wanted_sequence && head.tag == dicom::records;
    in_records_ = in_records_ || of_records;
    if (head.is_undefined()) {
      take_items(inner_implicit, end, depth + 1, items);
    } else {
      require(head.length, end);
      const std::uint64_t own_end = at_ + head.length;
      while (at_ < own_end) take_item(next(inner_implicit, own_end), inner_implicit, own_end, depth + 1, items);
    }
    if (of_records) in_records_ = false;
    if (wanted_sequence) keep(std::move(sequence), data);
  }

  /// PS3.5, 7.1.1: lengths are even. A value that is not may be a careless writer's; where a whole item is not, its end
  /// and all that follows may be misread.
  void refuse_odd(const Head& head) const {
    if (head.is_undefined() || head.length % 2 == 0) return;
    refuse(fmt::format(
        "an item or sequence has an odd number of bytes ({}), which DICOM does not allow: where it ends is not sure",
        head.length));
  }

  static bool is_wanted_sequence(std::uint32_t tag) {
    if (tag == dicom::records || tag == dicom::segments || tag == dicom::segment_identification ||
        tag == dicom::referenced_series || tag == dicom::referenced_instances)
      return true;
    return tag == dicom::frame_content || tag == dicom::plane_position || tag == dicom::plane_orientation ||
           tag == dicom::modality_table || tag == dicom::pixel_measures || tag == dicom::value_transformation ||
           tag == dicom::shared_groups || tag == dicom::frame_groups;
  }

  void keep(DicomElement element, DicomDataSet& data) {
    if (++kept_ > limits::dicom_elements)
      refuse(fmt::format("it has more than {} elements about its place", limits::dicom_elements));
    data.elements.push_back(std::move(element));
  }

  void take_items(bool implicit_vr, std::uint64_t end, int depth, std::vector<DicomDataSet>* items) {
    for (;;) {
      const Head head = next(implicit_vr, end);
      if (head.tag == sequence_end) return;
      take_item(head, implicit_vr, end, depth, items);
    }
  }

  void take_item(const Head& head, bool implicit_vr, std::uint64_t end, int depth, std::vector<DicomDataSet>* items) {
    if (head.tag != item_tag) refuse("a sequence holds something else than items");
    refuse_odd(head);
    if (depth > limits::dicom_nesting)
      refuse(fmt::format("sequences lie in each other more than {} deep", limits::dicom_nesting));
    if (!head.is_undefined()) require(head.length, end);
    const std::uint64_t own_end = head.is_undefined() ? end : at_ + head.length;
    DicomDataSet unwanted;
    if (items != nullptr && ++kept_ > limits::dicom_elements) refuse("it has too many items about its place");
    DicomDataSet& data = items == nullptr ? unwanted : items->emplace_back();
    data.at = at_ - item_head;
    while (head.is_undefined() || at_ < own_end) {
      const Head inner = next(implicit_vr, own_end);
      if (inner.tag == item_end && head.is_undefined()) return;
      // What an item that is not wanted holds is not wanted either.
      if (items == nullptr) unwanted.elements.clear();
      take(inner, implicit_vr, own_end, depth, data);
    }
  }

  void skip_fragments(bool implicit_vr, std::uint64_t end) {
    for (;;) {
      const Head part = next(implicit_vr, end);
      if (part.tag == sequence_end) return;
      if (part.tag != item_tag || part.is_undefined()) refuse("its compressed pixels are not in items");
      skip(part.length, end);
    }
  }

  void take_pixels(const Head& head, std::uint64_t end) {
    DicomPixels& pixels = file_.pixels;
    if (!head.is_undefined()) {
      pixels.at = at_;
      pixels.length = head.length;
      pixels.words = head.is("OW");
      skip(head.length, end);
      pixels.tag = head.tag;
      return;
    }
    pixels.encapsulated = true;
    for (bool first = true;; first = false) {
      const Head part = next(file_.implicit_vr, end);
      if (part.tag == sequence_end) break;
      if (part.tag != item_tag || part.is_undefined()) refuse("its compressed pixels are not in items");
      if (first) {
        read_offsets(part, end);
        continue;
      }
      if (++kept_ > limits::dicom_elements) refuse("its compressed pixels are in too many pieces");
      pixels.fragments.push_back({at_, part.length});
      skip(part.length, end);
    }
    pixels.tag = head.tag;
  }

  void read_offsets(const Head& table, std::uint64_t end) {
    const std::string bytes = value(table, end);
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
      std::uint32_t offset = 0;
      for (std::size_t n = 4; n-- > 0;) offset = offset << 8 | static_cast<unsigned char>(bytes[at + n]);
      file_.pixels.offset_table.push_back(offset);
    }
  }

  Source& source_;
  DicomFile& file_;
  std::uint64_t at_ = 0;
  std::size_t kept_ = 0;
  bool big_endian_ = false, in_records_ = false;
};

/// The first bytes of an object without preamble: a short element of group 8, as every one begins with.
bool begins_bare(std::string_view head) {
  if (head.size() < 8) return false;
  const auto byte = [head](std::size_t n) { return static_cast<unsigned char>(head[n]); };
  const bool of_group = byte(1) == 0 && byte(3) == 0 && (byte(0) == 0x08 || byte(0) == 0x02) && byte(2) <= 0x20;
  if (!of_group) return false;
  const std::string_view vr = head.substr(4, 2);
  if (is_one_of(vr, short_ones) || is_one_of(vr, long_ones)) return true;
  constexpr unsigned longest = 128;
  return byte(5) == 0 && byte(6) == 0 && byte(7) == 0 && byte(4) <= longest && byte(4) % 2 == 0;
}

std::string head_of(const std::string& path, std::size_t count) {
  std::string head(count, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return head;
}

bool has_mark(std::string_view head) {
  return head.size() >= preamble + mark.size() && head.substr(preamble, mark.size()) == mark;
}

/// Everything from `at` on, unpacked.
std::string inflated(const std::string& path, std::uint64_t at) {
  ByteSource packed(path, static_cast<std::size_t>(at), ByteSource::Packing::bare);
  std::string bytes;
  for (;;) {
    constexpr std::size_t piece = 1u << 18;
    const std::size_t before = bytes.size();
    if (before > limits::deflated_bytes) {
      throw InputError("too-well-packed", in_file(path),
                       fmt::format("it unpacks to more than {} bytes", limits::deflated_bytes), "store it unpacked");
    }
    bytes.resize(before + piece);
    const std::size_t got = packed.read(bytes.data() + before, piece);
    bytes.resize(before + got);
    if (got < piece) return bytes;
  }
}

void understand_syntax(DicomFile& file) {
  constexpr std::string_view implicit_little = "1.2.840.10008.1.2", deflated = "1.2.840.10008.1.2.1.99",
                             big_endian = "1.2.840.10008.1.2.2";
  file.implicit_vr = file.syntax == implicit_little;
  file.big_endian = file.syntax == big_endian;
  file.deflated = file.syntax == deflated;
}

template <class Source>
void walk(Source& source, DicomFile& file, std::string_view head) {
  Walk<Source> meta(source, file);
  const std::uint64_t begin = file.has_preamble ? preamble + mark.size() : 0;
  std::uint64_t at = begin;
  const bool has_meta = file.has_preamble || head.starts_with(std::string_view("\2\0", 2));
  if (has_meta) at = meta.run_meta_information(begin);
  if (file.syntax.empty() && has_meta) {
    Place place = in_file(file.path);
    place.byte = static_cast<std::size_t>(at);
    throw InputError("unreadable-volume", place, "it names no transfer syntax",
                     "convert the series with the program that wrote it");
  }
  understand_syntax(file);
  if (!has_meta)
    file.implicit_vr = !is_one_of(head.substr(4, 2), short_ones) && !is_one_of(head.substr(4, 2), long_ones);
  if (file.deflated) {
    source.hold(inflated(file.path, at));
    at = 0;
  }
  Walk<Source> data(source, file);
  if (file.big_endian) data.be_big_endian();
  data.run(at);
}

}  // namespace

DicomBytes::DicomBytes(const DicomFile& file) : source_(std::make_unique<DicomSource>(file.path)), path_(file.path) {
  if (!file.deflated) return;
  DicomFile again;
  again.path = file.path;
  again.has_preamble = file.has_preamble;
  walk(*source_, again, head_of(file.path, preamble + mark.size()));
}

DicomBytes::~DicomBytes() = default;

void DicomBytes::read(std::uint64_t at, char* to, std::size_t count) {
  if (source_->read(at, to, count)) return;
  Place place = in_file(path_);
  place.byte = static_cast<std::size_t>(at);
  throw InputError("truncated-volume", place, "its pixels reach beyond its end", "get a whole copy of the file");
}

DicomFile read_dicom_file(const std::string& path) {
  check_plain_file(path);
  DicomFile file;
  file.path = path;
  const std::string head = head_of(path, preamble + mark.size());
  file.has_preamble = has_mark(head);
  try {
    DicomSource source(path);
    walk(source, file, head);
  } catch (const InputError& error) {
    file.trouble = error;
  }
  return file;
}

bool looks_like_dicom(const std::string& path) {
  const std::string head = head_of(path, preamble + mark.size());
  return has_mark(head) || begins_bare(head);
}

}  // namespace odontoscope
