#include "recon/dicom/dicom_walk.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/core/limits.h"

namespace odontoscope {
namespace {

constexpr std::array<std::string_view, 13> long_ones{"OB", "OW", "OF", "OD", "OL", "OV", "SQ",
                                                     "UC", "UR", "UT", "UN", "SV", "UV"};
constexpr std::array<std::string_view, 21> short_ones{"AE", "AS", "AT", "CS", "DA", "DS", "DT", "FL", "FD", "IS", "LO",
                                                      "LT", "PN", "SH", "SL", "SS", "ST", "TM", "UI", "UL", "US"};

template <class Names>
bool is_one_of(std::string_view vr, const Names& names) {
  return std::find(names.begin(), names.end(), vr) != names.end();
}

}  // namespace

bool is_dicom_representation(std::string_view vr) { return is_one_of(vr, short_ones) || is_one_of(vr, long_ones); }

DicomHead DicomWalk::next(bool implicit_vr, std::uint64_t end) {
  DicomHead head;
  const std::uint32_t group = number(2, end);
  head.tag = dicom::tag(group, number(2, end));
  if (implicit_vr || group == 0xfffe) {
    head.length = number(4, end);
    return head;
  }
  take_bytes(head.vr.data(), 2, end);
  const std::string_view vr(head.vr.data(), 2);
  const bool is_named = manner_.exact ? is_dicom_representation(vr)
                                      : std::all_of(vr.begin(), vr.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
  if (!is_named)
    refuse(fmt::format("element ({:04x},{:04x}) has no value representation of DICOM", group, head.tag & 0xffff));
  if (is_one_of(vr, long_ones)) {
    skip(2, end);
    head.length = number(4, end);
  } else {
    head.length = number(2, end);
  }
  return head;
}

std::string DicomWalk::value(const DicomHead& head, std::uint64_t end) {
  if (head.length > limits::dicom_value)
    refuse(fmt::format("element ({:04x},{:04x}) is too long", head.tag >> 16, head.tag & 0xffff));
  require(head.length, end);
  std::string bytes(head.length, '\0');
  take_bytes(bytes.data(), bytes.size(), end);
  return bytes;
}

void DicomWalk::skip(std::uint64_t count, std::uint64_t end) {
  require(count, end);
  at_ += count;
}

void DicomWalk::require(std::uint64_t count, std::uint64_t end) const {
  if (at_ > end || count > end - at_) refuse_truncated();
}

void DicomWalk::pass(const DicomHead& head, bool implicit_vr, std::uint64_t end, int depth) {
  if (dicom::is_pixels(head.tag) && head.is_undefined())
    return fragments(implicit_vr, end, [&](const DicomHead& part) { skip(part.length, end); });
  note_length(head);
  if (!head.is_undefined() && !(manner_.exact && head.is("SQ"))) return skip(head.length, end);
  items(head, implicit_vr, end, depth + 1, [&](const DicomHead& item, bool implicit_items, std::uint64_t own_end) {
    pass_item(item, implicit_items, own_end, depth + 1);
  });
}

void DicomWalk::pass_item(const DicomHead& item, bool implicit_vr, std::uint64_t end, int depth) {
  if (!manner_.exact && !item.is_undefined()) return skip(item.length, end);
  elements(item, implicit_vr, end,
           [&](const DicomHead& inner, std::uint64_t own_end) { pass(inner, implicit_vr, own_end, depth); });
}

void DicomWalk::check_item(const DicomHead& item, int depth) const {
  if (item.tag != dicom::item) refuse("a sequence holds something else than items");
  refuse_odd(item);
  if (depth > limits::dicom_nesting)
    refuse(fmt::format("sequences lie in each other more than {} deep", limits::dicom_nesting));
}

void DicomWalk::refuse_odd(const DicomHead& head) const {
  if (!manner_.exact || head.is_undefined() || head.length % 2 == 0) return;
  refuse(fmt::format(
      "an item or sequence has an odd number of bytes ({}), which DICOM does not allow: where it ends is not sure",
      head.length));
}

void DicomWalk::refuse(std::string_view wrong) const {
  throw InputError(manner_.unreadable, place(), wrong, manner_.export_again);
}

void DicomWalk::refuse_truncated() const {
  throw InputError(manner_.truncated, place(), "an element reaches beyond the end of what holds it", manner_.get_whole);
}

Place DicomWalk::place() const {
  Place place;
  place.file = file_;
  place.byte = static_cast<std::size_t>(at_);
  return place;
}

void DicomWalk::take_bytes(char* to, std::size_t count, std::uint64_t end) {
  require(count, end);
  if (!source_.read(at_, to, count)) refuse_truncated();
  at_ += count;
}

std::uint32_t DicomWalk::number(std::size_t bytes, std::uint64_t end) {
  std::array<char, 4> raw{};
  take_bytes(raw.data(), bytes, end);
  if (big_endian_) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(bytes));
  std::uint32_t value = 0;
  for (std::size_t n = bytes; n-- > 0;) value = value << 8 | static_cast<unsigned char>(raw[n]);
  return value;
}

}  // namespace odontoscope
