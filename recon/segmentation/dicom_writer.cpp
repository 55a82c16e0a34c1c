#include "recon/segmentation/dicom_writer.h"

#include <fmt/format.h>

#include <utility>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

constexpr std::uint32_t class_uid = 0x00080016, instance_uid = 0x00080018, item_tag = 0xfffee000;
/// Of this program's writer; a UUID made once.
constexpr std::string_view implementation = "2.25.177236452690712398501634482911762309843";

void append_number(std::string& bytes, std::uint32_t value, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n) bytes += static_cast<char>(value >> (8 * n) & 0xff);
}

void append_tag(std::string& bytes, std::uint32_t tag) {
  append_number(bytes, tag >> 16, 2);
  append_number(bytes, tag & 0xffff, 2);
}

bool has_long_length(std::string_view vr) { return vr == "OB" || vr == "OW" || vr == "SQ" || vr == "UT" || vr == "UN"; }

void append_element(std::string& bytes, std::uint32_t tag, std::string_view vr, const std::string& value,
                    DicomCoding coding) {
  constexpr std::size_t most = 0xfffffffe, most_in_16_bits = 0xfffe;
  const bool is_short = coding == DicomCoding::explicit_little && !has_long_length(vr);
  if (value.size() > (is_short ? most_in_16_bits : most))
    throw InternalError(fmt::format("a value of {} bytes does not fit into element {:08x}", value.size(), tag));
  append_tag(bytes, tag);
  const auto length = static_cast<std::uint32_t>(value.size());
  if (coding == DicomCoding::explicit_little) {
    bytes += vr;
    if (is_short) {
      append_number(bytes, length, 2);
    } else {
      append_number(bytes, 0, 2);
      append_number(bytes, length, 4);
    }
  } else {
    append_number(bytes, length, 4);
  }
  bytes += value;
}

}  // namespace

DicomWriter& DicomWriter::text(std::uint32_t tag, std::string_view vr, std::string value) {
  if (value.size() % 2 != 0) value += vr == "UI" ? '\0' : ' ';
  elements_[tag] = {std::string(vr), std::move(value), {}};
  return *this;
}

DicomWriter& DicomWriter::shorts(std::uint32_t tag, const std::vector<std::uint16_t>& values) {
  std::string bytes;
  for (const std::uint16_t value : values) append_number(bytes, value, 2);
  elements_[tag] = {"US", std::move(bytes), {}};
  return *this;
}

DicomWriter& DicomWriter::longs(std::uint32_t tag, const std::vector<std::uint32_t>& values) {
  std::string bytes;
  for (const std::uint32_t value : values) append_number(bytes, value, 4);
  elements_[tag] = {"UL", std::move(bytes), {}};
  return *this;
}

DicomWriter& DicomWriter::pointer(std::uint32_t tag, std::uint32_t to) {
  std::string bytes;
  append_tag(bytes, to);
  elements_[tag] = {"AT", std::move(bytes), {}};
  return *this;
}

DicomWriter& DicomWriter::bytes(std::uint32_t tag, std::string value) {
  if (value.size() % 2 != 0) value += '\0';
  elements_[tag] = {"OB", std::move(value), {}};
  return *this;
}

DicomWriter& DicomWriter::sequence(std::uint32_t tag, std::vector<DicomWriter> items) {
  elements_[tag] = {"SQ", {}, std::move(items)};
  return *this;
}

std::string DicomWriter::encoded(DicomCoding coding) const {
  std::string bytes;
  for (const auto& [tag, element] : elements_) {
    if (element.vr != "SQ") {
      append_element(bytes, tag, element.vr, element.value, coding);
      continue;
    }
    std::string items;
    for (const DicomWriter& item : element.items) {
      const std::string inner = item.encoded(coding);
      append_element(items, item_tag, {}, inner, DicomCoding::implicit_little);
    }
    append_element(bytes, tag, "SQ", items, coding);
  }
  return bytes;
}

std::string DicomWriter::file(DicomCoding coding) const {
  constexpr std::size_t preamble = 128;
  const auto value_of = [&](std::uint32_t tag) { return elements_.at(tag).value; };
  DicomWriter meta;
  meta.elements_[0x00020001] = {"OB", std::string("\0\1", 2), {}};
  meta.text(0x00020002, "UI", value_of(class_uid)).text(0x00020003, "UI", value_of(instance_uid));
  meta.text(0x00020010, "UI", coding == DicomCoding::implicit_little ? "1.2.840.10008.1.2" : "1.2.840.10008.1.2.1");
  meta.text(0x00020012, "UI", std::string(implementation)).text(0x00020013, "SH", "ODONTOSCOPE");
  const std::string rest = meta.encoded(DicomCoding::explicit_little);
  DicomWriter length;
  length.longs(0x00020000, {static_cast<std::uint32_t>(rest.size())});
  return std::string(preamble, '\0') + "DICM" + length.encoded(DicomCoding::explicit_little) + rest + encoded(coding);
}

std::string decimal_string(double value) {
  constexpr std::size_t longest = 16;
  if (value == 0) return "0";  // and no -0
  std::string text = fmt::format("{}", value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  for (int digits = 16; text.size() > longest; --digits) text = fmt::format("{:.{}g}", value, digits);
  return text;
}

std::string decimal_strings(const std::vector<double>& values) {
  std::string list;
  for (const double value : values) {
    if (!list.empty()) list += '\\';
    list += decimal_string(value);
  }
  return list;
}

}  // namespace odontoscope
