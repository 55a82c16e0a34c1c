#include "recon/segmentation/structures_file.h"

#include "recon/core/lower_case.h"

namespace odontoscope {

std::optional<StructuresFormat> structures_format(const std::string& file) {
  const std::string name = lower_case(file);
  if (name.ends_with(".seg.dcm")) return StructuresFormat::seg;
  if (name.ends_with(".dcm")) return StructuresFormat::rtstruct;
  if (name.ends_with(".nrrd")) return StructuresFormat::label_map;
  return std::nullopt;
}

const std::vector<std::string>& structures_endings() {
  static const std::vector<std::string> endings{".dcm", ".seg.dcm", ".seg.nrrd", ".nrrd"};
  return endings;
}

}  // namespace odontoscope
