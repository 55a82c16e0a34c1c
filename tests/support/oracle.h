#pragma once
// An independent judge of what the DT engine makes: plain, slow, exact, and without a line of the library's geometry.
//
// What a verdict without faults proves of a solid, from the contours and the finished arrays alone:
// - every tetrahedron is positive and within one slab; no two points coincide; no point is unused;
// - each face has one or two tetrahedra, on opposite sides; the faces with one are exactly `surface`;
// - the solid is a PL 3-manifold: the link of every vertex is one disc or one sphere;
// - the surface is closed, oriented, edge- and vertex-manifold, and does not meet itself (small stacks); its shells are
//   nested so that every point of space is covered by no or one tetrahedron;
// - the volumes of the tetrahedra add up, exactly, to the volume that the surface encloses;
// - in each slice's plane the solid's triangles cover exactly the slice's regions: their outline runs through the
// input's
//   points, unchanged, with further points only on contour edges, off them by at most `steiner_ulps` units in the last
//   place of the largest coordinate; and nothing else of the solid touches that plane.
//
// Orientation tests use CGAL's exact predicates, areas and volumes rational numbers. The nesting of shells is decided
// by summed solid angles in doubles, which are multiples of 4 pi and so cannot be mistaken.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::test {

/// How far an added point may be off its contour edge, in units in the last place of the largest coordinate.
inline constexpr double steiner_ulps = 4;

struct OracleOptions {
  /// Every triangle of the surface against every other (with boxes): some seconds for 100,000.
  bool self_intersections = true;
};

struct JudgedShell {
  Shell::Kind kind = Shell::Kind::open;
  long genus = 0;
  double volume = 0;
};

struct Verdict {
  std::vector<std::string> faults;  // the first few of each sort; empty: certified
  std::vector<JudgedShell> shells;
  /// For each point of the solid: its connected component, by shared tetrahedra.
  std::vector<std::size_t> component_of;
  std::size_t components = 0;

  bool certified() const { return faults.empty(); }
  std::string in_words() const;
};

/// Judges one solid against the contours of its structure in `stack` (slices in any order).
Verdict judge(const Solid& solid, const ContourStack& stack, OracleOptions options = {});

/// Faults of a whole result: every solid's, that there is one for each structure that has a contour, that each solid's
/// own report tells the same as the verdict, that exactly the linked regions are joined into one piece, and, of solids
/// without a fault, that the pieces, handles and bubbles that the result tells of each slab, implied and found, are
/// those that oracle_topology.h counts. Whether the two agree is no matter of faults: judge_topology lists where they
/// do not.
std::vector<std::string> faults_of(const Reconstruction& result, const ContourStack& stack, OracleOptions options = {});

/// Shells of all solids, each as "tooth external genus 1", sorted: equal for equal topology.
std::vector<std::string> topology_of(const Reconstruction& result);

}  // namespace odontoscope::test
