#include "recon/segmentation/write_seg.h"

#include <fmt/format.h>

#include <utility>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

constexpr const char* segmentation_class = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr std::uint32_t segment_identification = 0x0062000a, segment_number = 0x0062000b, plane_position = 0x00209113,
                        position = 0x00200032;

struct Frame {
  std::size_t segment = 0, slice = 0;
};

std::vector<Frame> frames_of(const Segmentation& segmentation) {
  std::vector<Frame> frames;
  for (std::size_t s = 0; s < segmentation.segments.size(); ++s) {
    for (std::size_t k = 0; k < segmentation.grid.size[2]; ++k) {
      if (segmentation.segments[s].voxels.any(k)) frames.push_back({s, k});
    }
  }
  return frames;
}

std::string packed(const Segmentation& segmentation, const std::vector<Frame>& frames) {
  const VoxelGrid& grid = segmentation.grid;
  std::string bytes((frames.size() * grid.size[0] * grid.size[1] + 7) / 8, '\0');
  std::size_t bit = 0;
  for (const Frame& frame : frames) {
    const VoxelBits& voxels = segmentation.segments[frame.segment].voxels;
    for (std::size_t j = 0; j < grid.size[1]; ++j) {
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++bit) {
        if (voxels.at(i, j, frame.slice)) bytes[bit / 8] = static_cast<char>(bytes[bit / 8] | 1 << (bit % 8));
      }
    }
  }
  return bytes;
}

class SegmentationWriter {
 public:
  SegmentationWriter(const Segmentation& segmentation, const PatientOrigin& origin)
      : segmentation_(segmentation),
        grid_(segmentation.grid),
        origin_(origin),
        planes_(origin),
        frames_(frames_of(segmentation)) {
    check_sizes();
  }

  std::string write(const WrittenBy& by) const {
    std::string pixels = packed(segmentation_, frames_);
    const DerivedUid content(identity() + pixels);
    const ObjectUids uids = object_uids(origin_, content);
    DicomWriter data = common_modules(origin_, uids, segmentation_class, "SEG", by);
    add_image(data, by);
    add_dimensions(data, content.of("dimensions"));
    add_references(data);
    data.sequence(0x00620002, segment_items());
    data.sequence(0x52009229, {shared_groups()}).sequence(0x52009230, frame_groups());
    data.bytes(0x7fe00010, std::move(pixels));
    return data.file(DicomCoding::explicit_little);
  }

 private:
  void check_sizes() const {
    if (frames_.empty())
      throw UsageError("no voxel's centre lies in a structure: there is nothing to write as a segmentation",
                       "Make voxels smaller (--voxels X,Y,Z)");
    constexpr std::size_t most_rows = 65535;
    constexpr double most_bits = 8.0 * 0xfffffff0;
    const double bits =
        static_cast<double>(frames_.size()) * static_cast<double>(grid_.size[0]) * static_cast<double>(grid_.size[1]);
    if (grid_.size[0] <= most_rows && grid_.size[1] <= most_rows && bits <= most_bits) return;
    throw UsageError(fmt::format("{} frames of {} x {} pixels do not fit into a DICOM segmentation", frames_.size(),
                                 grid_.size[0], grid_.size[1]),
                     "Make voxels larger (--voxels X,Y,Z)");
  }

  std::string identity() const {
    std::string bytes = "seg\n" + in_bytes(origin_) +
                        decimal_strings({grid_.origin.x, grid_.origin.y, grid_.origin.z, grid_.spacing[0],
                                         grid_.spacing[1], grid_.spacing[2]});
    for (const Segment& segment : segmentation_.segments) bytes += '\n' + segment.name;
    for (const Frame& frame : frames_) bytes += fmt::format("\n{} {}", frame.segment, frame.slice);
    return bytes;
  }

  void add_image(DicomWriter& data, const WrittenBy& by) const {
    data.text(0x00080008, "CS", "DERIVED\\PRIMARY")
        .text(0x00080023, "DA", content_date(origin_))
        .text(0x00080033, "TM", "000000");
    data.text(0x00181000, "LO", by.program)
        .text(0x00200013, "IS", "1");  // the device is a program: its number is its version
    data.whole(0x00280002, 1)
        .text(0x00280004, "CS", "MONOCHROME2")
        .text(0x00280008, "IS", std::to_string(frames_.size()));
    data.whole(0x00280010, static_cast<std::uint16_t>(grid_.size[1]))
        .whole(0x00280011, static_cast<std::uint16_t>(grid_.size[0]));
    data.whole(0x00280100, 1)
        .whole(0x00280101, 1)
        .whole(0x00280102, 0)
        .whole(0x00280103, 0)
        .text(0x00282110, "CS", "00");
    data.text(0x00620001, "CS", "BINARY")
        .text(0x00700080, "CS", "STRUCTURES")
        .text(0x00700081, "LO", "Structures of a tooth")
        .text(0x00700084, "PN", "");
  }

  static void add_dimensions(DicomWriter& data, const std::string& uid) {
    data.sequence(0x00209221, {DicomWriter().text(0x00209164, "UI", uid)}).text(0x00209311, "CS", "3D");
    const auto index = [&](std::uint32_t to, std::uint32_t group, const char* label) {
      return DicomWriter()
          .text(0x00209164, "UI", uid)
          .pointer(0x00209165, to)
          .pointer(0x00209167, group)
          .text(0x00209421, "LO", label);
    };
    data.sequence(0x00209222,
                  {index(segment_number, segment_identification, "Segment"), index(position, plane_position, "Place")});
  }

  void add_references(DicomWriter& data) const {
    if (!origin_.dicom || !is_uid(origin_.dicom->series)) return;
    std::vector<DicomWriter> images;
    std::string last;
    for (const DicomInstance& instance : origin_.dicom->instances) {
      if (instance.uid == last || !is_uid(instance.uid) || !is_uid(instance.class_uid))
        continue;  // frames of one image are one instance
      last = instance.uid;
      images.push_back(DicomWriter().text(0x00081150, "UI", instance.class_uid).text(0x00081155, "UI", instance.uid));
    }
    if (images.empty()) return;
    data.sequence(
        0x00081115,
        {DicomWriter().text(0x0020000e, "UI", origin_.dicom->series).sequence(0x0008114a, std::move(images))});
  }

  std::vector<DicomWriter> segment_items() const {
    std::vector<std::string> names;
    for (const Segment& segment : segmentation_.segments) names.push_back(segment.name);
    names = dicom_names(names);
    std::vector<DicomWriter> items;
    for (std::size_t s = 0; s < names.size(); ++s) {
      const SegmentLook look = look_of(segmentation_.segments[s].name, s);
      const auto lab = cie_lab(look.colour);
      DicomWriter item;
      item.whole(0x00620004, static_cast<std::uint16_t>(s + 1))
          .text(0x00620005, "LO", names[s])
          .text(0x00620008, "CS", "SEMIAUTOMATIC")
          .text(0x00620009, "LO", "Odontoscope");
      item.sequence(0x00620003, {code_item(look.category)})
          .sequence(0x0062000f, {code_item(look.type)})
          .shorts(0x0062000d, {lab[0], lab[1], lab[2]});
      if (look.region) item.sequence(0x00082218, {code_item(*look.region)});
      items.push_back(std::move(item));
    }
    return items;
  }

  DicomWriter shared_groups() const {
    const auto &x = origin_.frame.axes[0], &y = origin_.frame.axes[1];
    DicomWriter orientation, measures;
    orientation.text(0x00200037, "DS", decimal_strings({x[0], x[1], x[2], y[0], y[1], y[2]}));
    measures.text(0x00180050, "DS", decimal_string(grid_.spacing[2]))
        .text(0x00180088, "DS", decimal_string(grid_.spacing[2]));
    measures.text(0x00280030, "DS", decimal_strings({grid_.spacing[1], grid_.spacing[0]}));  // between rows first
    return DicomWriter().sequence(0x00209116, {orientation}).sequence(0x00289110, {measures});
  }

  std::vector<DicomWriter> frame_groups() const {
    std::vector<DicomWriter> groups;
    for (const Frame& frame : frames_) {
      const Point3 first{grid_.origin.x, grid_.origin.y, grid_.z(frame.slice)}, at = origin_.frame.in_patient(first);
      DicomWriter item;
      item.sequence(0x00209111, {DicomWriter().longs(0x00209157, {static_cast<std::uint32_t>(frame.segment + 1),
                                                                  static_cast<std::uint32_t>(frame.slice + 1)})});
      item.sequence(plane_position, {DicomWriter().text(position, "DS", decimal_strings({at.x, at.y, at.z}))});
      item.sequence(segment_identification,
                    {DicomWriter().whole(segment_number, static_cast<std::uint16_t>(frame.segment + 1))});
      if (const DicomInstance* image = planes_.at(first)) item.sequence(0x00089124, {source_item(*image)});
      groups.push_back(std::move(item));
    }
    return groups;
  }

  static DicomWriter source_item(const DicomInstance& image) {
    DicomWriter source = image_item(image);
    source.sequence(0x0040a170, {code_item({"121322", "DCM", "Source image for image processing operation"})});
    return DicomWriter()
        .sequence(0x00082112, {source})
        .sequence(0x00089215, {code_item({"113076", "DCM", "Segmentation"})});
  }

  const Segmentation& segmentation_;
  const VoxelGrid& grid_;
  const PatientOrigin& origin_;
  ImagePlanes planes_;
  std::vector<Frame> frames_;
};

}  // namespace

std::string seg_bytes(const Segmentation& segmentation, const PatientOrigin& origin, const WrittenBy& by) {
  return SegmentationWriter(segmentation, origin).write(by);
}

}  // namespace odontoscope
