#pragma once
// The parts of the oracle; see oracle.h for what they prove together.

#include <map>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "tests/support/oracle.h"

namespace odontoscope::test {

/// Collects faults, a few of each sort, with counts.
class Faults {
 public:
  void add(const std::string& sort, const std::string& where = {});
  std::vector<std::string> list() const;

 private:
  struct Sort {
    std::size_t count = 0;
    std::string first;
  };
  std::map<std::string, Sort> sorts_;
};

/// A slice of one structure: outer contours counter-clockwise, holes clockwise.
struct JudgedSlice {
  double z = 0;
  std::vector<std::vector<Point2>> rings;
};

/// By ascending z; contours of `structure` only, oriented by their depth.
std::vector<JudgedSlice> slices_of(const ContourStack& stack, const std::string& structure);

// --- oracle_solid.cpp ------------------------------------------------------------------------------------------------
void judge_points(const TetraMesh& mesh, const std::vector<JudgedSlice>& slices, Faults& faults);
void judge_tetrahedra(const TetraMesh& mesh, const std::vector<JudgedSlice>& slices, Faults& faults);
/// Faces with one tetrahedron, outward oriented, each starting at its smallest index, sorted.
std::vector<Triangle> judge_faces(const TetraMesh& mesh, Faults& faults);
void judge_vertex_links(const TetraMesh& mesh, Faults& faults);
std::vector<std::size_t> components_of(const TetraMesh& mesh, std::size_t& count);

// --- oracle_surface.cpp ----------------------------------------------------------------------------------------------
/// The surface's triangles in the solid's numbers, each starting at its smallest index, sorted.
std::vector<Triangle> surface_in_solid(const Solid& solid, Faults& faults);
/// Triangles must be closed and edge- and vertex-manifold for the shells to mean anything; true if they are.
bool judge_manifold(const std::vector<Triangle>& triangles, Faults& faults);
std::vector<JudgedShell> judge_shells(const TetraMesh& mesh, const std::vector<Triangle>& triangles, Faults& faults);
void judge_self_intersections(const TetraMesh& mesh, const std::vector<Triangle>& triangles, Faults& faults);
void judge_volume(const TetraMesh& mesh, const std::vector<Triangle>& triangles, Faults& faults);

// --- oracle_section.cpp ----------------------------------------------------------------------------------------------
void judge_section(const TetraMesh& mesh, const JudgedSlice& slice, Faults& faults);

}  // namespace odontoscope::test
