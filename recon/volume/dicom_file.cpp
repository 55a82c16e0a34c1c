#include "recon/volume/dicom_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "recon/core/limits.h"
#include "recon/dicom/dicom_walk.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_wanted.h"
#include "recon/volume/text_header.h"

namespace odontoscope {

namespace {

constexpr std::size_t preamble = 128;
constexpr std::string_view mark = "DICM";
constexpr std::uint64_t item_head = 8;  // a tag and a length
constexpr DicomManner of_images{.truncated = "truncated-volume",
                                .unreadable = "unreadable-volume",
                                .get_whole = "get a whole copy of the file",
                                .export_again = "convert the series with the program that wrote it"};

std::string padded_text(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

/// Makes the tree of what is wanted.
class ImageWalk {
 public:
  ImageWalk(DicomSource& source, DicomFile& file) : walk_(source, file.path, of_images), file_(file) {}

  /// The data set from `at` on; stops behind the pixels, after which nothing is wanted.
  void run(std::uint64_t at) {
    walk_.go_to(at);
    if (file_.big_endian) walk_.be_big_endian();
    const std::uint64_t end = walk_.size();
    while (walk_.at() < end && file_.pixels.tag == 0) {
      const DicomHead head = walk_.next(file_.implicit_vr, end);
      if (dicom::is_pixels(head.tag))
        take_pixels(head, end);
      else
        take(head, file_.implicit_vr, end, 0, file_.data);
      file_.odd_lengths = walk_.odd_lengths();
    }
  }

  /// Group 2. Returns where the data set begins.
  std::uint64_t run_meta_information(std::uint64_t at) {
    walk_.go_to(at);
    walk_.meta_information([this](const DicomHead& head) {
      if (head.is_undefined()) walk_.refuse("its meta information has an element without length");
      if (head.tag == dicom::transfer_syntax)
        file_.syntax = padded_text(walk_.value(head, walk_.size()));
      else if (head.tag == dicom::storage_class)
        file_.storage_class = padded_text(walk_.value(head, walk_.size()));
      else
        walk_.skip(head.length, walk_.size());
    });
    return walk_.at();
  }

 private:
  /// One element into `data` if it is wanted; whatever it is, walked through.
  void take(const DicomHead& head, bool implicit_vr, std::uint64_t end, int depth, DicomDataSet& data) {
    const bool wanted_sequence = !in_records_ && is_wanted_sequence(head.tag);
    const bool is_sequence =
        head.is("SQ") || head.is_undefined() || (wanted_sequence && (implicit_vr || head.is("UN")));
    if (is_sequence && wanted_sequence) return take_items(head, implicit_vr, end, depth, data);
    const bool wanted = in_records_ ? dicom::is_wanted_of_record(head.tag) : dicom::is_wanted(head.tag);
    if (is_sequence || !wanted) return walk_.pass(head, implicit_vr, end, depth);
    walk_.note_length(head);
    keep({head.tag, head.vr, walk_.is_big_endian(), walk_.value(head, end), {}}, data);
  }

  void take_items(const DicomHead& head, bool implicit_vr, std::uint64_t end, int depth, DicomDataSet& data) {
    DicomElement sequence{head.tag, head.vr, walk_.is_big_endian(), {}, {}};
    const bool of_records = head.tag == dicom::records;
    in_records_ = of_records;
    walk_.items(head, implicit_vr, end, depth + 1,
                [&](const DicomHead& item, bool implicit_items, std::uint64_t own_end) {
                  if (++kept_ > limits::dicom_elements) walk_.refuse("it has too many items about its place");
                  DicomDataSet& inside = sequence.items.emplace_back();
                  inside.at = walk_.at() - item_head;
                  walk_.elements(item, implicit_items, own_end, [&](const DicomHead& inner, std::uint64_t item_end) {
                    take(inner, implicit_items, item_end, depth + 1, inside);
                  });
                });
    if (of_records) in_records_ = false;
    keep(std::move(sequence), data);
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
      walk_.refuse(fmt::format("it has more than {} elements about its place", limits::dicom_elements));
    data.elements.push_back(std::move(element));
  }

  void take_pixels(const DicomHead& head, std::uint64_t end) {
    DicomPixels& pixels = file_.pixels;
    if (!head.is_undefined()) {
      pixels.at = walk_.at();
      pixels.length = head.length;
      pixels.words = head.is("OW");
      walk_.skip(head.length, end);
      pixels.tag = head.tag;
      return;
    }
    pixels.encapsulated = true;
    bool first = true;
    walk_.fragments(file_.implicit_vr, end, [&](const DicomHead& part) {
      if (std::exchange(first, false)) return read_offsets(walk_.value(part, end));
      if (++kept_ > limits::dicom_elements) walk_.refuse("its compressed pixels are in too many pieces");
      pixels.fragments.push_back({walk_.at(), part.length});
      walk_.skip(part.length, end);
    });
    pixels.tag = head.tag;
  }

  void read_offsets(std::string_view bytes) {
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
      std::uint32_t offset = 0;
      for (std::size_t n = 4; n-- > 0;) offset = offset << 8 | static_cast<unsigned char>(bytes[at + n]);
      file_.pixels.offset_table.push_back(offset);
    }
  }

  DicomWalk walk_;
  DicomFile& file_;
  std::size_t kept_ = 0;
  bool in_records_ = false;
};

/// The first bytes of an object without preamble: a short element of group 8, as every one begins with.
bool begins_bare(std::string_view head) {
  if (head.size() < 8) return false;
  const auto byte = [head](std::size_t n) { return static_cast<unsigned char>(head[n]); };
  const bool of_group = byte(1) == 0 && byte(3) == 0 && (byte(0) == 0x08 || byte(0) == 0x02) && byte(2) <= 0x20;
  if (!of_group) return false;
  const std::string_view vr = head.substr(4, 2);
  if (is_dicom_representation(vr)) return true;
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

void walk(DicomSource& source, DicomFile& file, std::string_view head) {
  const std::uint64_t begin = file.has_preamble ? preamble + mark.size() : 0;
  std::uint64_t at = begin;
  const bool has_meta = file.has_preamble || head.starts_with(std::string_view("\2\0", 2));
  if (has_meta) at = ImageWalk(source, file).run_meta_information(begin);
  if (file.syntax.empty() && has_meta) {
    Place place = in_file(file.path);
    place.byte = static_cast<std::size_t>(at);
    throw InputError("unreadable-volume", place, "it names no transfer syntax",
                     "convert the series with the program that wrote it");
  }
  understand_syntax(file);
  if (!has_meta) file.implicit_vr = !is_dicom_representation(head.substr(4, 2));
  if (file.deflated) {
    source.hold(inflated(file.path, at));
    at = 0;
  }
  ImageWalk(source, file).run(at);
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
