#pragma once
// What all DICOM objects of this room say: whose they are, of which study, on which images. Inner part of this room.
//
// Patient and study are those of the series or structure set that was read; its text is not trusted: it becomes UTF-8,
// without control characters, and no longer than the standard allows. Without one the patient is left blank and the
// study is new.

#include <optional>
#include <string>
#include <vector>

#include "recon/input/patient_origin.h"
#include "recon/segmentation/derived_uid.h"
#include "recon/segmentation/dicom_writer.h"
#include "recon/segmentation/segment_look.h"

namespace odontoscope {

/// A program's name and version, such as "odontoscope 1.2".
struct WrittenBy {
  std::string program = "odontoscope";
};

struct ObjectUids {
  std::string instance, series, study, frame_of_reference;
};
/// New ones of `content`; study and frame of reference are the origin's where it has them.
ObjectUids object_uids(const PatientOrigin& origin, const DerivedUid& content);

/// Modules patient, study, series, frame of reference, equipment and SOP common; no identifiers of images.
DicomWriter common_modules(const PatientOrigin& origin, const ObjectUids& uids, const std::string& class_uid,
                           const std::string& modality, const WrittenBy& by);

/// All that the objects say of the origin, to derive identifiers from.
std::string in_bytes(const PatientOrigin& origin);

DicomWriter code_item(const Code& code);

/// "1.2.3" of class and instance, with the frame of multi-frame images.
DicomWriter image_item(const DicomInstance& instance);

/// A date of eight digits: the study's, or 20000101. Objects that need one have no other: bytes depend on the input
/// alone.
std::string content_date(const PatientOrigin& origin);

/// As names of DICOM may be: at most 64 characters, no backslash. `names` in order, made different from each other.
std::vector<std::string> dicom_names(const std::vector<std::string>& names);

/// Which image a slice lies on.
class ImagePlanes {
 public:
  explicit ImagePlanes(const PatientOrigin& origin);
  /// The image whose plane the model's plane through `at` (across the model's z) is, within a twentieth of the images'
  /// distance; null if there is none.
  const DicomInstance* at(const Point3& at) const;

 private:
  double height(const std::array<double, 3>& p) const;

  const PatientOrigin& origin_;
  std::vector<std::pair<double, const DicomInstance*>> by_height_;
  std::array<double, 3> normal_{};
  double tolerance_ = 0;
};

}  // namespace odontoscope
