#pragma once
// What a file is: by what is in it, and by its name only where that does not tell.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recon/formats/read_mesh.h"

namespace odontoscope::app {

enum class FileKind { contour_stack, glb, ply, stl, obj, gltf, volume, unknown };

/// By the signatures of the formats. Binary STL has none: its size must agree with its count of triangles. OBJ has none
/// either: its first line that says something must begin with one of its words. `file`: of what its bytes do not tell,
/// one that is called .stl or .obj is taken for that; of JSON, one that is called .gltf, or that has glTF's key "asset"
/// near its beginning, is glTF.
FileKind kind_of(std::string_view bytes, const std::string& file = {});

/// The meshes of a file of such a kind; nothing if it is none. Throws as the readers do.
std::optional<std::vector<NamedMesh>> meshes_in(FileKind kind, std::string_view bytes, const std::string& file);

/// "dentine" for the meshes "dentine external", "dentine cavity", "dentine open" and their like with underscores: our
/// own GLB and OBJ files give a structure's outside and its cavities a mesh each.
std::string structure_of_mesh(const std::string& mesh);

}  // namespace odontoscope::app
