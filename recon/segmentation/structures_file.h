#pragma once
// The formats of this room by the ends of files' names.

#include <optional>
#include <string>
#include <vector>

namespace odontoscope {

enum class StructuresFormat {
  rtstruct,   // .dcm
  seg,        // .seg.dcm
  label_map,  // .nrrd, .seg.nrrd
};

/// Whatever its letters; nothing for other names.
std::optional<StructuresFormat> structures_format(const std::string& file);

/// ".dcm", ".seg.dcm", ".seg.nrrd", ".nrrd": for messages.
const std::vector<std::string>& structures_endings();

/// Is it made of voxels?
inline bool has_voxels(StructuresFormat format) { return format != StructuresFormat::rtstruct; }

}  // namespace odontoscope
