// ADMesh looks for flipped and missing facets; assimp reads what viewers read.

#include <cmath>

#include "tests/native_judges/judging.h"

namespace odontoscope::judges {
namespace {

class Admesh : public Judge {
 protected:
  void SetUp() override { need("admesh"); }
};

/// What ADMesh would have to mend; each is 0 for a sound surface.
constexpr const char* repairs[] = {"Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed", "Facets added",
                                   "Facets reversed", "Backwards edges", "Normals fixed"};

TEST_P(Admesh, FindsNothingToRepair) {
  const std::string said = said_by("admesh '" + file_of(tooth(), "tooth.stl") + "'");
  EXPECT_EQ(number_after(said, "Number of facets"), static_cast<double>(triangles_in(tooth())));
  for (const char* repair : repairs) EXPECT_EQ(number_after(said, repair), 0) << repair;
}

TEST_P(Admesh, FindsOneFlippedFacet) {
  const std::string said = said_by("admesh '" + file_of(with_flipped_triangle(tooth()), "tooth.stl") + "'");
  EXPECT_EQ(number_after(said, "Facets reversed"), 1);
}

TEST_P(Admesh, FindsOneMissingFacet) {
  const std::string said = said_by("admesh '" + file_of(without_a_triangle(tooth()), "tooth.stl") + "'");
  EXPECT_EQ(number_after(said, "Total disconnected facets"), 3);
  EXPECT_EQ(number_after(said, "Facets added"), 1);
}

class Assimp : public Judge {
 protected:
  void SetUp() override { need("assimp"); }
  double faces_in(const Reconstruction& model, const std::string& ending) const {
    return number_after(said_by("assimp info '" + file_of(model, "tooth" + ending) + "'"), "Faces");
  }
};

TEST_P(Assimp, CountsTheFacesOfEveryFormat) {
  for (const char* ending : {".glb", ".gltf", ".stl", ".ply", ".obj", ".x3d"}) {
    EXPECT_EQ(faces_in(tooth(), ending), static_cast<double>(triangles_in(tooth()))) << ending;
    EXPECT_EQ(faces_in(without_a_triangle(tooth()), ending), static_cast<double>(triangles_in(tooth())) - 1) << ending;
  }
}

TEST_P(Assimp, FindsTheNamesOfWalls) {
  const std::string structure = tooth().solids.front().structure;
  const std::string glb = said_by("assimp info '" + file_of(tooth(), "tooth.glb") + "'");
  const std::string obj = said_by("assimp info '" + file_of(tooth(), "tooth.obj") + "'");
  for (const std::string kind : {"external", "cavity"}) {
    EXPECT_NE(glb.find(structure + " " + kind), glb.npos) << glb;
    EXPECT_NE(obj.find(structure + "_" + kind), obj.npos) << obj;
  }
}

INSTANTIATE_TEST_SUITE_P(Teeth, Admesh, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);
INSTANTIATE_TEST_SUITE_P(Teeth, Assimp, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);

}  // namespace
}  // namespace odontoscope::judges
