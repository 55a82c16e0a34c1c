#pragma once
// Names of labels in a file of their own, as ITK-SNAP writes it.

#include <string>
#include <vector>

#include "recon/volume/volume.h"

namespace odontoscope {

/// Lines of "IDX R G B A VIS MESH "NAME"", others beginning with #. Label 0, which is nothing, is left out. By value.
/// Throws FileError; InputError unparsable (naming the line), too-many-structures, file-too-large.
std::vector<VolumeLabel> read_label_names(const std::string& file);

/// The same of a text.
std::vector<VolumeLabel> parse_label_names(std::string_view text, const std::string& file);

}  // namespace odontoscope
