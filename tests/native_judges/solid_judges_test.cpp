// Gmsh looks for inverted tetrahedra, meshio reads every format and measures, CalculiX bites.

#include <algorithm>
#include <sstream>

#include "recon/mesh/tetra_report.h"
#include "recon/output/write_inp.h"
#include "tests/native_judges/judging.h"

namespace odontoscope::judges {
namespace {

// --- Gmsh ------------------------------------------------------------------------------------------------------------

class Gmsh : public Judge {
 protected:
  void SetUp() override { need("gmsh"); }
  std::string check(const Reconstruction& model) const {
    return said_by("gmsh -check '" + file_of(model, "tooth.msh") + "'");
  }
};

TEST_P(Gmsh, FindsNoFault) {
  const std::string said = check(tooth());
  EXPECT_NE(said.find("Done checking mesh coherence"), said.npos) << said;
  EXPECT_EQ(said.find("Warning"), said.npos) << said;
  EXPECT_EQ(said.find("Error"), said.npos) << said;
}

TEST_P(Gmsh, FindsAnInvertedTetrahedron) {
  const std::string said = check(with_inverted_tetrahedron(tooth()));
  EXPECT_NE(said.find("has negative volume"), said.npos) << said;
}

// --- meshio ----------------------------------------------------------------------------------------------------------

constexpr const char* measure_mesh = R"(
import sys, numpy, meshio
mesh = meshio.read(sys.argv[1])
def cells(kind, corners):
    found = [block.data for block in mesh.cells if block.type == kind]
    return numpy.concatenate(found) if found else numpy.zeros((0, corners), dtype=int)
p, tetrahedra, triangles = mesh.points.astype(float), cells("tetra", 4), cells("triangle", 3)
def triple(a, b, c): return numpy.einsum("ij,ij->i", numpy.cross(a, b), c)
a, b, c, d = (p[tetrahedra[:, k]] for k in range(4))
volumes = triple(b - a, c - a, d - a) / 6
walls = triple(p[triangles[:, 0]], p[triangles[:, 1]], p[triangles[:, 2]]) / 6
print("MEASURED", len(tetrahedra), repr(float(volumes.sum())), int((volumes <= 0).sum()), len(triangles), repr(float(walls.sum())))
print("SETS", "; ".join(sorted(mesh.cell_sets)))
)";

class Meshio : public Judge {
 protected:
  void SetUp() override {
    need("/usr/bin/python3");  // another python may shadow the system's, which has meshio
    if (IsSkipped()) return;
    if (std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "python3-meshio is not installed; third_party/test_packages.debian lists it under \"judges\"";
    }
    testing_support::put(folder / "measure.py", measure_mesh);
  }

  struct Measured {
    std::size_t tetrahedra = 0, not_positive = 0, triangles = 0;
    double volume = 0, enclosed = 0;
    std::string sets;
  };
  Measured measured(const Reconstruction& model, const std::string& ending) const {
    const std::string said = said_by("/usr/bin/python3 measure.py '" + file_of(model, "tooth" + ending) + "'");
    Measured found;
    const std::size_t at = said.find("MEASURED "), sets = said.find("SETS ");
    if (at == said.npos || sets == said.npos) {
      ADD_FAILURE() << said;
      return found;
    }
    std::istringstream(said.substr(at + 9)) >> found.tetrahedra >> found.volume >> found.not_positive >>
        found.triangles >> found.enclosed;
    found.sets = said.substr(sets + 5);
    return found;
  }
};

TEST_P(Meshio, ReadsTheSameTetrahedraFromEveryFormat) {
  const double volume = volume_of(tooth());
  for (const char* ending : {".msh", ".vtu", ".inp"}) {
    const Measured found = measured(tooth(), ending);
    EXPECT_EQ(found.tetrahedra, tetrahedra_in(tooth())) << ending;
    EXPECT_EQ(found.not_positive, 0u) << ending;
    EXPECT_NEAR(found.volume, volume, 1e-9 * volume) << ending;
  }
}

TEST_P(Meshio, SeesAMissingAndAnInvertedTetrahedron) {
  for (const char* ending : {".msh", ".vtu", ".inp"}) {
    EXPECT_EQ(measured(without_a_tetrahedron(tooth()), ending).tetrahedra, tetrahedra_in(tooth()) - 1) << ending;
    EXPECT_EQ(measured(with_inverted_tetrahedron(tooth()), ending).not_positive, 1u) << ending;
  }
}

TEST_P(Meshio, WallsEncloseTheTetrahedra) {
  const double volume = volume_of(tooth());
  for (const char* ending : {".msh", ".stl", ".ply"}) {
    const Measured found = measured(tooth(), ending);
    EXPECT_EQ(found.triangles, triangles_in(tooth())) << ending;
    EXPECT_NEAR(found.enclosed, volume, 1e-6 * volume) << ending;
  }
  const double flipped = measured(with_flipped_triangle(tooth()), ".ply").enclosed;
  EXPECT_GT(std::abs(flipped - volume), 1e-9 * volume);
}

TEST_P(Meshio, FindsThePhysicalGroups) {
  const std::string sets = measured(tooth(), ".msh").sets, structure = tooth().solids.front().structure;
  for (const std::string& name : {structure, structure + " external", structure + " cavity"}) {
    EXPECT_NE(sets.find(name), sets.npos) << sets;
  }
}

// --- CalculiX --------------------------------------------------------------------------------------------------------

constexpr double bite = 100;                         // newtons, downwards
constexpr double stiffness = 18600, poisson = 0.31;  // dentine, MPa

/// A bite on the highest points of the only solid of `model`, whose lower half, the root, is held.
std::string job(const Reconstruction& model) {
  constexpr std::size_t cusp_points = 60;
  const std::vector<Point3>& points = model.solids.front().tetrahedra.points;
  std::vector<std::size_t> by_height(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) by_height[i] = i;
  std::stable_sort(by_height.begin(), by_height.end(),
                   [&](std::size_t a, std::size_t b) { return points[a].z < points[b].z; });
  const double middle = (points[by_height.front()].z + points[by_height.back()].z) / 2;
  std::ostringstream text;
  text.precision(17);
  text << inp_text(model) << "*NSET,NSET=HELD";
  for (std::size_t i = 0; points[by_height[i]].z < middle; ++i) text << "\n" << by_height[i] + 1;
  text << "\n*NSET,NSET=BITTEN";
  for (std::size_t i = 0; i < cusp_points; ++i) text << "\n" << by_height[points.size() - 1 - i] + 1;
  std::string structure = model.solids.front().structure;
  for (char& c : structure) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  text << "\n*MATERIAL,NAME=DENTINE_MATERIAL\n*ELASTIC\n"
       << stiffness << "," << poisson << "\n*SOLID SECTION,ELSET=" << structure
       << ",MATERIAL=DENTINE_MATERIAL\n*BOUNDARY\nHELD,1,3\n*STEP\n*STATIC\n*CLOAD\nBITTEN,3," << -bite / cusp_points
       << "\n*NODE PRINT,NSET=HELD,TOTALS=ONLY\nRF\n*EL PRINT,ELSET=" << structure << ",TOTALS=ONLY\nEVOL\n*END STEP\n";
  return text.str();
}

class Calculix : public Judge {
 protected:
  void SetUp() override { need("ccx"); }
};

TEST_P(Calculix, ABiteIsHeldByTheRoot) {
  const Reconstruction model = coarse_tooth(GetParam());
  ASSERT_EQ(model.solids.size(), 1u);
  testing_support::put(folder / "bite.inp", job(model));
  const std::string said = said_by("ccx bite");
  EXPECT_NE(said.find("Job finished"), said.npos) << said;
  EXPECT_EQ(said.find("*ERROR"), said.npos) << said;
  const std::string results = testing_support::content(folder / "bite.dat");
  const std::size_t force_at = results.find("total force"), volume_at = results.find("total volume");
  ASSERT_TRUE(force_at != results.npos && volume_at != results.npos) << results;
  double x = 0, y = 0, z = 0, volume = 0;
  std::istringstream(results.substr(results.find('\n', force_at))) >> x >> y >> z;
  std::istringstream(results.substr(results.find('\n', volume_at))) >> volume;
  EXPECT_NEAR(x, 0, 1e-4 * bite);
  EXPECT_NEAR(y, 0, 1e-4 * bite);
  EXPECT_NEAR(z, bite, 1e-4 * bite);
  EXPECT_NEAR(volume, volume_of(model), 1e-5 * volume_of(model));  // it prints seven digits
}

TEST_P(Calculix, AnInvertedTetrahedronIsAnError) {
  testing_support::put(folder / "bite.inp", job(with_inverted_tetrahedron(coarse_tooth(GetParam()))));
  const std::string said = said_by("ccx bite || true");
  EXPECT_NE(said.find("nonpositive jacobian"), said.npos) << said;
}

INSTANTIATE_TEST_SUITE_P(Teeth, Gmsh, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);
INSTANTIATE_TEST_SUITE_P(Teeth, Meshio, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);
INSTANTIATE_TEST_SUITE_P(Teeth, Calculix, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);

}  // namespace
}  // namespace odontoscope::judges
