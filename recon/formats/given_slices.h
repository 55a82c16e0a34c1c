#pragma once
// What a glTF file of ours tells of the slices that its model was made from.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace odontoscope {

/// How many slices were given: asset.extras.slices_checked (see recon/formats/write_glb.h), a whole number from 2 to
/// limits::slices. Nothing where that is missing or is anything else: files of others may use the name as they like.
/// Precondition: `bytes` have been read as glTF, binary or not, without an error.
std::optional<std::size_t> slices_given(std::string_view bytes, const std::string& file);

}  // namespace odontoscope
