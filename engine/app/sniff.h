#pragma once
// What a file is, by what is in it and not by its name.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recon/mesh/read_mesh.h"

namespace odontoscope::app {

enum class FileKind { contour_stack, glb, ply, stl, obj, volume, unknown };

/// By the signatures of the formats. Binary STL has none: its size must agree with its count of triangles. OBJ has none
/// either: its first line that says something must begin with one of its words.
FileKind kind_of(std::string_view bytes);

/// The meshes of a file of such a kind; nothing if it is none. Throws as the readers do.
std::optional<std::vector<NamedMesh>> meshes_in(FileKind kind, std::string_view bytes, const std::string& file);

}  // namespace odontoscope::app
