// Mesh files of any format, damaged ones too.

#include "recon/formats/read_mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

#include "recon/core/error.h"
#include "recon/mesh/surface_report.h"
#include "tests/formats/mesh_files.h"
#include "tests/mesh/shapes.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope {
namespace {

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

}  // namespace
}  // namespace odontoscope
