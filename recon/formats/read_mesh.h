#pragma once
// Triangle surfaces from files that anybody may have written: glTF (.glb and .gltf), STL (binary and ASCII), PLY (ASCII
// and binary), OBJ.
//
// What comes back is in millimetres, indices in range, coordinates finite; whether it is a manifold is for `inspect` to
// say. What was mended or left aside stands in NamedMesh::remarks.
//   glTF  each node with a mesh becomes a NamedMesh, all its primitives together: lists, strips and fans of triangles;
//   points
//         and lines are left out. Node transforms are applied, metres become millimetres, +y up becomes +z up. Vertices
//         of equal position are joined: normals and texture seams double them. Buffers lie in the .glb, in the JSON, or
//         in the file's folder or below. Extensions: gltf_extensions.h. Not supported, and said so: sparse accessors,
//         skins. Normals, materials, images, animation and morph targets are not looked at.
//   STL   equal coordinates are joined (-0 and 0 are equal), and walls that two surfaces share are parted
//   (part_walls.h). An ASCII file may hold several solids, and lack the last
//         "endsolid"; bytes behind a binary file's triangles are left aside. The numbers are taken as millimetres;
//         stored normals are not looked at, the order of the vertices counts.
//   PLY   elements `vertex` (x, y, z of any type), `face` (vertex_indices or vertex_index) and `tristrips` (-1 ends a
//   strip),
//         in any order; other elements and properties are skipped. The numbers are taken as millimetres.
//   OBJ   each object ("o") becomes a NamedMesh of its faces ("f"); groups, normals, textures, materials, lines and
//   points
//         are skipped. A backslash continues a line. The numbers are taken as millimetres.
// Faces of more than three corners are cut into triangles (cut_polygon.h). In PLY and OBJ vertices are joined by
// number, and by place at seams (join_seams.h). Lines end at LF, CR LF or CR.
//
// Throws FileError, UsageError (the ending tells no format), or InputError with one of these causes and the line or
// byte:
//   truncated           the file ends before what it announces
//   trailing-bytes      a text goes on after what it announces
//   bad-header          not the format that its ending says, or a header that makes no sense
//   unparsable          a word or number that is none, or JSON that is none or has not the shape that glTF asks for
//   not-finite, too-large   a coordinate (limits::largest_coordinate), or too many triangles (limits::triangles)
//   index-out-of-range  a triangle, node or accessor names what is not there
//   not-triangles       corners of a glTF list that make no whole triangles
//   bad-node-tree       a node that is its own ancestor or has two parents
//   unsupported         see above
//   empty-mesh          no triangle at all
// A count is checked against the bytes that are there before memory is taken for it.

#include <string>
#include <string_view>
#include <vector>

#include "recon/mesh/named_mesh.h"

namespace odontoscope {

/// ".glb", ".gltf", ".stl", ".ply", ".obj".
const std::vector<std::string>& mesh_endings();

/// The format follows from the file's ending, in any case. Control characters in names are replaced.
std::vector<NamedMesh> read_mesh(const std::string& file);

/// The same from memory; `file` is for messages.
std::vector<NamedMesh> parse_glb(std::string_view bytes, const std::string& file);
std::vector<NamedMesh> parse_gltf(std::string_view bytes, const std::string& file);  // reads files beside `file`, too
std::vector<NamedMesh> parse_stl(std::string_view bytes, const std::string& file);
std::vector<NamedMesh> parse_ply(std::string_view bytes, const std::string& file);
std::vector<NamedMesh> parse_obj(std::string_view bytes, const std::string& file);

}  // namespace odontoscope
