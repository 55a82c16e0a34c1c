// ADMesh looks for flipped and missing facets; assimp reads what viewers read.

#include <cmath>
#include <cstdlib>

#include "tests/native_judges/judging.h"

namespace odontoscope::judges {
namespace {

class Admesh : public Judge {
 protected:
  void SetUp() override { need("admesh"); }
};

/// What ADMesh would have to mend; each is 0 for a sound surface.
constexpr const char* repairs[] = {
    "Total disconnected facets", "Degenerate facets", "Edges fixed",  "Facets removed", "Facets added",
    "Facets reversed",           "Backwards edges",   "Normals fixed"};

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

// --- lib3mf, through its C interface ---------------------------------------------------------------------------------

constexpr const char* ask_lib3mf = R"(
import ctypes, sys
lib = ctypes.CDLL("lib3MF.so.1")
def call(name, *arguments):
    failed = getattr(lib, "lib3mf_" + name)(*arguments)
    if failed: raise SystemExit("%s failed: %#x" % (name, failed & 0xffffffff))
def new(name, *arguments):
    made = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(made))
    return made
def number(name, *arguments, kind=ctypes.c_uint32):
    value = kind()
    call(name, *arguments, ctypes.byref(value))
    return value.value
model = new("createmodel")
reader = new("model_queryreader", model, b"3mf")
call("reader_setstrictmodeactive", reader, 1)
call("reader_readfromfileutf8", reader, sys.argv[1].encode())
print("WARNINGS", number("reader_getwarningcount", reader))
objects = new("model_getmeshobjects", model)
while number("resourceiterator_movenext", objects, kind=ctypes.c_int):
    one = new("resourceiterator_getcurrent", objects)
    name, length = ctypes.create_string_buffer(200), ctypes.c_uint32()
    call("object_getnameutf8", one, name, 200, ctypes.byref(length))
    print("OBJECT", name.value.decode(), number("meshobject_ismanifoldandoriented", one, kind=ctypes.c_int),
          number("meshobject_getvertexcount", one), number("meshobject_gettrianglecount", one))
)";

class Lib3mf : public Judge {
 protected:
  void SetUp() override {
    need("/usr/bin/python3");
    if (IsSkipped()) return;
    if (std::system("/usr/bin/python3 -c 'import ctypes; ctypes.CDLL(\"lib3MF.so.1\")' >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "lib3mf1 is not installed; third_party/test_packages.debian lists it under \"judges\"";
    testing_support::put(folder / "ask.py", ask_lib3mf);
  }
  std::string judged(const Reconstruction& model) const {
    return said_by("/usr/bin/python3 ask.py '" + file_of(model, "tooth.3mf") + "' || true");
  }
};

TEST_P(Lib3mf, FindsEachStructureClosedAndTurnedOutwards) {
  const std::string said = judged(tooth());
  EXPECT_NE(said.find("WARNINGS 0"), said.npos) << said;
  for (const Solid& solid : tooth().solids) {
    const std::string line = "OBJECT " + solid.structure + " 1 " + std::to_string(solid.surface.points.size()) + " " +
                             std::to_string(solid.surface.triangles.size());
    EXPECT_NE(said.find(line), said.npos) << line << " is not in:\n" << said;
  }
}

TEST_P(Lib3mf, SeesAFlippedAndAMissingTriangle) {
  for (Reconstruction broken : {with_flipped_triangle(tooth()), without_a_triangle(tooth())}) {
    const std::string said = judged(broken), sound = "OBJECT " + broken.solids.front().structure + " 1 ";
    EXPECT_EQ(said.find(sound), said.npos) << said;
  }
}

INSTANTIATE_TEST_SUITE_P(Teeth, Lib3mf, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);
INSTANTIATE_TEST_SUITE_P(Teeth, Admesh, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);
INSTANTIATE_TEST_SUITE_P(Teeth, Assimp, ::testing::Values(Tooth::sample_molar, Tooth::ct_molar), name_of);

}  // namespace
}  // namespace odontoscope::judges
