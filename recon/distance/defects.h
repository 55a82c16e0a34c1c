#pragma once
// Why a DB surface is broken where it is broken: each defect is traced to the two cells that disagree about the face
// between them.
//
// Triangles share points by grid edge. The sides of a cell's triangles lie inside the cell, where two of its own
// triangles meet, or in one of its faces, where those of the next cell should take them up. So every defect belongs to
// one face.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/distance/marching_cubes.h"

namespace odontoscope {

enum class DefectKind {
  crack,        // an edge with one triangle: the other cell has no such side
  misoriented,  // an edge with two triangles that run through it the same way
  nonmanifold,  // an edge with more than two triangles; no table here makes one
};
const char* name(DefectKind kind);

struct Defect {
  DefectKind kind = DefectKind::crack;
  PointIndex from = 0, to = 0;  // ends of the edge, by number of the surface's points, from < to
  Point3 at;                    // its middle
  int axis = 0;                 // of the face's normal
  GridPlace first{}, second{};  // the cells on both sides, `second` the next along `axis`
  CaseNumber first_case = 0, second_case = 0;
  bool ambiguous_face = false;
  friend bool operator==(const Defect&, const Defect&) = default;
};

/// Read off the surface: edges that are not shared by two triangles in opposite ways. By `from`, then `to`.
/// Precondition: `surface` was marched from `field` on `grid`.
std::vector<Defect> defects_of(const Grid& grid, const Field& field, const MarchedSurface& surface);

/// The same from the field and the table alone, face by face, without the surface: what the table must make of this
/// field. Parallel; stage "predict defects". A test holds the two against each other.
std::vector<Defect> predicted_defects(const Grid& grid, const Field& field, CaseTable table,
                                      const MarchedSurface& surface, const Progress& progress = {});

/// One or two sentences for a person: which cells, which face, which cases, which table, and what follows.
std::string in_words(const Defect& defect, CaseTable table);

}  // namespace odontoscope
