#pragma once
// The elements of a DICOM file one after the other, each checked to lie within what holds it. What to keep of them is
// up to those who walk: volumes build trees (volume/dicom_file.h), structure sets are asked (exchange/dicom_set.h).
// By code of our own: the libraries that know DICOM end the program on some broken files.
//
// DICOM PS3.5, section 7: explicit and implicit, little-endian and big-endian.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "recon/core/error.h"
#include "recon/dicom/dicom_source.h"
#include "recon/dicom/dicom_tags.h"

namespace odontoscope {

/// A tag with the length of its value; the value comes next.
struct DicomHead {
  std::uint32_t tag = 0;
  std::array<char, 2> vr{};  // zeros where it is implied
  std::uint32_t length = 0;
  bool is(std::string_view name) const { return std::string_view(vr.data(), vr.size()) == name; }
  bool is_undefined() const { return length == 0xffffffff; }
};

/// Does PS3.5 name this value representation?
bool is_dicom_representation(std::string_view vr);

/// How it is walked, and what faults are called.
struct DicomManner {
  std::string_view truncated, unreadable;    // causes of InputErrors
  std::string_view get_whole, export_again;  // and their remedies
  /// Otherwise any two capitals are a value representation, lengths of items may be odd, and what has a length and is
  /// not asked for is passed unseen.
  bool exact = true;
};

class DicomWalk {
 public:
  /// All must outlive it.
  DicomWalk(DicomSource& source, const std::string& file, const DicomManner& manner)
      : source_(source), file_(file), manner_(manner) {}

  std::uint64_t at() const { return at_; }
  std::uint64_t size() const { return source_.size(); }
  void go_to(std::uint64_t at) { at_ = at; }
  void be_big_endian() { big_endian_ = true; }
  bool is_big_endian() const { return big_endian_; }
  /// Has a value that was passed, or told of by note_length, an odd number of bytes?
  bool odd_lengths() const { return odd_lengths_; }
  void note_length(const DicomHead& head) { odd_lengths_ |= !head.is_undefined() && head.length % 2 != 0; }

  // What follows throws InputError truncated or unreadable, by the names of the manner. `end` is that of what holds the
  // elements.
  DicomHead next(bool implicit_vr, std::uint64_t end);
  /// Precondition: its head was read last. Values of more than limits::dicom_value bytes are refused.
  std::string value(const DicomHead& head, std::uint64_t end);
  void skip(std::uint64_t count, std::uint64_t end);
  void require(std::uint64_t count, std::uint64_t end) const;
  /// The rest of an element, whatever it holds; it lies in `depth` sequences.
  void pass(const DicomHead& head, bool implicit_vr, std::uint64_t end, int depth);
  /// The rest of an item.
  void pass_item(const DicomHead& item, bool implicit_vr, std::uint64_t end, int depth);
  /// `take` each piece of pixels without length: its head. What it holds is to be passed.
  template <class Take>
  void fragments(bool implicit_vr, std::uint64_t end, Take take);

  /// Are the items of an element coded implicitly? Of unknown representation and length they are, says PS3.5, 6.2.2.
  static bool holds_implicit(const DicomHead& head, bool implicit_vr) {
    return implicit_vr || (head.is("UN") && head.is_undefined());
  }
  /// `take` each item of a sequence, which lies in `depth - 1` others: its head, how it is coded and where it must end.
  template <class Take>
  void items(const DicomHead& sequence, bool implicit_vr, std::uint64_t end, int depth, Take take);
  /// `take` each element of an item: its head, and where the item must end.
  template <class Take>
  void elements(const DicomHead& item, bool implicit_vr, std::uint64_t end, Take take);
  /// `take` each element of group 2, always explicit and little-endian.
  template <class Take>
  void meta_information(Take take);

  /// PS3.5, 7.1.1: lengths are even. A value that is not may be a careless writer's; where a whole item is not, its end
  /// and all that follows may be misread.
  void refuse_odd(const DicomHead& head) const;
  [[noreturn]] void refuse(std::string_view wrong) const;

 private:
  [[noreturn]] void refuse_truncated() const;
  Place place() const;
  void check_item(const DicomHead& item, int depth) const;
  void take_bytes(char* to, std::size_t count, std::uint64_t end);
  std::uint32_t number(std::size_t bytes, std::uint64_t end);

  DicomSource& source_;
  const std::string& file_;
  const DicomManner& manner_;
  std::uint64_t at_ = 0;
  bool big_endian_ = false, odd_lengths_ = false;
};

template <class Take>
void DicomWalk::items(const DicomHead& sequence, bool implicit_vr, std::uint64_t end, int depth, Take take) {
  const bool implicit_items = holds_implicit(sequence, implicit_vr);
  refuse_odd(sequence);
  if (!sequence.is_undefined()) require(sequence.length, end);
  const std::uint64_t own_end = sequence.is_undefined() ? end : at_ + sequence.length;
  while (sequence.is_undefined() || at_ < own_end) {
    const DicomHead item = next(implicit_items, own_end);
    if (item.tag == dicom::sequence_end && sequence.is_undefined()) return;
    check_item(item, depth);
    take(item, implicit_items, own_end);
  }
}

template <class Take>
void DicomWalk::elements(const DicomHead& item, bool implicit_vr, std::uint64_t end, Take take) {
  if (!item.is_undefined()) require(item.length, end);
  const std::uint64_t own_end = item.is_undefined() ? end : at_ + item.length;
  while (item.is_undefined() || at_ < own_end) {
    const DicomHead inner = next(implicit_vr, own_end);
    if (inner.tag == dicom::item_end && item.is_undefined()) return;
    take(inner, own_end);
  }
}

template <class Take>
void DicomWalk::fragments(bool implicit_vr, std::uint64_t end, Take take) {
  for (;;) {
    const DicomHead part = next(implicit_vr, end);
    if (part.tag == dicom::sequence_end) return;
    if (part.tag != dicom::item || part.is_undefined()) refuse("its compressed pixels are not in items");
    take(part);
  }
}

template <class Take>
void DicomWalk::meta_information(Take take) {
  while (at_ + 4 <= size()) {
    const std::uint64_t start = at_;
    const bool is_meta = number(2, size()) == 0x0002;
    at_ = start;
    if (!is_meta) return;
    take(next(false, size()));
  }
}

}  // namespace odontoscope
