// The tables of marching-cubes cases, proven by counting everything there is.

#include "recon/distance/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <vector>

namespace odontoscope {
namespace {

constexpr CaseTable tables[] = {CaseTable::classic, CaseTable::classic_unoriented, CaseTable::consistent};

struct PairCounts {
  int pairs = 0, cracked = 0, misoriented = 0;
  friend bool operator==(const PairCounts&, const PairCounts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const PairCounts& c) {
    return out << c.pairs << " pairs, " << c.cracked << " cracked, " << c.misoriented << " misoriented";
  }
};

/// All ways to be inside or outside of the twelve corners of two cells that share a face, along all axes.
PairCounts count_pairs(CaseTable table) {
  PairCounts counts;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corners = 0; corners < 1 << 12; ++corners) {
      // Bits 0-3 lie before the face, 4-7 on it, 8-11 behind it.
      int first = 0, second = 0;
      for (int i = 0; i < 4; ++i) {
        const int low = (i & 1) << ((axis + 1) % 3) | (i >> 1) << ((axis + 2) % 3), high = low | 1 << axis;
        first |= (corners >> i & 1) << low | (corners >> (4 + i) & 1) << high;
        second |= (corners >> (4 + i) & 1) << low | (corners >> (8 + i) & 1) << high;
      }
      const FaceMeeting met = meeting(table, static_cast<CaseNumber>(first), static_cast<CaseNumber>(second), axis);
      ++counts.pairs;
      counts.cracked += !met.unmatched.empty();
      counts.misoriented += !met.misoriented.empty();
    }
  }
  return counts;
}

TEST(Cases, ClassicCracksAtAmbiguousFacesOfComplementsOnly) {
  EXPECT_EQ(count_pairs(CaseTable::classic), (PairCounts{12'288, 660, 0}));
}

TEST(Cases, WithoutTurningOverManyPairsDisagreeAboutOrientation) {
  EXPECT_EQ(count_pairs(CaseTable::classic_unoriented), (PairCounts{12'288, 660, 3'000}));
}

TEST(Cases, ConsistentHasNoDefectInAnyPair) {
  EXPECT_EQ(count_pairs(CaseTable::consistent), (PairCounts{12'288, 0, 0}));
}

/// Corners on both sides of an edge of the cell.
bool is_cut(int cell, CellEdge edge) {
  const auto [low, high] = corners_of(edge);
  return (cell >> low & 1) != (cell >> high & 1);
}

TEST(Cases, UseEveryCutEdgeAndNoOther) {
  for (const CaseTable table : tables) {
    for (int cell = 0; cell < 256; ++cell) {
      std::set<int> used;
      for (const auto& triangle : cell_triangles(table)[cell].triangles())
        used.insert(triangle.begin(), triangle.end());
      for (CellEdge edge = 0; edge < 12; ++edge) {
        EXPECT_EQ(used.contains(edge), is_cut(cell, edge)) << name(table) << " case " << cell << " edge " << int(edge);
      }
    }
  }
}

/// Directed sides of a cell's triangles, less those that another triangle of the cell takes up the other way.
std::vector<std::pair<int, int>> open_sides(const CellTriangles& cell) {
  std::multiset<std::pair<int, int>> sides;
  for (const auto& t : cell.triangles()) {
    for (int i = 0; i < 3; ++i) {
      const auto partner = sides.find({t[(i + 1) % 3], t[i]});
      if (partner != sides.end())
        sides.erase(partner);
      else
        sides.insert({t[i], t[(i + 1) % 3]});
    }
  }
  return {sides.begin(), sides.end()};
}

TEST(Cases, TrianglesOfACellEndInItsFacesAndNowhereElse) {
  for (const CaseTable table : tables) {
    for (int cell = 0; cell < 256; ++cell) {
      const CellTriangles& triangles = cell_triangles(table)[cell];
      std::size_t in_faces = 0;
      for (CellFace face = 0; face < 6; ++face) in_faces += face_segments(triangles, face).size();
      EXPECT_EQ(in_faces, open_sides(triangles).size()) << name(table) << " case " << cell;
    }
  }
}

TEST(Cases, FacesCarryOneSegmentIfCutAndTwoIfAmbiguous) {
  for (const CaseTable table : tables) {
    for (int cell = 0; cell < 256; ++cell) {
      for (CellFace face = 0; face < 6; ++face) {
        const auto edges = edges_of(face);
        const auto cut = std::count_if(edges.begin(), edges.end(), [&](CellEdge e) { return is_cut(cell, e); });
        EXPECT_EQ(is_ambiguous(static_cast<CaseNumber>(cell), face), cut == 4);
        EXPECT_EQ(face_segments(cell_triangles(table)[cell], face).size(), std::size_t(cut / 2))
            << name(table) << " case " << cell;
      }
    }
  }
}

using Vector = std::array<double, 3>;
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector place(int corner) { return {double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)}; }
Vector middle(CellEdge edge) {
  const auto [a, b] = corners_of(edge);
  Vector m{};
  for (int i = 0; i < 3; ++i) m[i] = (place(a)[i] + place(b)[i]) / 2;
  return m;
}

/// Six times the volume of the inside part: the surface, and on each face the pieces between it and the inside corners.
/// Turning the surface over changes its sign; here only whether each polygon has its inside corners behind it matters.
int wrongly_turned(CaseTable table) {
  int wrong = 0;
  for (int cell = 0; cell < 256; ++cell) {
    for (const auto& t : cell_triangles(table)[cell].triangles()) {
      const Vector normal = cross(minus(middle(t[1]), middle(t[0])), minus(middle(t[2]), middle(t[0])));
      double votes =
          0;  // of the cut edges at its corners: the normal must point from inside to outside along all of them, in sum
      for (const CellEdge edge : t) {
        auto [from, to] = corners_of(edge);
        if ((cell >> from & 1) == 0) std::swap(from, to);
        votes += dot(normal, minus(place(to), place(from)));
      }
      if (votes <= 0) {
        ++wrong;
        break;
      }
    }
  }
  return wrong;
}

TEST(Cases, TrianglesFaceOutwards) {
  EXPECT_EQ(wrongly_turned(CaseTable::classic), 0);
  EXPECT_EQ(wrongly_turned(CaseTable::consistent), 0);
  // 1 + 8 + 28 + 56 - the empty case 255: all with more than four corners inside.
  EXPECT_EQ(wrongly_turned(CaseTable::classic_unoriented), 92);
}

TEST(Cases, FollowFromTheFifteenBaseCases) {
  std::map<int, int> by_base;
  for (const CellTriangles& cell : cell_triangles(CaseTable::classic)) ++by_base[cell.base];
  // Sizes of the classes of the 256 cases under rotation and complement; they sum up to 256.
  const std::map<int, int> sizes{{0, 2}, {1, 16}, {2, 24}, {3, 24},  {4, 8},   {5, 48}, {6, 48}, {7, 16},
                                 {8, 6}, {9, 8},  {10, 6}, {11, 12}, {12, 24}, {13, 2}, {14, 12}};
  EXPECT_EQ(by_base, sizes);
}

TEST(Cases, ConsistentDiffersFromClassicWhereAComplementHasAnAmbiguousFaceOnly) {
  for (int cell = 0; cell < 256; ++cell) {
    bool ambiguous = false;
    for (CellFace face = 0; face < 6; ++face)
      ambiguous = ambiguous || is_ambiguous(static_cast<CaseNumber>(cell), face);
    const bool differs =
        cell_triangles(CaseTable::classic)[cell].edges != cell_triangles(CaseTable::consistent)[cell].edges;
    EXPECT_EQ(differs, ambiguous && std::popcount(unsigned(cell)) > 4) << cell;
  }
}

}  // namespace
}  // namespace odontoscope
