#pragma once
// A name with the ending that bytes of a volume call for: ITK asks a name for the format before it looks inside.

#include <string>
#include <string_view>

namespace odontoscope::hostile {

inline std::string volume_name(std::string_view bytes) {
  constexpr std::size_t dicom_mark = 128;
  if (bytes.starts_with("NRRD")) return "volume.nrrd";
  if (bytes.starts_with("\x1f\x8b")) return "volume.nii.gz";
  if (bytes.size() > dicom_mark && bytes.substr(dicom_mark).starts_with("DICM")) return "volume.dcm";
  const std::string_view first_line = bytes.substr(0, bytes.find('\n'));
  return first_line.find('=') == first_line.npos ? "volume.nii" : "volume.mha";
}

}  // namespace odontoscope::hostile
