#pragma once
// Buffer views of a GLB that were compressed with meshoptimizer (extension EXT_meshopt_compression). For the .cpp files
// of this room only.

#include <string>

#include "recon/formats/gltf_accessors.h"

namespace odontoscope::gltf {

inline constexpr const char* meshopt_extension = "EXT_meshopt_compression";

/// The bytes of `view`, which has the extension. What the file announces is compared with what its bytes can hold
/// before memory is taken. InputError: unparsable, truncated, damaged-buffer, too-large, unsupported (filters of
/// normals and turns, which are never asked for here; a buffer outside the file).
std::string unpacked(const Glb& glb, const nlohmann::json& view);

}  // namespace odontoscope::gltf
