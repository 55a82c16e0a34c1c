#include "recon/segmentation/write_rtstruct.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "recon/segmentation/keyholes.h"

namespace odontoscope {
namespace {

constexpr const char* structure_set_class = "1.2.840.10008.5.1.4.1.1.481.3";
constexpr const char* study_class = "1.2.840.10008.3.1.2.3.1";

class StructureSetWriter {
 public:
  StructureSetWriter(const ContourStack& stack, const PatientOrigin& origin)
      : stack_(ordered(stack).stack), origin_(origin), planes_(origin), structures_(structures_of(stack)) {}

  std::string write(const WrittenBy& by) const {
    const ObjectUids uids = object_uids(origin_, DerivedUid("rtstruct\n" + in_bytes(origin_) + to_json(stack_)));
    DicomWriter data = common_modules(origin_, uids, structure_set_class, "RTSTRUCT", by);
    data.text(0x00081070, "PN", "")
        .text(0x30060002, "SH", "Odontoscope")
        .text(0x30060008, "DA", "")
        .text(0x30060009, "TM", "");
    data.sequence(0x30060010, {frame_item(uids)});
    std::vector<DicomWriter> regions, contours, observations;
    const std::vector<std::string> names = dicom_names(structures_);
    for (std::size_t s = 0; s < structures_.size(); ++s) {
      const std::string number = std::to_string(s + 1);
      const SegmentLook look = look_of(structures_[s], s);
      regions.push_back(DicomWriter()
                            .text(0x30060022, "IS", number)
                            .text(0x30060024, "UI", uids.frame_of_reference)
                            .text(0x30060026, "LO", names[s])
                            .text(0x30060036, "CS", "SEMIAUTOMATIC"));
      contours.push_back(
          DicomWriter()
              .text(0x3006002a, "IS", fmt::format("{}\\{}\\{}", look.colour[0], look.colour[1], look.colour[2]))
              .sequence(0x30060040, contour_items(structures_[s]))
              .text(0x30060084, "IS", number));
      observations.push_back(DicomWriter()
                                 .text(0x30060082, "IS", number)
                                 .text(0x30060084, "IS", number)
                                 .sequence(0x30060086, {code_item(look.type)})
                                 .text(0x300600a4, "CS", "")
                                 .text(0x300600a6, "PN", ""));
    }
    data.sequence(0x30060020, std::move(regions))
        .sequence(0x30060039, std::move(contours))
        .sequence(0x30060080, std::move(observations));
    return data.file(DicomCoding::implicit_little);
  }

 private:
  /// The frame of reference, and the images in it that are known.
  DicomWriter frame_item(const ObjectUids& uids) const {
    DicomWriter frame;
    frame.text(0x00200052, "UI", uids.frame_of_reference);
    if (!origin_.dicom || !is_uid(origin_.dicom->series)) return frame;
    std::vector<DicomWriter> images;
    for (const DicomInstance& instance : origin_.dicom->instances) {
      if (is_uid(instance.uid) && is_uid(instance.class_uid)) images.push_back(image_item(instance));
    }
    if (images.empty()) return frame;
    const DicomWriter series =
        DicomWriter().text(0x0020000e, "UI", origin_.dicom->series).sequence(0x30060016, std::move(images));
    frame.sequence(0x30060012, {DicomWriter()
                                    .text(0x00081150, "UI", study_class)
                                    .text(0x00081155, "UI", uids.study)
                                    .sequence(0x30060014, {series})});
    return frame;
  }

  std::vector<DicomWriter> contour_items(const std::string& structure) const {
    std::vector<DicomWriter> items;
    for (const Slice& slice : stack_.slices) {
      std::vector<Ring> rings;
      for (const Contour& contour : slice.contours) {
        if (contour.structure == structure) rings.push_back(contour.points);
      }
      for (const Ring& ring : with_keyholes(rings)) items.push_back(contour_item(ring, slice.z));
    }
    return items;
  }

  DicomWriter contour_item(const Ring& ring, double z) const {
    std::string numbers;
    for (const Point2& p : ring) {
      const Point3 at = origin_.frame.in_patient({p.x, p.y, z});
      if (!numbers.empty()) numbers += '\\';
      numbers += decimal_strings({at.x, at.y, at.z});
    }
    DicomWriter item;
    item.text(0x30060042, "CS", "CLOSED_PLANAR")
        .text(0x30060046, "IS", std::to_string(ring.size()))
        .text(0x30060050, "DS", std::move(numbers));
    if (const DicomInstance* image = planes_.at({ring[0].x, ring[0].y, z}))
      item.sequence(0x30060016, {image_item(*image)});
    return item;
  }

  ContourStack stack_;
  const PatientOrigin& origin_;
  ImagePlanes planes_;
  std::vector<std::string> structures_;
};

}  // namespace

std::string rtstruct_bytes(const ContourStack& stack, const PatientOrigin& origin, const WrittenBy& by) {
  return StructureSetWriter(stack, origin).write(by);
}

}  // namespace odontoscope
