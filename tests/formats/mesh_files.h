#pragma once
// Mesh files in memory, written by hand, and what is said of them when they are refused.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "recon/core/error.h"
#include "recon/formats/read_mesh.h"
#include "recon/mesh/surface_report.h"
#include "tests/mesh/shapes.h"

namespace odontoscope {

using Parser = std::vector<NamedMesh> (*)(std::string_view, const std::string&);

/// The cause that `bytes` is refused for; "accepted" if it is not.
inline std::string cause_of(Parser parse, const std::string& bytes) {
  try {
    parse(bytes, "file");
    return "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(error.place().line || error.place().byte) << error.what();
    return error.cause();
  }
}

template <typename Number>
void add(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(Number));
}

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), with);
}

inline std::string binary_stl(const SurfaceMesh& mesh, const std::string& header = "binary") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  add(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) add(bytes, 0.0f);
    for (const PointIndex v : t) {
      for (const double c : {mesh.points[v].x, mesh.points[v].y, mesh.points[v].z}) add(bytes, static_cast<float>(c));
    }
    add(bytes, std::uint16_t{7});
  }
  return bytes;
}

inline std::string ascii_stl(const SurfaceMesh& mesh, const std::string& name) {
  std::string text = "solid " + name + "\n";
  for (const Triangle& t : mesh.triangles) {
    text += "facet normal 0 0 0\n  outer loop\n";
    for (const PointIndex v : t) {
      const Point3& p = mesh.points[v];
      text += "    vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    text += "  endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}
inline const std::string obj_text =
    "# hello\r\nmtllib x.mtl\nv 0 0 0 1.0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\no first one\ng a b\ns off\nusemtl red\n"
    "f 1 3 2\nv 0 0 1\no\tsecond\nf 1/1 2/1/1 4//1\nf -3 -2 -1\nl 1 2\nf 1 4 3";

inline const std::string ply_text =
    "ply\r\nformat ascii 1.0\ncomment hello\nobj_info x\nelement vertex 4\nproperty float x\nproperty double y\n"
    "property uchar red\nproperty int z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
    "element face 4\nproperty float quality\nproperty list uchar int vertex_index\nproperty list uchar float "
    "uv\nend_header\n"
    "0 0 255 0\n1 0 1 0\n0 1 2 0\n0 0 3 1\n0 1\n"
    "0.5 3 0 2 1 0\n0.5 3 0 1 3 2 1 1\n1 3 1 2 3 0\n1 3 0 3 2 0\n";

template <typename Number>
void add_as(std::string& bytes, Number number, bool big) {
  std::string raw;
  add(raw, number);
  if (big) raw.assign(raw.rbegin(), raw.rend());
  bytes += raw;
}

inline std::string binary_ply(const SurfaceMesh& mesh, bool big) {
  std::string bytes = "ply\nformat " + std::string(big ? "binary_big_endian" : "binary_little_endian") +
                      " 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
                      "\nproperty double x\nproperty double y\nproperty float z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar uint vertex_indices\nproperty short tag\nend_header\n";
  for (const Point3& p : mesh.points) {
    add_as(bytes, p.x, big);
    add_as(bytes, p.y, big);
    add_as(bytes, static_cast<float>(p.z), big);
  }
  for (const Triangle& t : mesh.triangles) {
    add_as(bytes, std::uint8_t{3}, big);
    for (const PointIndex v : t) add_as(bytes, v, big);
    add_as(bytes, std::int16_t{-2}, big);
  }
  return bytes;
}

inline std::string glb(const std::string& json, const std::string& buffer) {
  std::string document = json, bytes = "glTF";
  while (document.size() % 4 != 0) document += ' ';
  add(bytes, std::uint32_t{2});
  add(bytes, static_cast<std::uint32_t>(12 + 8 + document.size() + 8 + buffer.size()));
  add(bytes, static_cast<std::uint32_t>(document.size()));
  add(bytes, std::uint32_t{0x4E4F534A});
  bytes += document;
  add(bytes, static_cast<std::uint32_t>(buffer.size()));
  add(bytes, std::uint32_t{0x004E4942});
  return bytes + buffer;
}

/// A tetrahedron of 1 m, with 16-bit indices and every vertex twice, as seams make them.
inline std::string tetrahedron_buffer() {
  std::string buffer;
  const SurfaceMesh mesh = shapes::tetrahedron();
  for (int copy = 0; copy < 2; ++copy) {
    for (const Point3& p : mesh.points) {
      for (const double c : {p.x, p.y, p.z}) add(buffer, static_cast<float>(c));
    }
  }
  for (std::size_t t = 0; t < 4; ++t) {
    for (const PointIndex v : mesh.triangles[t]) add(buffer, static_cast<std::uint16_t>(v + (t % 2 ? 4 : 0)));
  }
  return buffer;  // 96 + 24 bytes
}

inline const std::string tetrahedron_json =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1],"translation":[0,0,0]},)"
    R"({"name":"a tooth","mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":4}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
    R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":24}],)"
    R"("buffers":[{"byteLength":120}]})";

/// A box of 2 x 3 x 4 in OBJ; `ends` behind each line.
inline std::string box_of_quads(const std::string& ends) {
  std::string text;
  for (const char* line : {"v 0 0 0", "v 2 0 0", "v 2 3 0", "v 0 3 0", "v 0 0 4", "v 2 0 4", "v 2 3 4", "v 0 3 4",
                           "f 1 4 3 2", "f 5 6 7 8", "f 1 2 6 5", "f 2 3 7 6", "f 3 4 8 7", "f 4 1 5 8"}) {
    text += line + ends;
  }
  return text;
}

inline void expect_box(const NamedMesh& mesh) {
  const SurfaceReport report = inspect(mesh.surface);
  EXPECT_TRUE(report.closed_oriented_manifold());
  EXPECT_EQ(mesh.surface.triangles.size(), 12u);
  EXPECT_EQ(mesh.surface.points.size(), 8u);
}

}  // namespace odontoscope
