// A partition is one conforming mesh to programs that nobody here wrote, and its tissues are bonded.

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "recon/elements/fill.h"
#include "recon/output/complex_groups.h"
#include "recon/output/element_model.h"
#include "recon/output/write_inp.h"
#include "recon/partition/reconstruct_partition.h"
#include "recon/sample/sample_tooth.h"
#include "tests/native_judges/judging.h"

namespace odontoscope::judges {
namespace {

/// Enamel, dentine and pulp of the sample incisor.
Reconstruction bonded_tooth() {
  return reconstruct_partition(
      sample_tooth(ToothKind::incisor, {.slice_spacing = 0.35, .point_spacing = 0.6, .walls = SampleWalls::filled}));
}

class PartitionJudge : public Judge {};

// --- one conforming mesh ---------------------------------------------------------------------------------------------

constexpr const char* count_mesh = R"(
import sys, numpy, meshio
mesh = meshio.read(sys.argv[1])
def cells(kind, width):
    found = [block.data for block in mesh.cells if block.type == kind]
    return numpy.concatenate(found) if found else numpy.zeros((0, width), dtype=int)
tetrahedra, triangles = cells("tetra", 4), cells("triangle", 3)
name = "gmsh:physical" if "gmsh:physical" in mesh.cell_data else "label"
labels = numpy.concatenate([numpy.ravel(data) for block, data in zip(mesh.cells, mesh.cell_data[name]) if block.type == "tetra"])
faces, owner = {}, []
for t, corners in enumerate(tetrahedra):
    for left_out in range(4):
        faces.setdefault(tuple(sorted(numpy.delete(corners, left_out))), []).append(labels[t])
borders = {face for face, sides in faces.items() if len(sides) == 1 or sides[0] != sides[1]}
listed = [tuple(sorted(corners)) for corners in triangles]
print("POINTS", len(mesh.points), len(numpy.unique(mesh.points, axis=0)), "CROWDED", sum(len(sides) > 2 for sides in faces.values()),
      "BORDERS", len(borders), "LISTED", len(listed), len(set(listed)), len(borders & set(listed)))
)";

TEST_P(PartitionJudge, MeshioFindsOneConformingMesh) {
  need("/usr/bin/python3");
  if (IsSkipped()) return;
  if (std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "python3-meshio is not installed; third_party/test_packages.debian lists it under \"judges\"";
  testing_support::put(folder / "count.py", count_mesh);
  const Reconstruction made = bonded_tooth();
  const LabelledComplex& complex = *made.complex;
  const std::size_t points = complex.mesh.points.size(), faces = complex.interfaces.size();
  std::ostringstream wanted;
  wanted << "POINTS " << points << " " << points << " CROWDED 0 BORDERS " << faces << " LISTED " << faces << " "
         << faces << " " << faces;
  for (const char* file : {"tooth.msh", "tooth.vtu"}) {
    const std::string said = said_by(std::string("/usr/bin/python3 count.py '") + file_of(made, file).c_str() + "'");
    EXPECT_NE(said.find(wanted.str()), said.npos) << file << ": " << wanted.str() << " is not in:\n" << said;
  }
}

TEST_P(PartitionJudge, GmshFindsItCoherent) {
  need("gmsh");
  if (IsSkipped()) return;
  const std::string said = said_by("gmsh -check '" + file_of(bonded_tooth(), "tooth.msh") + "'");
  EXPECT_NE(said.find("Done checking mesh coherence"), said.npos) << said;
  EXPECT_EQ(said.find("Warning"), said.npos) << said;
  EXPECT_EQ(said.find("Error"), said.npos) << said;
}

// --- a bite on bonded tissues ----------------------------------------------------------------------------------------

constexpr double bite = 100;  // newtons, downwards

struct Tissue {
  const char *name, *set;
  double stiffness, poisson;  // MPa
};
constexpr Tissue tissues[] = {
    {"enamel", "ENAMEL", 84000, 0.30}, {"dentine", "DENTINE", 18600, 0.31}, {"pulp", "PULP", 2, 0.45}};

double area(const LabelledComplex& complex, const Triangle& t) {
  const auto& p = complex.mesh.points;
  const double ux = p[t[1]].x - p[t[0]].x, uy = p[t[1]].y - p[t[0]].y, uz = p[t[1]].z - p[t[0]].z;
  const double vx = p[t[2]].x - p[t[0]].x, vy = p[t[2]].y - p[t[0]].y, vz = p[t[2]].z - p[t[0]].z;
  return std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

/// The bite as a pressure on the enamel's outside, less than 2 mm below the highest cusp, node by node. A force on
/// single nodes would press ever deeper as elements shrink.
std::map<PointIndex, double> loads(const LabelledComplex& complex) {
  double top = -1e9, sum = 0;
  for (const Point3& p : complex.mesh.points) top = std::max(top, p.z);
  std::map<PointIndex, double> load;
  for (const InterfaceTriangle& face : complex.interfaces) {
    if (face.outer != void_label || complex.structures[face.inner - 1] != "enamel") continue;
    double z = 0;
    for (const PointIndex v : face.triangle) z += complex.mesh.points[v].z / 3;
    if (z < top - 2) continue;
    sum += area(complex, face.triangle);
    for (const PointIndex v : face.triangle) load[v] += area(complex, face.triangle) / 3;
  }
  for (auto& [v, share] : load) share *= -bite / sum;
  return load;
}

/// The lower half, the roots, is held.
std::string bonded_job(const Reconstruction& model) {
  const LabelledComplex& complex = *model.complex;
  double low = 1e9, high = -1e9;
  for (const Point3& p : complex.mesh.points) low = std::min(low, p.z), high = std::max(high, p.z);
  std::ostringstream text;
  text.precision(17);
  text << inp_text(model) << "*NSET,NSET=HELD";
  for (std::size_t v = 0; v < complex.mesh.points.size(); ++v)
    if (complex.mesh.points[v].z < (low + high) / 2) text << "\n" << v + 1;
  const auto load = loads(complex);
  text << "\n*NSET,NSET=BITTEN";
  for (const auto& [v, force] : load) text << "\n" << v + 1;
  for (const Tissue& one : tissues)
    text << "\n*MATERIAL,NAME=" << one.set << "_MATERIAL\n*ELASTIC\n"
         << one.stiffness << "," << one.poisson << "\n*SOLID SECTION,ELSET=" << one.set << ",MATERIAL=" << one.set
         << "_MATERIAL";
  text << "\n*BOUNDARY\nHELD,1,3\n*STEP\n*STATIC\n*CLOAD";
  for (const auto& [v, force] : load) text << "\n" << v + 1 << ",3," << force;
  text << "\n*NODE PRINT,NSET=HELD,TOTALS=ONLY\nRF\n*NODE PRINT,NSET=BITTEN\nU\n*END STEP\n";
  return text.str();
}

struct Bitten {
  Point3 reaction;
  double depth = 0;  // mm, of the node that is pressed down farthest
  double work = 0;   // N mm, of the bite: twice the strain energy
};

class Bite : public PartitionJudge {
 protected:
  Bitten bitten(const Reconstruction& model) {
    testing_support::put(folder / "bite.inp", bonded_job(model));
    const std::string said = said_by("ccx bite"), results = testing_support::content(folder / "bite.dat");
    EXPECT_NE(said.find("Job finished"), said.npos) << said;
    EXPECT_EQ(said.find("*ERROR"), said.npos) << said;
    Bitten found;
    const std::size_t force_at = results.find("total force"), moved_at = results.find("displacements");
    if (force_at == results.npos || moved_at == results.npos) {
      ADD_FAILURE() << results.substr(0, 1000);
      return found;
    }
    std::istringstream(results.substr(results.find('\n', force_at))) >> found.reaction.x >> found.reaction.y >>
        found.reaction.z;
    const auto load = loads(*model.complex);
    std::istringstream lines(results.substr(results.find('\n', moved_at)));
    std::size_t node = 0, count = 0;
    for (Point3 u; count < load.size() && lines >> node >> u.x >> u.y >> u.z; ++count) {
      found.depth = std::max(found.depth, -u.z);
      const auto pressed = load.find(static_cast<PointIndex>(node - 1));
      if (pressed != load.end()) found.work += pressed->second * u.z;
    }
    EXPECT_EQ(count, load.size());
    return found;
  }
};

/// Every node of the junction belongs to an element of either tissue, and no place has two nodes: displacement cannot
/// but be continuous there.
void expect_bonded(const LabelledComplex& complex) {
  std::vector<std::set<Label>> labels(complex.mesh.points.size());
  for (std::size_t t = 0; t < complex.mesh.tetrahedra.size(); ++t)
    for (const PointIndex v : complex.mesh.tetrahedra[t]) labels[v].insert(complex.mesh.labels[t]);
  std::size_t shared = 0;
  for (const InterfaceTriangle& face : complex.interfaces) {
    if (face.outer == void_label) continue;
    ++shared;
    for (const PointIndex v : face.triangle)
      ASSERT_TRUE(labels[v].contains(face.inner) && labels[v].contains(face.outer));
  }
  EXPECT_GT(shared, 100u);
}

/// Thin as some are, CalculiX takes them.
TEST_P(Bite, IsHeldByBondedTissues) {
  need("ccx");
  if (IsSkipped()) return;
  const Reconstruction model = bonded_tooth();
  expect_bonded(*model.complex);
  const Bitten found = bitten(model);
  EXPECT_NEAR(found.reaction.x, 0, 1e-4 * bite);
  EXPECT_NEAR(found.reaction.y, 0, 1e-4 * bite);
  EXPECT_NEAR(found.reaction.z, bite, 1e-4 * bite);
  EXPECT_GT(found.depth, 1e-4);
  EXPECT_LT(found.depth, 0.05);
}

/// Elements of good angles: the bite's work hardly depends on their size.
TEST_P(Bite, ConvergesAsElementsBecomeFiner) {
  need("ccx");
  if (IsSkipped()) return;
  if (!elements::can_fill()) GTEST_SKIP() << "built without TetGen (libtet1.5-dev)";
  std::vector<double> works;
  for (const double size : {2.0, 1.0}) {
    Reconstruction model = bonded_tooth();
    mesh_elements(model, size);
    expect_bonded(*model.complex);
    const Bitten found = bitten(model);
    EXPECT_NEAR(found.reaction.z, bite, 1e-4 * bite);
    works.push_back(found.work);
  }
  EXPECT_GT(works[1], 0);
  EXPECT_NEAR(works[0], works[1], 0.01 * works[1]);
}

std::string incisor(const ::testing::TestParamInfo<Tooth>&) { return "SampleIncisor"; }
INSTANTIATE_TEST_SUITE_P(Teeth, PartitionJudge, ::testing::Values(Tooth::sample_molar), incisor);
INSTANTIATE_TEST_SUITE_P(Teeth, Bite, ::testing::Values(Tooth::sample_molar), incisor);

}  // namespace
}  // namespace odontoscope::judges
