#pragma once
// Where a model lies in a patient, and which DICOM objects it came from: what files that go back to others must say.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

/// Point p of the model lies at fixed + sum of axes[i] * (p[i] - fixed[i]) in the patient: x to the left, y to the
/// back, z up, mm.
struct PatientFrame {
  using Vector = std::array<double, 3>;
  /// Unit vectors at right angles, right-handed: the model's x, y and z.
  std::array<Vector, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vector fixed{};

  bool is_turned() const { return axes != PatientFrame{}.axes; }
  /// To the bit where the frame is not turned.
  Point3 in_patient(const Point3& p) const {
    if (!is_turned()) return p;
    const Vector off{p.x - fixed[0], p.y - fixed[1], p.z - fixed[2]};
    Vector at = fixed;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) at[k] += axes[i][k] * off[i];
    return {at[0], at[1], at[2]};
  }
};

/// One image that slices were read from.
struct DicomInstance {
  std::string class_uid, uid;
  std::uint32_t frame = 0;                        // from 1, of a multi-frame image; 0 for a single one
  std::optional<std::array<double, 3>> position;  // of a point of its plane, in the patient
};

/// The patient, the study and the series, as their files have them: text in the files' character set, not trusted.
struct DicomOrigin {
  /// By tag: patient's name, study's date and so on, those that there were.
  std::map<std::uint32_t, std::string> identity;
  std::string character_set, frame_of_reference, position_indicator, study, series;
  std::vector<DicomInstance> instances;
  /// Of the images' planes, if known.
  std::optional<std::array<double, 3>> normal;
};

struct PatientOrigin {
  PatientFrame frame;
  /// Null if it was not read from DICOM.
  std::shared_ptr<const DicomOrigin> dicom;
};

}  // namespace odontoscope
