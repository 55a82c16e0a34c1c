// PLY files as anybody may write them: what is right is read, what is wrong is named.

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

TEST(ReadPly, BehindAHeaderOfOldLineEndsTheFirstByteIsANumber) {
  std::string bytes = binary_ply(shapes::cube(), false);
  const std::size_t end = bytes.find("end_header\n") + std::string("end_header\n").size();
  for (std::size_t i = 0; i < end; ++i) bytes[i] = bytes[i] == '\n' ? '\r' : bytes[i];
  EXPECT_TRUE(inspect(parse_ply(bytes, "file").front().surface).closed_oriented_manifold());
  const auto behind = parse_ply(binary_ply(shapes::cube(), false) + "\n", "file");
  EXPECT_EQ(behind.front().remarks.size(), 1u);
}

}  // namespace
}  // namespace odontoscope
