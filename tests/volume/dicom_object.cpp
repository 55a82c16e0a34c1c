#include "tests/volume/dicom_object.h"

#include <zlib.h>

#include <set>
#include <stdexcept>

namespace odontoscope::test {
namespace {

std::string little(std::uint32_t value, std::size_t bytes) {
  std::string result;
  for (std::size_t n = 0; n < bytes; ++n) result += static_cast<char>(value >> (8 * n) & 0xff);
  return result;
}

std::string bare_deflated(const std::string& bytes) {
  z_stream stream{};
  constexpr int bare_window = -15, memory = 8;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, bare_window, memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib");
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("zlib");
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

bool has_long_length(const std::string& vr) { return std::set<std::string>{"OB", "OW", "SQ", "UN", "UT"}.contains(vr); }

std::string padded(std::string value, const std::string& vr) {
  if (value.size() % 2 != 0) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
  return value;
}

std::string decimal(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string DicomObject::number(std::uint32_t value, std::size_t bytes) const {
  std::string result = little(value, bytes);
  if (coding_ == DicomCoding::explicit_big) result.assign(result.rbegin(), result.rend());
  return result;
}

void DicomObject::head(std::uint16_t group, std::uint16_t element, const std::string& vr, std::uint32_t length) {
  bytes_ += number(group, 2) + number(element, 2);
  if (coding_ == DicomCoding::implicit_little || group == 0xfffe)
    bytes_ += number(length, 4);
  else if (has_long_length(vr))
    bytes_ += vr + std::string(2, '\0') + number(length, 4);
  else
    bytes_ += vr + number(length, 2);
}

DicomObject& DicomObject::text(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value) {
  value = padded(std::move(value), vr);
  head(group, element, vr, static_cast<std::uint32_t>(value.size()));
  bytes_ += value;
  return *this;
}

DicomObject& DicomObject::shorts(std::uint16_t group, std::uint16_t element, const std::vector<std::uint16_t>& values,
                                 const std::string& vr) {
  head(group, element, vr, static_cast<std::uint32_t>(2 * values.size()));
  for (const std::uint16_t value : values) bytes_ += number(value, 2);
  return *this;
}

DicomObject& DicomObject::sequence(std::uint16_t group, std::uint16_t element, const std::vector<DicomObject>& items,
                                   bool open) {
  constexpr std::uint32_t undefined = 0xffffffff;
  DicomObject inner(coding_);
  for (const DicomObject& item : items) {
    inner.head(0xfffe, 0xe000, {}, open ? undefined : static_cast<std::uint32_t>(item.bytes_.size()));
    inner.bytes_ += item.bytes_;
    if (open) inner.head(0xfffe, 0xe00d, {}, 0);
  }
  if (open) inner.head(0xfffe, 0xe0dd, {}, 0);
  head(group, element, "SQ", open ? undefined : static_cast<std::uint32_t>(inner.bytes_.size()));
  bytes_ += inner.bytes_;
  return *this;
}

DicomObject& DicomObject::pieces(const std::vector<std::string>& fragments) {
  head(0x7fe0, 0x0010, "OB", 0xffffffff);
  head(0xfffe, 0xe000, {}, 0);
  for (const std::string& fragment : fragments) {
    const std::string even = padded(fragment, "OB");
    head(0xfffe, 0xe000, {}, static_cast<std::uint32_t>(even.size()));
    bytes_ += even;
  }
  head(0xfffe, 0xe0dd, {}, 0);
  return *this;
}

DicomObject& DicomObject::all(const DicomObject& other) {
  bytes_ += other.bytes_;
  return *this;
}

std::string DicomObject::file(const std::string& syntax, const std::string& storage_class) const {
  std::string name = syntax;
  if (name.empty()) {
    name = coding_ == DicomCoding::implicit_little ? "1.2.840.10008.1.2"
           : coding_ == DicomCoding::explicit_big  ? "1.2.840.10008.1.2.2"
           : coding_ == DicomCoding::deflated      ? "1.2.840.10008.1.2.1.99"
                                                   : "1.2.840.10008.1.2.1";
  }
  DicomObject meta;
  meta.text(2, 2, "UI", storage_class)
      .text(2, 3, "UI", "1.2.3.4.1")
      .text(2, 0x10, "UI", name)
      .text(2, 0x12, "UI", "1.2.3");
  DicomObject length;
  length.shorts(2, 0, {static_cast<std::uint16_t>(meta.bytes_.size()), 0}, "UL");
  return std::string(128, '\0') + "DICM" + length.bytes_ + meta.bytes_ +
         (coding_ == DicomCoding::deflated ? bare_deflated(bytes_) : bytes_);
}

std::vector<std::uint16_t> ct_pixels(int number) {
  std::vector<std::uint16_t> pixels;
  for (int n = 0; n < 12; ++n) pixels.push_back(static_cast<std::uint16_t>(100 * number + n));
  return pixels;
}

std::string rle_packed(const std::vector<std::uint16_t>& pixels) {
  std::array<std::string, 2> segments;  // high bytes, then low ones
  for (std::size_t n = 0; n < pixels.size(); n += 128) {
    const std::size_t run = std::min<std::size_t>(128, pixels.size() - n);
    for (int part = 0; part < 2; ++part) {
      segments[std::size_t(part)] += static_cast<char>(run - 1);
      for (std::size_t m = n; m < n + run; ++m)
        segments[std::size_t(part)] += static_cast<char>(part == 0 ? pixels[m] >> 8 : pixels[m] & 0xff);
    }
  }
  for (std::string& segment : segments)
    if (segment.size() % 2 != 0) segment += '\0';
  std::string header = little(2, 4) + little(64, 4) + little(static_cast<std::uint32_t>(64 + segments[0].size()), 4);
  header.resize(64, '\0');
  return header + segments[0] + segments[1];
}

std::string EnhancedCt::bytes() const {
  const auto object = [this] { return DicomObject(coding); };
  const auto plane_orientation = [&] {
    return object().sequence(0x20, 0x9116, {object().text(0x20, 0x37, "DS", axes)}, open_items);
  };
  const auto pixel_measures = [&] {
    return object().sequence(0x28, 0x9110, {object().text(0x18, 0x50, "DS", "2").text(0x28, 0x30, "DS", "0.5\\0.25")},
                             open_items);
  };
  const auto rescaling = [&](const CtFrame& frame) {
    return object().text(0x28, 0x1052, "DS", decimal(frame.intercept)).text(0x28, 0x1053, "DS", decimal(frame.slope));
  };
  const auto groups = [&](Where where, const CtFrame* frame) {
    DicomObject item(coding);
    if (frame != nullptr && has_places)
      item.sequence(0x20, 0x9113, {object().text(0x20, 0x32, "DS", frame->position)}, open_items);
    if (orientation == where) item.all(plane_orientation());
    if (measures == where) item.all(pixel_measures());
    if (transformation == where)
      item.sequence(0x28, 0x9145, {rescaling(frame != nullptr ? *frame : frames.front())}, open_items);
    return item;
  };
  DicomObject data(coding);
  data.text(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.2.1")
      .text(8, 0x18, "UI", instance)
      .text(8, 0x60, "CS", "CT")
      .text(0x20, 0xe, "UI", series);
  if (orientation == Where::top) data.text(0x20, 0x37, "DS", axes);
  data.shorts(0x28, 2, {1})
      .text(0x28, 4, "CS", "MONOCHROME2")
      .text(0x28, 8, "IS", std::to_string(frames.size()))
      .shorts(0x28, 0x10, {3})
      .shorts(0x28, 0x11, {4});
  if (measures == Where::top) data.text(0x28, 0x30, "DS", "0.5\\0.25");
  data.shorts(0x28, 0x100, {16}).shorts(0x28, 0x101, {16}).shorts(0x28, 0x102, {15}).shorts(0x28, 0x103, {1});
  if (transformation == Where::top) data.all(rescaling(frames.front()));
  data.all(more);
  data.sequence(0x5200, 0x9229, {groups(Where::shared, nullptr)}, open_items);
  std::vector<DicomObject> items;
  std::vector<std::uint16_t> pixels;
  for (const CtFrame& frame : frames) {
    items.push_back(groups(Where::frame, &frame));
    const std::vector<std::uint16_t> own = ct_pixels(frame.number);
    pixels.insert(pixels.end(), own.begin(), own.end());
  }
  data.sequence(0x5200, 0x9230, items, open_items);
  return data.words(0x7fe0, 0x10, pixels).file();
}

}  // namespace odontoscope::test
