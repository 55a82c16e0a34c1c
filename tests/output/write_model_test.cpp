// What is written can be read again and is the same surface.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "recon/core/error.h"
#include "recon/formats/read_mesh.h"
#include "recon/formats/single_precision.h"
#include "recon/formats/smooth_normals.h"
#include "recon/formats/write_glb.h"
#include "recon/formats/write_ply.h"
#include "recon/formats/write_stl.h"
#include "recon/mesh/surface_report.h"
#include "recon/output/model_file.h"
#include "recon/output/write_vtu.h"
#include "tests/mesh/shapes.h"
#include "tests/output/models.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope {
namespace {

nlohmann::json json_of_glb(const std::string& bytes) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  return nlohmann::json::parse(bytes.substr(20, length));
}

/// The triangles as sets of places, so that numbering does not matter.
std::multiset<std::array<std::array<float, 3>, 3>> places(const SurfaceMesh& mesh) {
  std::multiset<std::array<std::array<float, 3>, 3>> all;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::array<float, 3>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = mesh.points[t[k]];
      corners[k] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

// --- round trips -----------------------------------------------------------------------------------------------------

TEST(WriteGlb, ReadsBackAsTheSameShells) {
  const Reconstruction model = models::tooth_and_enamel();
  const auto meshes = parse_glb(glb_bytes(model), "model");
  ASSERT_EQ(meshes.size(), 3u);
  EXPECT_EQ(meshes[0].name, "tooth external");
  EXPECT_EQ(meshes[1].name, "tooth cavity");
  EXPECT_EQ(meshes[2].name, "enamel external");
  const SurfaceMesh whole = shapes::together(meshes[0].surface, meshes[1].surface);
  EXPECT_EQ(whole.points.size(), model.solids[0].surface.points.size());  // creases and all are joined again
  const SurfaceReport report = inspect(whole), torus = inspect(meshes[2].surface);
  EXPECT_TRUE(report.closed_oriented_manifold());
  ASSERT_EQ(report.shells.size(), 2u);
  EXPECT_EQ(report.shells[1].kind, Shell::Kind::cavity);
  EXPECT_NEAR(report.shells[0].volume, model.solids[0].report.shells[0].volume, 1e-3);
  EXPECT_TRUE(torus.closed_oriented_manifold());
  EXPECT_EQ(torus.shells.at(0).genus, 1);
  // Not turned, not mirrored, in millimetres: every point within float precision of where it was.
  for (const Point3& p : meshes[2].surface.points)
    EXPECT_NEAR(std::hypot(std::hypot(p.x - 0.1, p.y - 0.2) - 8, p.z - 20), 2, 1e-5);
}

TEST(WriteStl, ReadsBackTheSameTriangles) {
  Reconstruction model;
  model.solids.push_back(models::solid("tooth", shapes::torus(8, 2, 40, 20)));
  const auto meshes = parse_stl(stl_bytes(model), "model");
  EXPECT_EQ(places(meshes.at(0).surface), places(model.solids[0].surface));
  EXPECT_TRUE(inspect(meshes[0].surface).closed_oriented_manifold());
}

TEST(WritePly, ReadsBackEveryBit) {
  const Reconstruction model = models::tooth_and_enamel();
  const auto meshes = parse_ply(ply_bytes(model), "model");
  const SurfaceMesh expected = shapes::together(model.solids[0].surface, model.solids[1].surface);
  EXPECT_EQ(meshes.at(0).surface.points, expected.points);
  EXPECT_EQ(meshes[0].surface.triangles, expected.triangles);
}

TEST(WriteVtu, HasAllTetrahedraAndTheirStructure) {
  const std::string xml = vtu_bytes(models::tooth_and_enamel());
  EXPECT_NE(xml.find("NumberOfPoints=\"16\" NumberOfCells=\"10\""), xml.npos);
  EXPECT_NE(xml.find("Name=\"structure enamel\" NumberOfTuples=\"1\" format=\"ascii\">2<"), xml.npos);
  // Ten bytes of type 10 behind their 64-bit count, in base64.
  EXPECT_NE(xml.find("CgAAAAAAAAAKCgoKCgoKCgoK"), xml.npos);
}

TEST(WriteVtu, NamesAreEscaped) {
  Reconstruction model;
  model.solids.push_back(models::solid("a<b>&\"c\"", shapes::cube()));
  EXPECT_NE(vtu_bytes(model).find("\"structure a&lt;b&gt;&amp;&quot;c&quot;\""), std::string::npos);
}

TEST(WriteModel, TheSameModelGivesTheSameBytes) {
  const Reconstruction model = models::tooth_and_enamel();
  Reconstruction slower = model;
  slower.threads = 16;
  slower.seconds = {{"validate", 99}};
  for (const std::string& ending : model_endings()) {
    EXPECT_EQ(model_file(model, "a" + ending).bytes, model_file(slower, "b" + ending).bytes) << ending;
  }
}

TEST(WriteModel, TheEndingDecides) {
  testing_support::TemporaryFolder folder;
  const std::filesystem::path files[] = {folder / "a.GLB", folder / "a.stl", folder / "a.Ply", folder / "a.vtu"};
  write_model(models::tooth_and_enamel(), files);
  EXPECT_EQ(testing_support::content(files[0]).substr(0, 4), "glTF");
  EXPECT_EQ(testing_support::content(files[2]).substr(0, 4), "ply\n");
  const std::filesystem::path bad[] = {folder / "b.glb", folder / "b.off"};
  try {
    write_model(models::tooth_and_enamel(), bad);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find(".glb, .stl, .ply, .gltf, .obj, .wrl, .x3d, .vtp, .3mf, .vtu, .msh, .inp"),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "b.glb"));
}

// --- glTF in detail --------------------------------------------------------------------------------------------------

TEST(WriteGlb, IsLabelledForPeopleAndPrograms) {
  const nlohmann::json gltf = json_of_glb(glb_bytes(models::tooth_and_enamel()));
  EXPECT_EQ(gltf["asset"]["version"], "2.0");
  EXPECT_EQ(gltf["asset"]["generator"], "odontoscope");
  EXPECT_EQ(gltf["asset"]["extras"]["certified"], true);
  EXPECT_EQ(gltf["asset"]["extras"]["surface_in_mm"]["shells"].size(), 3u);
  EXPECT_FALSE(gltf.contains("extensionsUsed"));
  EXPECT_EQ(gltf["nodes"][0]["children"].size(), 3u);
  EXPECT_EQ(gltf["nodes"][2]["name"], "tooth cavity");
  EXPECT_EQ(gltf["nodes"][2]["extras"]["kind"], "cavity");
  std::set<std::string> materials;
  for (const auto& material : gltf["materials"]) {
    materials.insert(material["name"]);
    EXPECT_FALSE(material.value("doubleSided", false));
  }
  EXPECT_EQ(materials, (std::set<std::string>{"tooth", "pulp", "enamel"}));
}

TEST(WriteGlb, BoundsAreThoseOfTheFloats) {
  const std::string bytes = glb_bytes(models::tooth_and_enamel());
  const nlohmann::json gltf = json_of_glb(bytes);
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  const char* buffer = bytes.data() + 20 + length + 8;
  for (const auto& mesh : gltf["meshes"]) {
    const auto& accessor = gltf["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
    const auto& view = gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    float low = 1e9f, high = -1e9f;
    for (std::size_t i = 0; i < accessor["count"]; ++i) {
      float x = 0;
      std::memcpy(&x, buffer + view.value("byteOffset", std::size_t{0}) + 12 * i, 4);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    EXPECT_EQ(accessor["min"][0].get<float>(), low);
    EXPECT_EQ(accessor["max"][0].get<float>(), high);
  }
}

TEST(WriteGlb, WithoutASolidItIsStillWhole) {
  EXPECT_NO_THROW(json_of_glb(glb_bytes({})));
  EXPECT_THROW(parse_glb(glb_bytes({}), "model"), InputError);  // empty-mesh
}

// --- normals ---------------------------------------------------------------------------------------------------------

TEST(SmoothNormals, OfASpherePointOutwards) {
  const SurfaceMesh sphere = shapes::sphere(2, 4);
  const ShadedVertices shaded = smooth_normals(sphere, 60);
  ASSERT_EQ(shaded.point.size(), sphere.points.size());  // nothing is sharp
  for (std::size_t v = 0; v < shaded.point.size(); ++v) {
    const Point3& p = sphere.points[shaded.point[v]];
    const Direction& n = shaded.normals[v];
    EXPECT_NEAR(length(n), 1, 1e-12);
    EXPECT_GT((n.x * p.x + n.y * p.y + n.z * p.z) / 2, 0.999);
  }
}

TEST(SmoothNormals, OfACubeAreThoseOfItsFaces) {
  const SurfaceMesh cube = shapes::cube();
  const ShadedVertices shaded = smooth_normals(cube, 60);
  EXPECT_EQ(shaded.point.size(), 24u);
  for (const Direction& n : shaded.normals)
    EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1, 1e-12);
  EXPECT_EQ(smooth_normals(cube, 91).point.size(), 8u);
}

TEST(SmoothNormals, AreUnitVectorsWhateverTheTriangles) {
  SurfaceMesh pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 2}, {0, 2, 1}, {1, 3, 2}}};
  for (const Direction& n : smooth_normals(pillow, 180).normals) EXPECT_NEAR(length(n), 1, 1e-12);
}

// --- single precision ------------------------------------------------------------------------------------------------

TEST(DistinctFloats, PointsCloserThanFloatsStayApartAndNear) {
  std::vector<Point3> points;
  for (int i = 0; i < 40; ++i) points.push_back({100 + i * 1e-9, 200, 300});
  points.push_back(points[3]);
  const auto floats = distinct_floats(points, 1);
  const std::set<FloatPoint> places(floats.begin(), floats.end());
  EXPECT_EQ(places.size(), 40u);
  EXPECT_EQ(floats[40], floats[3]);  // equal points stay equal
  for (const FloatPoint& p : floats) {
    EXPECT_NEAR(p[0], 100, 3e-5);
    EXPECT_NEAR(p[2], 300, 1e-4);
  }
}

TEST(DistinctFloats, WhoHasAPlaceOfItsOwnKeepsIt) {
  const float one = 1, beside = std::nextafter(1.0f, 2.0f);
  const auto floats = distinct_floats({{1, 1, 1}, {1 + 1e-12, 1, 1}, {beside, 1, 1}}, 1);
  EXPECT_EQ(floats[0], (FloatPoint{one, one, one}));
  EXPECT_EQ(floats[2], (FloatPoint{beside, one, one}));
  EXPECT_NE(floats[1], floats[0]);
  EXPECT_NE(floats[1], floats[2]);
  EXPECT_FALSE(std::signbit(distinct_floats({{-0.0, 0, 0}}, 1)[0][0]));
}

TEST(WriteStl, PointsThatFloatsCannotTellApartBreakNothing) {
  SurfaceMesh mesh = shapes::sphere(10, 3);
  const Point3 p = mesh.points[mesh.triangles[0][0]];
  mesh.points[mesh.triangles[0][1]] = {p.x, p.y, p.z + 1e-9};  // collapses in single precision
  Reconstruction model;
  model.solids.push_back(models::solid("tooth", mesh));
  EXPECT_EQ(parse_stl(stl_bytes(model), "m").at(0).surface.points.size(), mesh.points.size());
  EXPECT_EQ(inspect(parse_stl(stl_bytes(model), "m")[0].surface).nonmanifold_edges, 0u);
  EXPECT_EQ(parse_glb(glb_bytes(model), "m").at(0).surface.points.size(), mesh.points.size());
}

}  // namespace
}  // namespace odontoscope
