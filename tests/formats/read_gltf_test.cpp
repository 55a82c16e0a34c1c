// glTF files as anybody may write them: what is right is read, what is wrong is named.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

#include "recon/core/error.h"
#include "recon/formats/read_mesh.h"
#include "recon/mesh/surface_report.h"
#include "tests/formats/mesh_files.h"
#include "tests/mesh/shapes.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope {
namespace {

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
