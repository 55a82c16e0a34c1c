#pragma once
// Which extensions of glTF a file may require. For the .cpp files of this room only.

#include "recon/formats/gltf_accessors.h"

namespace odontoscope::gltf {

inline constexpr const char* quantization_extension = "KHR_mesh_quantization";

/// Of those that a file requires, the two that are understood here (EXT_meshopt_compression, KHR_mesh_quantization) and
/// those that say nothing of shape (materials, textures, lights, notes) are let pass. InputError unsupported names the
/// first other one. An extension that is used but not required, and would draw a mesh many times, is told in
/// `glb.remarks`.
void check_extensions(Glb& glb);

}  // namespace odontoscope::gltf
