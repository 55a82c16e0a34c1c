#pragma once
// The 256 cases of marching cubes, made by code from base cases.
//
// W. E. Lorensen, H. E. Cline, "Marching cubes: a high resolution 3D surface construction algorithm", SIGGRAPH 1987,
// list 15 ways (0 to 14) in which a surface can pass a cell, up to rotation and to swapping inside and outside. The
// tables:
//
// classic: that list, closed under rotation and complement. A case with more than four corners inside is the complement
// of one with fewer, its triangles turned over. A face with two inside corners across a diagonal is ambiguous: the base
// cases keep its inside corners apart, complements keep its outside corners apart. Where one of each meets, the surface
// has a crack (M. J. Durst, Computer Graphics 22(2), 1988).
//
// classic-unoriented: the same, but complements are not turned over: neighbours disagree about which side is out.
// Two-sided rendering hides it; culling back faces shows holes.
//
// consistent: three base cases more (the complements of 3, 6 and 7), so that inside corners of an ambiguous face are
// kept apart in every case: C. Montani, R. Scateni, R. Scopigno, "A modified look-up table for implicit disambiguation
// of marching cubes", The Visual Computer 10, 1994. No face fails to match.
//
// Of the 12,288 pairs of cells that can share a face (2^12 corners, three axes) 660 do not match with the classic
// tables, 3,000 more disagree about orientation with classic-unoriented, none with consistent; a test counts them all.
//
// Not supported: topologically correct variants (MC33), which also look at the values.
//
// A cell's corner c is at (c & 1, c >> 1 & 1, c >> 2 & 1); bit c of a case number says that the corner is inside. Edge
// 4 a + 2 v + u runs along axis a; u and v are its places along the axes that follow a cyclically. Face 2 a + s is the
// one at place s along axis a. Triangles are counter-clockwise seen from outside the material.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "recon/core/named.h"

namespace odontoscope {

enum class CaseTable { classic, classic_unoriented, consistent };
inline constexpr NameTable<CaseTable, 3> case_tables{{{"classic", CaseTable::classic},
                                                      {"classic-unoriented", CaseTable::classic_unoriented},
                                                      {"consistent", CaseTable::consistent}}};
inline const char* name(CaseTable table) { return word_of(case_tables, table); }

using CaseNumber = std::uint8_t;
using CellEdge = std::uint8_t;  // 0 to 11
using CellFace = std::uint8_t;  // 0 to 5

struct CellTriangles {
  static constexpr std::size_t most = 5;
  std::uint8_t count = 0;
  std::array<std::array<CellEdge, 3>, most> edges{};  // of `count` triangles, the cell edges that their corners lie on
  std::uint8_t base = 0;                              // base case, 0 to 14
  bool complement = false;                            // of that base case: inside and outside swapped

  std::span<const std::array<CellEdge, 3>> triangles() const { return {edges.data(), count}; }
};

/// By case number.
const std::array<CellTriangles, 256>& cell_triangles(CaseTable table);

/// The two corners of an edge, the lower first.
std::array<int, 2> corners_of(CellEdge edge);
/// The edges of face 2 a or 2 a + 1: place 0 to 3 tells the same edge of the cells on both sides.
std::array<CellEdge, 4> edges_of(CellFace face);

/// A side of a cell's triangles that lies in a face: from one edge of the face to another, by their places in edges_of.
struct FaceSegment {
  std::uint8_t from = 0, to = 0;
  friend bool operator==(const FaceSegment&, const FaceSegment&) = default;
};
std::vector<FaceSegment> face_segments(const CellTriangles& cell, CellFace face);

/// How the triangles of two cells meet in the face that they share.
struct FaceMeeting {
  std::vector<FaceSegment> unmatched;    // of either cell, with no partner: boundary edges
  std::vector<FaceSegment> misoriented;  // that both cells run through the same way
};
/// `first` is the cell at the lower place along `axis`.
FaceMeeting meeting(CaseTable table, CaseNumber first, CaseNumber second, int axis);

/// True if the face has two inside corners across a diagonal.
bool is_ambiguous(CaseNumber cell, CellFace face);

}  // namespace odontoscope
