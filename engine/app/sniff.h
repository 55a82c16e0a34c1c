#pragma once
// What a file is, by what is in it and not by its name.

#include <string_view>

namespace odontoscope::app {

enum class FileKind { contour_stack, glb, ply, stl, volume, unknown };

/// By the signatures of the formats. Binary STL has none: its size must agree with its count of triangles.
FileKind kind_of(std::string_view bytes);

}  // namespace odontoscope::app
