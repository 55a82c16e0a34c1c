#pragma once
// Where the buffers of glTF lie: within a .glb, within the JSON (data URIs), or in files beside it. For the .cpp files
// of this room only.

#include <cstddef>
#include <string_view>

#include "recon/formats/gltf_accessors.h"

namespace odontoscope::gltf {

/// All bytes of a buffer of the document. Files are looked for in the folder of the document's own and below it only: a
/// name that leads elsewhere, or a link that does, is refused. FileError: cannot be read. InputError: unsupported (no
/// data, another place), unparsable (a URI), file-too-large. Precondition: there is a buffer of that number.
std::string_view whole_buffer(const Glb& glb, std::size_t index);

}  // namespace odontoscope::gltf
