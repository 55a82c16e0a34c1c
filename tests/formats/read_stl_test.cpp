// STL files as anybody may write them: what is right is read, what is wrong is named.

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

}  // namespace
}  // namespace odontoscope
