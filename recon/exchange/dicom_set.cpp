#include "recon/exchange/dicom_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "recon/core/limits.h"
#include "recon/formats/parsing.h"

namespace odontoscope {
namespace {

using namespace parsing;

constexpr std::size_t preamble_length = 128, mark_length = 4;
constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint32_t item_tag = 0xfffee000, item_end = 0xfffee00d, sequence_end = 0xfffee0dd,
                        transfer_syntax = 0x00020010;

std::string_view trimmed(std::string_view text) {
  const auto is_padding = [](char c) { return c == '\0' || is_space(c); };
  while (!text.empty() && is_padding(text.back())) text.remove_suffix(1);
  while (!text.empty() && is_padding(text.front())) text.remove_prefix(1);
  return text;
}

bool has_representation(std::string_view bytes, std::size_t at) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  return bytes.size() >= at + 6 && is_capital(bytes[at + 4]) && is_capital(bytes[at + 5]);
}

}  // namespace

bool begins_as_data_set(std::string_view bytes) {
  constexpr std::size_t header = 8;
  if (bytes.size() < header || (bytes[0] != 2 && bytes[0] != 8) || bytes[1] != 0 || bytes[3] != 0) return false;
  return has_representation(bytes, 0) || little_endian<std::uint32_t>(bytes, 4) <= bytes.size();
}

DicomSet::DicomSet(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {
  const bool marked =
      bytes_.size() >= preamble_length + mark_length && bytes_.substr(preamble_length, mark_length) == "DICM";
  const bool without_preamble = !marked && bytes_.starts_with("DICM");
  if (!marked && !without_preamble && !begins_as_data_set(bytes_)) unreadable(0, "the file has no mark of DICOM");
  read_meta_information(marked ? preamble_length + mark_length : without_preamble ? mark_length : 0);
}

/// Group 2, always explicit, says how the rest is coded.
void DicomSet::read_meta_information(std::size_t at) {
  const bool bare = at == 0;
  std::string_view syntax;
  while (at < bytes_.size() && number(at, 2, bytes_.size()) == 2) {
    const Element found = element(at, bytes_.size(), true, 0);
    if (found.tag == transfer_syntax) syntax = trimmed(bytes_.substr(found.first, found.end - found.first));
    at = found.next;
  }
  constexpr std::string_view implicit_little = "1.2.840.10008.1.2", explicit_little = "1.2.840.10008.1.2.1";
  // Without it the coding shows in the first element: representations are two capital letters.
  if (syntax.empty() && bare) syntax = has_representation(bytes_, at) ? explicit_little : implicit_little;
  if (syntax != implicit_little && syntax != explicit_little) {
    unreadable(at, syntax.empty() ? "it names no transfer syntax"
                                  : fmt::format("transfer syntax {} is not supported", tame(syntax)));
  }
  top_ = {at, bytes_.size(), syntax == explicit_little};
  while (at < bytes_.size()) at = element(at, bytes_.size(), top_.explicit_vr, 0).next;  // whole to its end
}

std::string_view DicomSet::text(const DataSet& data, std::uint32_t tag) const {
  Element found;
  if (!find(data, tag, found) || found.undefined) return {};
  return trimmed(bytes_.substr(found.first, found.end - found.first));
}

std::vector<DicomSet::DataSet> DicomSet::items(const DataSet& data, std::uint32_t tag) const {
  std::vector<DataSet> items;
  Element sequence;
  if (!find(data, tag, sequence)) return items;
  for (std::size_t at = sequence.first; at < sequence.end;) {
    const Element item = header(at, sequence.end, sequence.explicit_items);
    if (item.tag != item_tag) unreadable(at, "a sequence holds something else than items");
    const std::size_t next = skip_item(at, sequence.end, sequence.explicit_items, 1);
    constexpr std::size_t delimiter = 8;
    items.push_back({item.first, item.undefined ? next - delimiter : next, sequence.explicit_items});
    at = next;
  }
  return items;
}

bool DicomSet::find(const DataSet& data, std::uint32_t tag, Element& found) const {
  for (std::size_t at = data.first; at < data.end;) {
    found = element(at, data.end, data.explicit_vr, 0);
    if (found.tag == tag) return true;
    at = found.next;
  }
  return false;
}

/// Tag and length; the value is not looked at.
DicomSet::Element DicomSet::header(std::size_t at, std::size_t end, bool explicit_vr) const {
  Element found;
  found.tag = number(at, 2, end) << 16 | number(at + 2, 2, end);
  found.explicit_items = explicit_vr;
  std::uint32_t length = 0;
  if (!explicit_vr || found.tag >> 16 == 0xfffe) {
    length = number(at + 4, 4, end);
    found.first = at + 8;
  } else {
    if (end - at < 6) truncated(at);
    found.vr = bytes_.substr(at + 4, 2);
    constexpr std::array<std::string_view, 13> long_ones{"OB", "OW", "OF", "OD", "OL", "OV", "SQ",
                                                         "UC", "UR", "UT", "UN", "SV", "UV"};
    if (std::any_of(found.vr.begin(), found.vr.end(), [](char c) { return c < 'A' || c > 'Z'; })) {
      unreadable(at, "an element has no value representation of DICOM");
    }
    const bool is_long = std::find(long_ones.begin(), long_ones.end(), found.vr) != long_ones.end();
    length = is_long ? number(at + 8, 4, end) : number(at + 6, 2, end);
    found.first = at + (is_long ? 12 : 8);
  }
  found.undefined = length == undefined_length;
  if (!found.undefined && length > end - found.first) truncated(at);
  found.end = found.next = found.undefined ? found.first : found.first + length;
  return found;
}

DicomSet::Element DicomSet::element(std::size_t at, std::size_t end, bool explicit_vr, int depth) const {
  Element found = header(at, end, explicit_vr);
  if (!found.undefined) return found;
  // Of unknown representation and length: a sequence in implicit coding, says PS3.5, 6.2.2.
  found.explicit_items = explicit_vr && found.vr != "UN";
  found.next = skip_items(found.first, end, found.explicit_items, depth + 1);
  constexpr std::size_t delimiter = 8;
  found.end = found.next - delimiter;
  return found;
}

/// The first byte behind the delimiter of a sequence without length.
std::size_t DicomSet::skip_items(std::size_t at, std::size_t end, bool explicit_vr, int depth) const {
  if (depth > limits::dicom_nesting)
    unreadable(at, fmt::format("sequences lie in each other more than {} deep", limits::dicom_nesting));
  for (;;) {
    const Element item = header(at, end, explicit_vr);
    if (item.tag == sequence_end) return item.first;
    if (item.tag != item_tag) unreadable(at, "a sequence holds something else than items");
    at = skip_item(at, end, explicit_vr, depth);
  }
}

/// The first byte behind an item, and its delimiter if it has one.
std::size_t DicomSet::skip_item(std::size_t at, std::size_t end, bool explicit_vr, int depth) const {
  const Element item = header(at, end, explicit_vr);
  if (!item.undefined) return item.next;
  for (at = item.first;;) {
    const Element inner = element(at, end, explicit_vr, depth);
    if (inner.tag == item_end) return inner.first;
    at = inner.next;
  }
}

std::uint32_t DicomSet::number(std::size_t at, std::size_t bytes, std::size_t end) const {
  if (at > end || bytes > end - at) truncated(std::min(at, end));
  std::uint32_t value = 0;
  for (std::size_t n = bytes; n-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes_[at + n]);
  return value;
}

void DicomSet::truncated(std::size_t at) const {
  refuse("truncated", at_byte(file_, at), "an element reaches beyond the end of what holds it",
         "Get a whole copy of the file");
}

void DicomSet::unreadable(std::size_t at, std::string_view wrong) const {
  refuse("unreadable-structure-set", at_byte(file_, at), wrong, "Export it again");
}

}  // namespace odontoscope
