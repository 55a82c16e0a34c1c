// OBJ files as anybody may write them: what is right is read, what is wrong is named.

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

}  // namespace
}  // namespace odontoscope
