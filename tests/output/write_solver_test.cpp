// Tetrahedra for solvers: Gmsh's .msh and .inp of Abaqus and CalculiX, read back word by word.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "recon/output/solid_walls.h"
#include "recon/output/write_inp.h"
#include "recon/output/write_msh.h"
#include "tests/mesh/shapes.h"
#include "tests/output/models.h"

namespace odontoscope {
namespace {

/// The unit cubes of `layers` cells on each side, five tetrahedra each, without those that `left_out` names.
Solid block(const std::string& structure, int layers, double z, const std::set<std::array<int, 3>>& left_out) {
  std::map<std::array<int, 3>, PointIndex> number;
  Solid solid;
  solid.structure = structure;
  TetraMesh& mesh = solid.tetrahedra;
  const TetraMesh cube = shapes::cube_of_five();
  for (int x = 0; x < layers; ++x) {
    for (int y = 0; y < layers; ++y) {
      for (int w = 0; w < layers; ++w) {
        if (left_out.contains({x, y, w})) continue;
        for (const Tetrahedron& t : cube.tetrahedra) {
          Tetrahedron moved{};
          for (std::size_t k = 0; k < 4; ++k) {
            Point3 p = cube.points[t[k]];
            // Every second cube is mirrored, so that diagonals agree; two corners change places to stay positive.
            if ((x + y + w) % 2 == 1) p.x = 1 - p.x;
            const std::array<int, 3> key{static_cast<int>(p.x) + x, static_cast<int>(p.y) + y,
                                         static_cast<int>(p.z) + w};
            const auto [at, fresh] = number.try_emplace(key, static_cast<PointIndex>(mesh.points.size()));
            if (fresh) mesh.points.push_back({key[0] / 3.0, key[1] / 7.0, key[2] + z});
            moved[k] = at->second;
          }
          if ((x + y + w) % 2 == 1) std::swap(moved[0], moved[1]);
          mesh.tetrahedra.push_back(moved);
          mesh.labels.push_back(1);
        }
      }
    }
  }
  return solid;
}

/// A dentine of 27 cubes with a cavity in the middle, and an enamel on top of it.
Reconstruction hollow_block() {
  Reconstruction model;
  model.solids.push_back(block("dentine", 3, 0, {{1, 1, 1}}));
  model.solids.push_back(block("enamel", 1, 3, {}));
  return model;
}

TEST(Walls, AreToldApartAndTurnedOutwards) {
  const Reconstruction model = hollow_block();
  const std::vector<Wall> walls = walls_of(model.solids[0]);
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[0].name, "dentine external");
  EXPECT_EQ(walls[0].faces.size(), 6u * 9 * 2);
  EXPECT_EQ(walls[1].name, "dentine cavity");
  EXPECT_EQ(walls[1].faces.size(), 6u * 2);
  for (const Wall& wall : walls) {
    for (const WallFace& face : wall.faces) {
      const Tetrahedron& corners = model.solids[0].tetrahedra.tetrahedra[face.tetrahedron];
      for (const PointIndex v : face.triangle) EXPECT_NE(v, corners[static_cast<std::size_t>(face.face)]);
      EXPECT_EQ(
          std::count_if(corners.begin(), corners.end(),
                        [&](PointIndex v) { return std::count(face.triangle.begin(), face.triangle.end(), v) == 1; }),
          3);
    }
  }
}

TEST(CrownLimit, IsWhereTheEnamelBegins) {
  Reconstruction model = hollow_block();
  ASSERT_TRUE(crown_limit(model));
  EXPECT_EQ(crown_limit(model)->z, 3);
  EXPECT_TRUE(crown_limit(model)->crown_above);
  for (Point3& p : model.solids[1].tetrahedra.points) p.z -= 4;  // now from -1 to 0
  EXPECT_EQ(crown_limit(model)->z, 0);
  EXPECT_FALSE(crown_limit(model)->crown_above);
  model.solids.pop_back();
  EXPECT_FALSE(crown_limit(model));
  model.solids[0].structure = "enamel+dentine";
  EXPECT_FALSE(crown_limit(model));
}

// --- .msh ------------------------------------------------------------------------------------------------------------

std::istringstream section(const std::string& text, const std::string& name) {
  const std::size_t first = text.find("$" + name + "\n"), end = text.find("$End" + name + "\n");
  EXPECT_NE(first, text.npos) << name;
  return std::istringstream(text.substr(first + name.size() + 2, end - first - name.size() - 2));
}

TEST(WriteMsh, ReadsBackEveryBit) {
  const Reconstruction model = hollow_block();
  const std::string text = msh_text(model);
  EXPECT_TRUE(text.starts_with("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"));
  std::istringstream nodes = section(text, "Nodes"), elements = section(text, "Elements");
  std::size_t blocks = 0, count = 0, low = 0, high = 0;
  nodes >> blocks >> count >> low >> high;
  ASSERT_EQ(blocks, 2u);
  EXPECT_EQ(count, model.solids[0].tetrahedra.points.size() + 8);
  EXPECT_EQ(high, count);
  std::vector<Point3> points;
  for (std::size_t b = 0; b < blocks; ++b) {
    std::size_t dimension = 0, tag = 0, parametric = 0, in_block = 0, number = 0;
    nodes >> dimension >> tag >> parametric >> in_block;
    EXPECT_EQ(dimension, 3u);
    for (std::size_t i = 0; i < in_block; ++i) {
      nodes >> number;
      EXPECT_EQ(number, points.size() + i + 1);
    }
    for (std::size_t i = 0; i < in_block; ++i) {
      Point3 p;
      nodes >> p.x >> p.y >> p.z;
      points.push_back(p);
    }
  }
  std::vector<Point3> expected = model.solids[0].tetrahedra.points;
  expected.insert(expected.end(), model.solids[1].tetrahedra.points.begin(), model.solids[1].tetrahedra.points.end());
  EXPECT_EQ(points, expected);

  elements >> blocks >> count >> low >> high;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::size_t> triangles_of(4);
  for (std::size_t b = 0; b < blocks; ++b) {
    std::size_t dimension = 0, tag = 0, type = 0, in_block = 0, number = 0;
    elements >> dimension >> tag >> type >> in_block;
    for (std::size_t i = 0; i < in_block; ++i) {
      elements >> number;
      std::size_t v[4] = {};
      for (std::size_t k = 0; k <= dimension; ++k) elements >> v[k];
      if (dimension == 2) ++triangles_of.at(tag);
      if (dimension == 3)
        tetrahedra.push_back({static_cast<PointIndex>(v[0] - 1), static_cast<PointIndex>(v[1] - 1),
                              static_cast<PointIndex>(v[2] - 1), static_cast<PointIndex>(v[3] - 1)});
    }
  }
  EXPECT_EQ(triangles_of, (std::vector<std::size_t>{0, 108, 12, 12}));
  ASSERT_EQ(tetrahedra.size(), 26u * 5 + 5);
  EXPECT_TRUE(std::equal(model.solids[0].tetrahedra.tetrahedra.begin(), model.solids[0].tetrahedra.tetrahedra.end(),
                         tetrahedra.begin()));
}

TEST(WriteMsh, GroupsHaveTheNamesOfStructuresAndWalls) {
  Reconstruction model = hollow_block();
  model.solids[1].structure = "en\"amel";
  const std::string text = msh_text(model);
  EXPECT_NE(text.find("$PhysicalNames\n5\n2 1 \"dentine external\"\n2 2 \"dentine cavity\"\n2 3 \"en'amel "
                      "external\"\n3 1 \"dentine\"\n3 2 \"en'amel\"\n"),
            text.npos);
}

// --- .inp ------------------------------------------------------------------------------------------------------------

/// Keyword lines, and the numbers or words behind each.
std::map<std::string, std::vector<std::vector<std::string>>> blocks_of(const std::string& text) {
  std::map<std::string, std::vector<std::vector<std::string>>> blocks;
  std::istringstream lines(text);
  std::string keyword;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("**")) continue;
    if (line.starts_with('*')) {
      keyword = line;
      blocks[keyword];
      continue;
    }
    std::vector<std::string> words;
    std::istringstream in(line);
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    blocks[keyword].push_back(words);
  }
  return blocks;
}

std::size_t members(const std::vector<std::vector<std::string>>& lines) {
  std::size_t sum = 0;
  for (const auto& line : lines) {
    EXPECT_LE(line.size(), 16u);
    sum += line.size();
  }
  return sum;
}

TEST(WriteInp, HasElementsWallsAndEnds) {
  const Reconstruction model = hollow_block();
  auto blocks = blocks_of(inp_text(model));
  const TetraMesh& dentine = model.solids[0].tetrahedra;
  const auto& nodes = blocks.at("*NODE");
  ASSERT_EQ(nodes.size(), dentine.points.size() + 8);
  for (std::size_t i = 0; i < dentine.points.size(); ++i) {
    EXPECT_EQ(std::stoul(nodes[i][0]), i + 1);
    EXPECT_EQ(std::stod(nodes[i][1]), dentine.points[i].x);
    EXPECT_EQ(std::stod(nodes[i][3]), dentine.points[i].z);
  }
  const auto& elements = blocks.at("*ELEMENT,TYPE=C3D4,ELSET=DENTINE");
  ASSERT_EQ(elements.size(), dentine.tetrahedra.size());
  for (std::size_t t = 0; t < elements.size(); ++t) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(std::stoul(elements[t][k + 1]), dentine.tetrahedra[t][k] + 1);
  }
  EXPECT_EQ(blocks.at("*ELEMENT,TYPE=C3D4,ELSET=ENAMEL").front().front(), std::to_string(elements.size() + 1));
  EXPECT_EQ(members(blocks.at("*NSET,NSET=DENTINE_CAVITY")), 8u);
  EXPECT_EQ(members(blocks.at("*NSET,NSET=DENTINE_LOWEST")), 16u);
  EXPECT_EQ(members(blocks.at("*NSET,NSET=ENAMEL_HIGHEST")), 4u);
  EXPECT_EQ(members(blocks.at("*ELSET,ELSET=CROWN")), 5u);
  EXPECT_EQ(members(blocks.at("*ELSET,ELSET=ROOT")), 26u * 5);
  EXPECT_EQ(members(blocks.at("*NSET,NSET=CROWN_NODES")), 16u + 8);  // those on the border belong to the crown
}

TEST(WriteInp, FacesAreNumberedAsSolversDo) {
  const Reconstruction model = hollow_block();
  auto blocks = blocks_of(inp_text(model));
  const auto& faces = blocks.at("*SURFACE,NAME=DENTINE_CAVITY_WALL,TYPE=ELEMENT");
  ASSERT_EQ(faces.size(), 12u);
  constexpr int corners_of[][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  for (const auto& face : faces) {
    const Tetrahedron& t = model.solids[0].tetrahedra.tetrahedra.at(std::stoul(face[0]) - 1);
    for (const int k : corners_of[std::stoul(face[1].substr(1)) - 1]) {
      const Point3& p = model.solids[0].tetrahedra.points[t[static_cast<std::size_t>(k)]];
      EXPECT_TRUE(p.z == 1 || p.z == 2);
      EXPECT_TRUE(p.x == 1 / 3.0 || p.x == 2 / 3.0);
    }
  }
}

}  // namespace
}  // namespace odontoscope
