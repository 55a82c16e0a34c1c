#include "tests/volume/segmentation_object.h"

namespace odontoscope::test {
namespace {

constexpr std::size_t pixels_a_frame = 12;

std::string pixels_of(const SegmentationObject& object) {
  std::string bytes;
  if (object.kind != "BINARY") {
    for (const SegmentFrame& frame : object.frames) bytes.append(frame.values.begin(), frame.values.end());
    return bytes;
  }
  bytes.resize((object.frames.size() * pixels_a_frame + 7) / 8);
  std::size_t bit = 0;
  for (const SegmentFrame& frame : object.frames)
    for (std::size_t n = 0; n < pixels_a_frame; ++n, ++bit)
      if ((frame.pixels >> n & 1) != 0) bytes[bit / 8] = static_cast<char>(bytes[bit / 8] | 1 << bit % 8);
  return bytes;
}

}  // namespace

std::string SegmentationObject::bytes() const {
  const auto object = [this] { return DicomObject(coding); };
  const auto segment_of = [&](std::uint16_t number) {
    return object().sequence(0x62, 0xa, {object().shorts(0x62, 0xb, {number})});
  };
  const bool is_map = kind == "LABELMAP";
  const std::uint16_t bits = kind == "BINARY" ? 1 : 8;
  DicomObject data(coding);
  if (!character_set.empty()) data.text(8, 5, "CS", character_set);
  data.text(8, 0x16, "UI", is_map ? "1.2.840.10008.5.1.4.1.1.66.7" : "1.2.840.10008.5.1.4.1.1.66.4")
      .text(8, 0x18, "UI", instance)
      .text(8, 0x60, "CS", "SEG");
  if (refers) {
    const DicomObject image =
        object().text(8, 0x1150, "UI", "1.2.840.10008.5.1.4.1.1.2").text(8, 0x1155, "UI", "1.2.3.4.1");
    data.sequence(8, 0x1115, {object().sequence(8, 0x114a, {image, image}).text(0x20, 0xe, "UI", "1.2.3.4")});
  }
  data.text(0x20, 0xd, "UI", study)
      .text(0x20, 0xe, "UI", series)
      .shorts(0x28, 2, {1})
      .text(0x28, 4, "CS", is_map ? "PALETTE COLOR" : "MONOCHROME2");
  data.text(0x28, 8, "IS", std::to_string(frames.size())).shorts(0x28, 0x10, {3}).shorts(0x28, 0x11, {4});
  data.shorts(0x28, 0x100, {bits})
      .shorts(0x28, 0x101, {bits})
      .shorts(0x28, 0x102, {static_cast<std::uint16_t>(bits - 1)})
      .shorts(0x28, 0x103, {0});
  std::vector<DicomObject> items;
  for (const auto& [number, name] : segments)
    items.push_back(object().shorts(0x62, 4, {number}).text(0x62, 5, "LO", name));
  data.text(0x62, 1, "CS", kind).sequence(0x62, 2, items).shorts(0x62, 0xe, {fraction_of});
  DicomObject measures = object().text(0x18, 0x50, "DS", "2");
  if (!slice_spacing.empty()) measures.text(0x18, 0x88, "DS", slice_spacing);
  DicomObject shared = object()
                           .sequence(0x20, 0x9116, {object().text(0x20, 0x37, "DS", axes)})
                           .sequence(0x28, 0x9110, {measures.text(0x28, 0x30, "DS", "0.5\\0.25")});
  if (shared_segment) shared.all(segment_of(1));
  data.sequence(0x5200, 0x9229, {shared});
  std::vector<DicomObject> groups;
  for (const SegmentFrame& frame : frames) {
    DicomObject item(coding);
    if (has_places) item.sequence(0x20, 0x9113, {object().text(0x20, 0x32, "DS", frame.position)});
    if (!shared_segment && !is_map && frame.segment != 0) item.all(segment_of(frame.segment));
    groups.push_back(item);
  }
  data.sequence(0x5200, 0x9230, groups);
  std::string pixels = pixels_of(*this);
  if (!words) return data.text(0x7fe0, 0x10, "OB", pixels).file();
  if (pixels.size() % 2 != 0) pixels += '\0';
  std::vector<std::uint16_t> pairs;
  for (std::size_t n = 0; n < pixels.size(); n += 2) {
    pairs.push_back(static_cast<std::uint16_t>(static_cast<unsigned char>(pixels[n]) |
                                               static_cast<unsigned char>(pixels[n + 1]) << 8));
  }
  return data.words(0x7fe0, 0x10, pairs).file();
}

}  // namespace odontoscope::test
