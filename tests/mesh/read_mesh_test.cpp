// Mesh files as anybody may write them: what is right is read, what is wrong is named.

#include "recon/mesh/read_mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

#include "recon/core/error.h"
#include "recon/mesh/surface_report.h"
#include "tests/mesh/shapes.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope {
namespace {

using Parser = std::vector<NamedMesh> (*)(std::string_view, const std::string&);

/// The cause that `bytes` is refused for; "accepted" if it is not.
std::string cause_of(Parser parse, const std::string& bytes) {
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

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), with);
}

// --- STL -----------------------------------------------------------------------------------------------------------

std::string binary_stl(const SurfaceMesh& mesh, const std::string& header = "binary") {
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

std::string ascii_stl(const SurfaceMesh& mesh, const std::string& name) {
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

TEST(ReadStl, BinaryEvenWhenItBeginsWithSolid) {
  for (const std::string header : {"binary", "solid but binary"}) {
    const auto meshes = parse_stl(binary_stl(shapes::cube(), header), "file");
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].surface.points.size(), 8u);
    EXPECT_TRUE(inspect(meshes[0].surface).closed_oriented_manifold());
    EXPECT_DOUBLE_EQ(inspect(meshes[0].surface).shells[0].volume, 1);
  }
}

TEST(ReadStl, AsciiWithSeveralSolids) {
  std::string text = ascii_stl(shapes::cube(), "one two") + ascii_stl(shapes::tetrahedron(), "");
  text = replaced(text, "facet normal 0 0 0", "FACET  NORMAL +0 -0 1e-400");
  const auto meshes = parse_stl(text, "file");
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].name, "one two");
  EXPECT_EQ(meshes[1].name, "");
  EXPECT_EQ(meshes[0].surface.triangles.size(), 12u);
  EXPECT_TRUE(inspect(meshes[1].surface).closed_oriented_manifold());
}

TEST(ReadStl, EveryTruncationIsRefused) {
  const std::string binary = binary_stl(shapes::tetrahedron()), text = ascii_stl(shapes::tetrahedron(), "t");
  for (std::size_t n = 1; n < binary.size(); ++n) {
    EXPECT_EQ(cause_of(parse_stl, binary.substr(0, n)), "truncated") << n;
  }
  const std::size_t complete_at = text.size() - std::string(" t\n").size();  // the name may be missing
  for (std::size_t n = std::string("solid").size(); n < complete_at; ++n) {
    const std::string cut = text.substr(0, n);
    if (cause_of(parse_stl, cut) != "accepted") continue;
    // Between two facets only the missing end shows, and it is told.
    EXPECT_TRUE(cut.substr(0, cut.find_last_not_of(" \n") + 1).ends_with("endfacet") || cut.ends_with("endsolid")) << n;
    EXPECT_EQ(parse_stl(cut, "file").front().remarks.empty(), cut.ends_with("endsolid")) << n;
  }
}

TEST(ReadStl, WrongFilesAreNamed) {
  const std::string binary = binary_stl(shapes::tetrahedron()), text = ascii_stl(shapes::tetrahedron(), "t");
  EXPECT_EQ(cause_of(parse_stl, ""), "empty-mesh");
  EXPECT_EQ(cause_of(parse_stl, binary_stl({})), "empty-mesh");
  EXPECT_EQ(cause_of(parse_stl, "solid\nendsolid\n"), "empty-mesh");
  EXPECT_EQ(parse_stl(binary + "x", "file").front().remarks.size(), 1u);
  std::string lying = binary;
  const std::uint32_t huge = 0xffffffff;
  std::memcpy(lying.data() + 80, &huge, 4);
  EXPECT_EQ(cause_of(parse_stl, lying), "truncated");
  std::string nan = binary;
  const float not_a_number = std::numeric_limits<float>::quiet_NaN(), large = 1e30f;
  std::memcpy(nan.data() + 84 + 12, &not_a_number, 4);
  EXPECT_EQ(cause_of(parse_stl, nan), "not-finite");
  std::memcpy(nan.data() + 84 + 12, &large, 4);
  EXPECT_EQ(cause_of(parse_stl, nan), "too-large");
  EXPECT_EQ(cause_of(parse_stl, replaced(text, "vertex 0.000000", "vertex nan")), "not-finite");
  EXPECT_EQ(cause_of(parse_stl, replaced(text, "vertex 0.000000", "vertex 1e999")), "not-finite");
  EXPECT_EQ(cause_of(parse_stl, replaced(text, "vertex 0.000000", "vertex 1e7")), "too-large");
  EXPECT_EQ(cause_of(parse_stl, replaced(text, "vertex 0.000000", "vertex 0,5")), "unparsable");
  EXPECT_EQ(cause_of(parse_stl, replaced(text, "endloop", "vertex 1 2 3 endloop")), "unparsable");
}

TEST(ReadStl, TextErrorsNameTheLine) {
  try {
    parse_stl(replaced(ascii_stl(shapes::tetrahedron(), "t"), "endloop", "endlop"), "tooth.stl");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().line, 7u);
    EXPECT_NE(std::string(error.what()).find("tooth.stl:7"), std::string::npos) << error.what();
  }
}

// --- OBJ -----------------------------------------------------------------------------------------------------------

const std::string obj_text =
    "# hello\r\nmtllib x.mtl\nv 0 0 0 1.0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\no first one\ng a b\ns off\nusemtl red\n"
    "f 1 3 2\nv 0 0 1\no\tsecond\nf 1/1 2/1/1 4//1\nf -3 -2 -1\nl 1 2\nf 1 4 3";

TEST(ReadObj, ObjectsWithTheirOwnVertices) {
  const auto meshes = parse_obj(obj_text, "file");
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].name, "first one");
  EXPECT_EQ(meshes[0].surface.points.size(), 3u);
  EXPECT_EQ(meshes[1].name, "second");
  EXPECT_EQ(meshes[1].surface.triangles.size(), 3u);
  EXPECT_EQ(meshes[1].surface.points.size(), 4u);
  const Triangle& relative = meshes[1].surface.triangles[1];  // the last three
  EXPECT_EQ(meshes[1].surface.points[relative[2]], (Point3{0, 0, 1}));
  EXPECT_TRUE(
      inspect(parse_obj(replaced(obj_text, "o\tsecond\n", ""), "file").at(0).surface).closed_oriented_manifold());
}

TEST(ReadObj, WrongFilesAreNamed) {
  EXPECT_EQ(cause_of(parse_obj, ""), "empty-mesh");
  EXPECT_EQ(cause_of(parse_obj, "v 0 0 0\n"), "empty-mesh");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "f 1 3 2", "f 1 3 4")), "index-out-of-range");  // 4 comes later
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "f 1 3 2", "f 0 3 2")), "index-out-of-range");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "-3 -2 -1", "-5 -2 -1")), "index-out-of-range");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "f 1 3 2", "f 1 3 nan")), "unparsable");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "f 1 3 2", "f 1 3 1e30")), "index-out-of-range");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "f 1 3 2", "f 1 3 2.5")), "unparsable");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "v 1 0 0", "v 1 0")), "unparsable");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "v 1 0 0", "v 1 0 x")), "unparsable");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "v 1 0 0", "v 1 0 inf")), "not-finite");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "v 1 0 0", "v 1 0 1e7")), "too-large");
  EXPECT_EQ(cause_of(parse_obj, replaced(obj_text, "usemtl", "usemtk")), "unparsable");
  try {
    parse_obj(replaced(obj_text, "s off", "soft off"), "tooth.obj");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().line, 10u);
  }
}

// --- PLY -----------------------------------------------------------------------------------------------------------

const std::string ply_text =
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

std::string binary_ply(const SurfaceMesh& mesh, bool big) {
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

TEST(ReadPly, AsciiWithMoreThanIsNeeded) {
  const auto meshes = parse_ply(ply_text, "file");
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].surface.points, shapes::tetrahedron().points);
  EXPECT_EQ(meshes[0].surface.triangles, shapes::tetrahedron().triangles);
}

TEST(ReadPly, BinaryOfBothByteOrders) {
  for (const bool big : {false, true}) {
    const auto meshes = parse_ply(binary_ply(shapes::sphere(3, 2), big), "file");
    EXPECT_EQ(meshes.at(0).surface.triangles, shapes::sphere(3, 2).triangles);
    EXPECT_NEAR(meshes[0].surface.points[17].z, shapes::sphere(3, 2).points[17].z, 1e-6);
    EXPECT_EQ(meshes[0].surface.points[17].x, shapes::sphere(3, 2).points[17].x);
  }
}

TEST(ReadPly, EveryTruncationIsRefused) {
  const std::string binary = binary_ply(shapes::tetrahedron(), false);
  for (std::size_t n = 0; n < binary.size(); ++n) EXPECT_NE(cause_of(parse_ply, binary.substr(0, n)), "accepted") << n;
  for (std::size_t n = 0; n + 2 < ply_text.size();
       ++n) {  // without the last digit it is no number, without the line end it is whole
    EXPECT_NE(cause_of(parse_ply, ply_text.substr(0, n)), "accepted") << n;
  }
}

TEST(ReadPly, WrongFilesAreNamed) {
  const auto cause = [](const std::string& what, const std::string& with) {
    return cause_of(parse_ply, replaced(ply_text, what, with));
  };
  EXPECT_EQ(cause("ply\r\n", "plx\n"), "bad-header");
  EXPECT_EQ(cause("ascii 1.0", "ascii 2.0"), "bad-header");
  EXPECT_EQ(cause("ascii", "middle_endian"), "bad-header");
  EXPECT_EQ(cause("format ascii 1.0\n", ""), "bad-header");
  EXPECT_EQ(cause("property int z", "property int w"), "bad-header");
  EXPECT_EQ(cause("property int z", "property long z"), "bad-header");
  EXPECT_EQ(cause("vertex_index\n", "vertices\n"), "bad-header");
  EXPECT_EQ(cause("element vertex 4", "element vertex -4"), "bad-header");
  EXPECT_EQ(cause("element vertex 4", "element vertex 4.5"), "bad-header");
  EXPECT_EQ(cause("element vertex 4", "element vertex 4000000000000"), "truncated");
  EXPECT_EQ(cause("element vertex 4", "element nothing 4000000000000\nelement vertex 4"), "bad-header");
  EXPECT_EQ(cause("1 0 1 0\n", "nan 0 1 0\n"), "not-finite");
  EXPECT_EQ(cause("1 0 1 0\n", "1 -inf 1 0\n"), "not-finite");
  EXPECT_EQ(cause("1 0 1 0\n", "1 2e6 1 0\n"), "too-large");
  EXPECT_EQ(cause("1 0 1 0\n", "1 0 1 0.5\n"), "unparsable");
  EXPECT_EQ(cause("0.5 3 0 2 1 0\n", "0.5 3 0 2 4 0\n"), "index-out-of-range");
  EXPECT_EQ(cause("0.5 3 0 2 1 0\n", "0.5 3 0 2 -1 0\n"), "index-out-of-range");
  EXPECT_EQ(cause("0.5 3 0 2 1 0\n", "0.5 3000000 0 2 1 0\n"), "truncated");
  EXPECT_EQ(cause_of(parse_ply, ply_text + "1"), "trailing-bytes");
  EXPECT_EQ(cause_of(parse_ply, "ply\nformat ascii 1.0\nend_header\n"), "empty-mesh");
  EXPECT_EQ(cause_of(parse_ply, std::string(100'000, 'a')), "bad-header");
}

TEST(ReadPly, ErrorsNameLineOrByte) {
  try {
    parse_ply(replaced(ply_text, "0 1 2 0\n", "0 one 2 0\n"), "tooth.ply");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().line, 20u);
  }
}

// --- GLB -----------------------------------------------------------------------------------------------------------

std::string glb(const std::string& json, const std::string& buffer) {
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
std::string tetrahedron_buffer() {
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

const std::string tetrahedron_json =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1],"translation":[0,0,0]},)"
    R"({"name":"a tooth","mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":4}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
    R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":24}],)"
    R"("buffers":[{"byteLength":120}]})";

TEST(ReadGlb, WeldsScalesAndTurns) {
  const auto meshes = parse_glb(glb(tetrahedron_json, tetrahedron_buffer()), "file");
  ASSERT_EQ(meshes.size(), 1u);
  EXPECT_EQ(meshes[0].name, "a tooth");
  const SurfaceMesh& mesh = meshes[0].surface;
  ASSERT_EQ(mesh.points.size(), 4u);
  // Metres to millimetres; glTF's +y is our +z, its +z our -y.
  EXPECT_EQ(mesh.points[1], (Point3{1000, 0, 0}));
  EXPECT_EQ(mesh.points[2], (Point3{0, 0, 1000}));
  EXPECT_EQ(mesh.points[3], (Point3{0, -1000, 0}));
  EXPECT_TRUE(inspect(mesh).closed_oriented_manifold());
  EXPECT_GT(inspect(mesh).shells[0].volume, 0);
}

TEST(ReadGlb, TransformsApplyFromTheLeafUp) {
  // Scaled by 2 and turned by 90 degrees about z, then moved.
  const std::string with =
      replaced(tetrahedron_json, R"("mesh":0})",
               R"("mesh":0,"scale":[2,2,2],"rotation":[0,0,0.7071067811865476,0.7071067811865476]})");
  const auto meshes =
      parse_glb(glb(replaced(with, "\"translation\":[0,0,0]", "\"translation\":[10,0,0]"), tetrahedron_buffer()), "f");
  const Point3 p = meshes.at(0).surface.points.at(1);  // (1,0,0) to (0,2,0) to (10,2,0) m
  EXPECT_NEAR(p.x, 10'000, 1e-9);
  EXPECT_NEAR(p.y, 0, 1e-9);
  EXPECT_NEAR(p.z, 2000, 1e-9);
}

TEST(ReadGlb, MirroringTurnsTheTrianglesAround) {
  for (const std::string how : {R"("scale":[-1,1,1])", R"("matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])"}) {
    const auto meshes = parse_glb(
        glb(replaced(tetrahedron_json, R"("mesh":0})", R"("mesh":0,)" + how + "}"), tetrahedron_buffer()), "f");
    EXPECT_GT(inspect(meshes.at(0).surface).shells.at(0).volume, 0);
  }
}

/// The tetrahedron's places as whole numbers, `one` for a metre, twelve bytes a vertex.
template <typename Number>
std::vector<NamedMesh> quantized(int type, Number one, bool normalized, const std::string& extensions) {
  std::string buffer = tetrahedron_buffer();
  for (std::size_t i = 0; i < 24; ++i) {
    float metres = 0;
    std::memcpy(&metres, buffer.data() + 4 * i, sizeof(metres));
    const auto number = static_cast<Number>(metres * static_cast<float>(one));
    std::memcpy(buffer.data() + 12 * (i / 3) + sizeof(Number) * (i % 3), &number, sizeof(number));
  }
  std::string json =
      replaced(tetrahedron_json, "5126", std::to_string(type) + (normalized ? ",\"normalized\":true" : ""));
  json = replaced(json, "\"byteLength\":96", "\"byteLength\":96,\"byteStride\":12");
  return parse_glb(glb(replaced(json, "\"scene\":0", "\"scene\":0" + extensions), buffer), "f");
}

TEST(ReadGlb, QuantizedPlacesAreThoseMeant) {
  const std::string used =
      ",\"extensionsUsed\":[\"KHR_mesh_quantization\"],\"extensionsRequired\":[\"KHR_mesh_quantization\"]";
  const std::vector<Point3> wanted = parse_glb(glb(tetrahedron_json, tetrahedron_buffer()), "f").at(0).surface.points;
  EXPECT_EQ(quantized<std::int8_t>(5120, 127, true, used).at(0).surface.points, wanted);
  EXPECT_EQ(quantized<std::uint8_t>(5121, 255, true, used).at(0).surface.points, wanted);
  EXPECT_EQ(quantized<std::int16_t>(5122, 32767, true, used).at(0).surface.points, wanted);
  EXPECT_EQ(quantized<std::uint16_t>(5123, 65535, true, used).at(0).surface.points, wanted);
  EXPECT_EQ(quantized<std::uint16_t>(5123, 1, false, used).at(0).surface.points, wanted);
  EXPECT_EQ(quantized<std::int16_t>(5122, 3, false, used).at(0).surface.points.at(1), (Point3{3000, 0, 0}));
  EXPECT_EQ(quantized<std::int8_t>(5120, -128, true, used).at(0).surface.points.at(1), (Point3{-1000, 0, 0}))
      << "the spec holds it to -1";
  EXPECT_THROW(quantized<std::int16_t>(5122, 1, false, ""), InputError);
}

TEST(ReadGlb, EveryTruncationIsRefused) {
  const std::string whole = glb(tetrahedron_json, tetrahedron_buffer());
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_NE(cause_of(parse_glb, whole.substr(0, n)), "accepted") << n;
}

TEST(ReadGlb, WrongFilesAreNamed) {
  const std::string buffer = tetrahedron_buffer();
  const auto cause = [&](const std::string& what, const std::string& with) {
    return cause_of(parse_glb, glb(replaced(tetrahedron_json, what, with), buffer));
  };
  EXPECT_EQ(cause("\"asset\"", "asset"), "unparsable");
  EXPECT_EQ(cause("\"nodes\":[0]", "\"nodes\":[7]"), "index-out-of-range");
  EXPECT_EQ(cause("\"nodes\":[0]", "\"nodes\":0"), "unparsable");
  EXPECT_EQ(cause("\"nodes\":[0]", "\"nodes\":[-1]"), "unparsable");
  EXPECT_EQ(cause("\"nodes\":[0]", "\"nodes\":[0.5]"), "unparsable");
  EXPECT_EQ(cause("\"nodes\":[0]", "\"nodes\":[]"), "empty-mesh");
  EXPECT_EQ(cause("\"children\":[1]", "\"children\":[1,1]"), "bad-node-tree");
  EXPECT_EQ(cause("\"children\":[1]", "\"children\":[0]"), "bad-node-tree");
  EXPECT_EQ(cause("[0,0,0]", "[0,0]"), "unparsable");
  EXPECT_EQ(cause("[0,0,0]", "[0,0,\"a\"]"), "unparsable");
  EXPECT_EQ(cause("[0,0,0]", "[0,0,1e5]"), "too-large");
  EXPECT_EQ(cause("\"mesh\":0", "\"mesh\":1"), "index-out-of-range");
  EXPECT_EQ(cause("\"mesh\":0", "\"mesh\":0,\"skin\":0"), "unsupported");
  EXPECT_EQ(cause("\"mode\":4", "\"mode\":1"), "empty-mesh");
  EXPECT_EQ(cause("\"mode\":4", "\"mode\":7"), "unparsable");
  EXPECT_EQ(cause("\"count\":8", "\"count\":9"), "truncated");
  EXPECT_EQ(cause("\"count\":8", "\"count\":9007199254740991"), "truncated");
  EXPECT_EQ(cause("\"count\":8", "\"count\":1e300"), "unparsable");
  EXPECT_EQ(cause("\"count\":8", "\"count\":7"), "index-out-of-range");
  EXPECT_EQ(cause("\"count\":12", "\"count\":11"), "not-triangles");
  EXPECT_EQ(cause("5126", "5123"), "unsupported");
  EXPECT_EQ(cause("5123", "5122"), "unsupported");
  EXPECT_EQ(cause("5123", "5120"), "unsupported");
  EXPECT_EQ(cause("\"VEC3\"", "\"VEC4\""), "unsupported");
  EXPECT_EQ(cause("\"type\":\"VEC3\"", "\"type\":\"VEC3\",\"sparse\":{}"), "unsupported");
  EXPECT_EQ(cause("\"byteLength\":96", "\"byteLength\":96,\"byteStride\":8"), "unparsable");
  EXPECT_EQ(cause("\"byteOffset\":96", "\"byteOffset\":97"), "truncated");
  EXPECT_EQ(cause("\"byteOffset\":96", "\"byteOffset\":9007199254740991"), "truncated");
  EXPECT_EQ(cause("{\"byteLength\":120}", "{\"byteLength\":120,\"uri\":\"/etc/passwd\"}"), "unsupported");
  EXPECT_EQ(cause("\"scene\":0", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]"), "unsupported");
  std::string bytes = glb(tetrahedron_json, buffer);
  EXPECT_EQ(parse_glb(bytes + "abcd", "file").front().remarks.size(), 1u);
  bytes[4] = 1;
  EXPECT_EQ(cause_of(parse_glb, bytes), "bad-header");
  std::string nan = buffer;
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(nan.data(), &not_a_number, 4);
  EXPECT_EQ(cause_of(parse_glb, glb(tetrahedron_json, nan)), "not-finite");
}

TEST(ReadGlb, DeepNestingIsNoHarm) {
  constexpr std::size_t depth = 2'000'000;
  const std::string nest = std::string(depth, '[') + std::string(depth, ']');
  EXPECT_EQ(cause_of(parse_glb,
                     glb(replaced(tetrahedron_json, "\"children\":[1]", "\"children\":" + nest), tetrahedron_buffer())),
            "unparsable");
  EXPECT_EQ(
      cause_of(parse_glb, glb(replaced(tetrahedron_json, "\"scene\":0", "\"extras\":" + nest), tetrahedron_buffer())),
      "accepted");
}

/// A few bytes changed, a stretch removed or doubled: what a bad disk or a bad mind makes of a file.
std::string damaged(std::string bytes, std::mt19937& random) {
  const auto place = [&] { return random() % bytes.size(); };
  for (std::size_t change = 0; change <= random() % 4 && !bytes.empty(); ++change) {
    const std::size_t at = place(), length = std::min<std::size_t>(1 + random() % 8, bytes.size() - at);
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = "0129-.,eE[]{}\"\n "[random() % 16];
        break;
      case 2:
        bytes.erase(at, length);
        break;
      default:
        bytes.insert(place(), bytes.substr(at, length));
    }
  }
  return bytes;
}

TEST(ReadMesh, DamagedFilesAreReadOrRefusedNeverWorse) {
  struct Case {
    Parser parse;
    std::string bytes;
  };
  const Case cases[] = {{parse_stl, binary_stl(shapes::tetrahedron())},
                        {parse_stl, ascii_stl(shapes::tetrahedron(), "t")},
                        {parse_ply, ply_text},
                        {parse_ply, binary_ply(shapes::tetrahedron(), false)},
                        {parse_ply, binary_ply(shapes::tetrahedron(), true)},
                        {parse_glb, glb(tetrahedron_json, tetrahedron_buffer())}};
  std::mt19937 random(1);
  std::size_t refused = 0, read = 0;
  for (const Case& one : cases) {
    for (int round = 0; round < 3000; ++round) {
      try {
        for (const NamedMesh& mesh : one.parse(damaged(one.bytes, random), "file")) {
          for (const Triangle& t : mesh.surface.triangles) {
            for (const PointIndex v : t) ASSERT_LT(v, mesh.surface.points.size());
          }
          inspect(mesh.surface);
        }
        ++read;
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 5000u);
  EXPECT_GT(read, 500u);
}

TEST(ReadMesh, TheEndingDecides) {
  EXPECT_THROW(read_mesh("tooth.off"), UsageError);
  EXPECT_THROW(read_mesh("/nowhere/tooth.STL"), FileError);
}

/// A box of 2 x 3 x 4 in OBJ; `ends` behind each line.
std::string box_of_quads(const std::string& ends) {
  std::string text;
  for (const char* line : {"v 0 0 0", "v 2 0 0", "v 2 3 0", "v 0 3 0", "v 0 0 4", "v 2 0 4", "v 2 3 4", "v 0 3 4",
                           "f 1 4 3 2", "f 5 6 7 8", "f 1 2 6 5", "f 2 3 7 6", "f 3 4 8 7", "f 4 1 5 8"}) {
    text += line + ends;
  }
  return text;
}

void expect_box(const NamedMesh& mesh) {
  const SurfaceReport report = inspect(mesh.surface);
  EXPECT_TRUE(report.closed_oriented_manifold());
  EXPECT_EQ(mesh.surface.triangles.size(), 12u);
  EXPECT_EQ(mesh.surface.points.size(), 8u);
}

TEST(ReadObj, PolygonsAreCutHoweverLinesEnd) {
  for (const char* ends : {"\n", "\r\n", "\r", " # a box\r", "\n\n"}) {
    const auto meshes = parse_obj(box_of_quads(ends), "file");
    ASSERT_EQ(meshes.size(), 1u);
    expect_box(meshes.front());
    ASSERT_EQ(meshes.front().remarks.size(), 1u);
    EXPECT_TRUE(meshes.front().remarks.front().starts_with("6 faces")) << meshes.front().remarks.front();
  }
}

TEST(ReadObj, ABackslashContinuesTheLine) {
  expect_box(parse_obj(replaced(box_of_quads("\n"), "f 5 6 7 8", "f 5 6 \\\n7 \\ \n 8"), "file").front());
}

TEST(ReadObj, APolygonThatTurnsInwardsKeepsItsShape) {
  // An L: a fan from its first corner would leave it.
  std::string text;
  for (const char* z : {" 0\n", " 1\n"}) {
    for (const char* xy : {"v 2 1", "v 1 1", "v 1 2", "v 0 2", "v 0 0", "v 2 0"}) text += std::string(xy) + z;
  }
  text += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int i = 1; i <= 6; ++i)
    text += "f " + std::to_string(i) + " " + std::to_string(i % 6 + 1) + " " + std::to_string(i % 6 + 7) + " " +
            std::to_string(i + 6) + "\n";
  const SurfaceMesh mesh = parse_obj(text, "file").front().surface;
  EXPECT_TRUE(inspect(mesh).closed_oriented_manifold());
  double area_above = 0;
  for (const Triangle& t : mesh.triangles) {
    const Point3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    if (a.z != 1 || b.z != 1 || c.z != 1) continue;
    const double area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    EXPECT_GT(area, 0);
    area_above += area;
  }
  EXPECT_EQ(area_above, 3);
}

TEST(ReadObj, SeamsAreJoinedAndSaidButTouchingCornersAreNot) {
  const auto doubled = [](double shift) {
    const SurfaceMesh mesh = shapes::tetrahedron();
    std::string text;
    for (const Triangle& t : mesh.triangles) {
      for (const PointIndex v : t) {
        const Point3& p = mesh.points[v];
        text += "v " + std::to_string(p.x + shift) + " " + std::to_string(p.y + shift) + " " +
                std::to_string(p.z + shift) + "\n";
      }
      text += "f -3 -2 -1\n";
    }
    return text;
  };
  const NamedMesh mesh = parse_obj(doubled(0), "file").front();
  EXPECT_EQ(mesh.surface.points.size(), 4u);
  EXPECT_TRUE(inspect(mesh.surface).closed_oriented_manifold());
  ASSERT_EQ(mesh.remarks.size(), 1u);
  EXPECT_NE(mesh.remarks.front().find("seams joined: 8"), std::string::npos) << mesh.remarks.front();
  EXPECT_EQ(parse_obj(doubled(0) + doubled(8), "file").front().surface.points.size(), 8u);
}

TEST(ReadPly, PolygonsStripsAndFacesFirst) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string header = "ply\nformat ascii 1.0\n",
                    element = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string strips = header + element +
                             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + vertices +
                             "9 0 1 3 2 0 1 -1 2 2\n";
  const auto stripped = parse_ply(strips, "file");
  EXPECT_EQ(stripped.front().surface.triangles.size(), 4u);
  EXPECT_TRUE(inspect(stripped.front().surface).closed_oriented_manifold());
  const std::string faces = "element face 4\nproperty list uchar int vertex_indices\n",
                    rows = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  EXPECT_TRUE(inspect(parse_ply(header + faces + element + "end_header\n" + rows + vertices, "file").front().surface)
                  .closed_oriented_manifold());
  EXPECT_EQ(
      cause_of(parse_ply, header + faces + element + "end_header\n" + replaced(rows, "3 2 0 3", "3 2 0 4") + vertices),
      "index-out-of-range");
}

TEST(ReadGlb, ExtensionsThatSayNothingOfShapeMayBeRequired) {
  const auto cause = [](const std::string& name) {
    return cause_of(parse_glb, glb(replaced(tetrahedron_json, "\"scene\":0",
                                            "\"scene\":0,\"extensionsRequired\":[\"" + name + "\"]"),
                                   tetrahedron_buffer()));
  };
  EXPECT_EQ(cause("KHR_materials_unlit"), "accepted");
  EXPECT_EQ(cause("KHR_texture_transform"), "accepted");
  EXPECT_EQ(cause("KHR_draco_mesh_compression"), "unsupported");
  EXPECT_EQ(cause("EXT_of_nobody"), "unsupported");
}

TEST(ReadObj, AFaceWithAHoleDrawnInOneLineStaysOpenThere) {
  // A square frame of height 1: its top and bottom go round outside, in over a bridge, round the hole, and back.
  std::string text;
  for (const char* z : {" 0\n", " 1\n"}) {
    for (const char* xy : {"v 0 0", "v 4 0", "v 4 4", "v 0 4", "v 1 1", "v 3 1", "v 3 3", "v 1 3"})
      text += std::string(xy) + z;
  }
  text += "f 9 10 11 12 9 13 16 15 14 13\nf 1 5 6 7 8 5 1 4 3 2\n";
  for (int i = 1; i <= 4; ++i) {
    const int n = i % 4 + 1;
    text += "f " + std::to_string(i) + " " + std::to_string(n) + " " + std::to_string(n + 8) + " " +
            std::to_string(i + 8) + "\n";
    text += "f " + std::to_string(n + 4) + " " + std::to_string(i + 4) + " " + std::to_string(i + 12) + " " +
            std::to_string(n + 12) + "\n";
  }
  const SurfaceReport report = inspect(parse_obj(text, "file").front().surface);
  EXPECT_TRUE(report.closed_oriented_manifold());
  ASSERT_EQ(report.shells.size(), 1u);
  EXPECT_EQ(report.shells[0].genus, 1);
  EXPECT_DOUBLE_EQ(report.shells[0].volume, 12);
}

TEST(ReadObj, TwoFacesOnTheSameFourCornersAreCutAlongDifferentDiagonals) {
  const auto meshes = parse_obj("v 0 0 0\nv 1 0 1\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\nf 4 3 2 1\n", "file");
  const SurfaceReport report = inspect(meshes.front().surface);
  EXPECT_TRUE(report.closed_oriented_manifold());
  EXPECT_EQ(report.triangles, 4u);
  EXPECT_NE(meshes.front().remarks.at(0).find("2 are not flat, by up to 0.5 mm"), std::string::npos)
      << meshes.front().remarks[0];
}

/// A prism over any ring of places, both ends one face, from random numbers: bent, turning inwards, crossing itself.
TEST(ReadObj, WhateverItsFacesTheBoundaryStaysClosedAndOriented) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const int n = 3 + static_cast<int>(random() % 12);
    std::string text;
    for (int ring = 0; ring < 2; ++ring) {
      for (int i = 0; i < n; ++i) {
        // Of a lattice, so that places repeat and lines are straight.
        text += "v " + std::to_string(random() % 5) + " " + std::to_string(random() % 5) + " " +
                std::to_string(static_cast<int>(random() % 3) + 4 * ring) + "\n";
      }
    }
    std::string low = "f", high = "f";
    for (int i = 1; i <= n; ++i) {
      const int next = i % n + 1;
      low += " " + std::to_string(n + 1 - i);
      high += " " + std::to_string(n + i);
      text += "f " + std::to_string(i) + " " + std::to_string(next) + " " + std::to_string(next + n) + " " +
              std::to_string(i + n) + "\n";
    }
    const SurfaceReport report = inspect(parse_obj(text + low + "\n" + high + "\n", "file").front().surface);
    EXPECT_EQ(report.boundary_edges, 0u) << text;
    EXPECT_EQ(report.misoriented_edges, 0u) << text;
    EXPECT_EQ(report.triangles, static_cast<std::size_t>(2 * n + 2 * (n - 2)));
  }
}

TEST(ReadObj, FreeFormSurfacesAreRefusedByName) {
  EXPECT_EQ(cause_of(parse_obj, box_of_quads("\n") + "cstype bspline\ndeg 3 3\n"), "unsupported");
}

TEST(ReadStl, ASolidWithoutItsEndMayBeFollowedByTheNext) {
  const std::string first = replaced(ascii_stl(shapes::tetrahedron(), "a"), "endsolid a\n", "");
  const auto meshes = parse_stl(first + ascii_stl(shapes::cube(), "b"), "file");
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].remarks.size(), 1u);
  EXPECT_TRUE(meshes[1].remarks.empty());
  for (const NamedMesh& mesh : meshes) EXPECT_TRUE(inspect(mesh.surface).closed_oriented_manifold());
}

TEST(ReadStl, LinesMayEndAsOfOldAndBinaryFilesMayBeginWithSolid) {
  std::string text = ascii_stl(shapes::tetrahedron(), "t");
  for (char& c : text) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(parse_stl(text, "file").front().name, "t");
  const auto meshes = parse_stl(binary_stl(shapes::cube(), "solid but binary") + "\n", "file");
  EXPECT_EQ(meshes.front().surface.triangles.size(), 12u);
  EXPECT_EQ(meshes.front().remarks.size(), 1u);
}

TEST(ReadPly, BehindAHeaderOfOldLineEndsTheFirstByteIsANumber) {
  std::string bytes = binary_ply(shapes::cube(), false);
  const std::size_t end = bytes.find("end_header\n") + std::string("end_header\n").size();
  for (std::size_t i = 0; i < end; ++i) bytes[i] = bytes[i] == '\n' ? '\r' : bytes[i];
  EXPECT_TRUE(inspect(parse_ply(bytes, "file").front().surface).closed_oriented_manifold());
  const auto behind = parse_ply(binary_ply(shapes::cube(), false) + "\n", "file");
  EXPECT_EQ(behind.front().remarks.size(), 1u);
}

// --- glTF: strips and fans, data beside and inside -------------------------------------------------------------------

/// The tetrahedron's corners as those of the given primitive, and its vertices.
std::string with_indices(const std::vector<std::uint16_t>& indices, int mode) {
  std::string buffer = tetrahedron_buffer().substr(0, 96);
  for (const std::uint16_t index : indices) add(buffer, index);
  const std::string count = std::to_string(indices.size()), bytes = std::to_string(2 * indices.size());
  std::string json = replaced(tetrahedron_json, "\"count\":12", "\"count\":" + count);
  json = replaced(json, "\"byteLength\":24", "\"byteLength\":" + bytes);
  json = replaced(json, "\"byteLength\":120", "\"byteLength\":" + std::to_string(buffer.size()));
  return glb(replaced(json, "\"mode\":4", "\"mode\":" + std::to_string(mode)), buffer);
}

TEST(ReadGlb, StripsAndFansOfTriangles) {
  const Triangle t = shapes::tetrahedron().triangles[0];
  const auto a = static_cast<std::uint16_t>(t[0]), b = static_cast<std::uint16_t>(t[1]),
             c = static_cast<std::uint16_t>(t[2]);
  const std::uint16_t d = static_cast<std::uint16_t>(6 - a - b - c);
  const SurfaceReport strip = inspect(parse_glb(with_indices({a, b, c, d, a, b}, 5), "f").front().surface);
  EXPECT_TRUE(strip.closed_oriented_manifold());
  EXPECT_EQ(strip.triangles, 4u);
  EXPECT_GT(strip.shells[0].volume, 0);
  const SurfaceReport fan = inspect(parse_glb(with_indices({d, a, c, b, a}, 6), "f").front().surface);
  EXPECT_EQ(fan.triangles, 3u);
  EXPECT_EQ(fan.boundary_edges, 3u);
  EXPECT_EQ(fan.misoriented_edges, 0u);
}

TEST(ReadGlb, AListCalledAStripIsReadAsAListAndTold) {
  std::vector<std::uint16_t> list;
  for (const Triangle& t : shapes::tetrahedron().triangles) {
    for (const PointIndex corner : t) list.push_back(static_cast<std::uint16_t>(corner));
  }
  const auto meshes = parse_glb(with_indices(list, 5), "f");
  EXPECT_TRUE(inspect(meshes.front().surface).closed_oriented_manifold());
  EXPECT_EQ(meshes.front().remarks.size(), 1u);
}

TEST(ReadGltf, DataBesideTheFileOrWithinItsText) {
  const testing_support::TemporaryFolder folder;
  const std::string file = (folder / "tooth.gltf").string();
  std::filesystem::create_directory(folder / "parts");
  testing_support::put(folder / "parts/a b.bin", tetrahedron_buffer());
  const auto with_uri = [](const std::string& uri) {
    return replaced(tetrahedron_json, "{\"byteLength\":120}", "{\"byteLength\":120,\"uri\":\"" + uri + "\"}");
  };
  const std::vector<Point3> wanted = parse_glb(glb(tetrahedron_json, tetrahedron_buffer()), "f").front().surface.points;
  EXPECT_EQ(parse_gltf(with_uri("parts/a%20b.bin"), file).front().surface.points, wanted);
  EXPECT_EQ(parse_glb(glb(with_uri("parts/a b.bin"), ""), file).front().surface.points, wanted);
  EXPECT_THROW(parse_gltf(with_uri("parts/none.bin"), file), FileError);
  for (const char* elsewhere : {"../tooth.bin", "/etc/passwd", "file:///etc/passwd", "http://nobody/a.bin", "",
                                "parts/../../x", "%2e%2e/x", "%2Fetc/passwd"}) {
    EXPECT_EQ(cause_of(parse_gltf, with_uri(elsewhere)), "unsupported") << elsewhere;
  }
  std::filesystem::create_symlink("/etc/passwd", folder / "link.bin");
  EXPECT_THROW(parse_gltf(with_uri("link.bin"), file), InputError);
  EXPECT_THROW(parse_gltf(with_uri("parts"), file), FileError);
  EXPECT_EQ(cause_of(parse_gltf, with_uri("data:application/octet-stream;base64,AAAA!")), "unparsable");
  EXPECT_EQ(cause_of(parse_gltf, with_uri("data:application/octet-stream;base64,AAAA")), "truncated");
  EXPECT_EQ(cause_of(parse_gltf, with_uri("data:nothing")), "unparsable");
  EXPECT_EQ(cause_of(parse_gltf, "[]"), "unparsable");
}

}  // namespace
}  // namespace odontoscope
