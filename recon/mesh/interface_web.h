#pragma once
// Interfaces of several materials on their way to fewer triangles: who meets whom, and which edges may be collapsed.
//
// Where two triangles meet in an edge the interface is a surface; where more do, it is a *junction line*, and where
// such lines meet or end, a *junction point*. The link condition for complexes with such strata (T. Dey, H.
// Edelsbrunner, S. Guha, D. Nekhayev, "Topology preserving edge contraction", 1999; D. Thomas, V. Natarajan, G.-P.
// Bonneau, "Link conditions for simplifying meshes with embedded structures", 2011) tells when a collapse leaves all of
// them as they were: no piece, handle or cavity of any material changes, and neighbours stay neighbours.

#include <cstdint>
#include <span>
#include <vector>

#include "recon/mesh/labelled_complex.h"

namespace odontoscope {

class InterfaceWeb {
 public:
  enum class Stratum { surface, line, point };  // from many to few

  /// A vertex beside another, and how many triangles their edge has.
  struct Neighbour {
    PointIndex vertex;
    std::uint32_t triangles;
    bool on_surface() const { return triangles == 2; }
  };
  /// Ascending.
  using Ring = std::vector<Neighbour>;

  InterfaceWeb(std::vector<Point3> points, std::vector<InterfaceTriangle> faces);

  const std::vector<Point3>& points() const { return points_; }
  /// Those that vanished have an inner label of void.
  const std::vector<InterfaceTriangle>& faces() const { return faces_; }
  bool alive(std::uint32_t face) const { return faces_[face].inner != void_label; }
  std::span<const std::uint32_t> faces_of(PointIndex v) const { return faces_of_[v]; }
  Ring ring(PointIndex v) const;
  static Stratum stratum(const Ring& ring);
  /// 0 if there is no such edge.
  static std::uint32_t triangles_between(const Ring& ring, PointIndex other);

  /// Do all strata stay as they are if the edge from a vertex with the first ring to `b` becomes one vertex? Triangles
  /// that would become one are not looked for: they meet, which whoever guards against cuts sees.
  bool keeps_topology(const Ring& ring_a, PointIndex b, const Ring& ring_b) const;

  /// The edge becomes the vertex `a`, at `place`. Returns the faces that vanish.
  std::vector<std::uint32_t> collapse(PointIndex a, PointIndex b, const Point3& place);

  /// A new vertex at `place` in the middle of an edge: each triangle of it keeps the half with `a`; the halves with `b`
  /// are new faces, in the order of the old ones. Returns the vertex.
  PointIndex split(PointIndex a, PointIndex b, const Point3& place);

  /// The other diagonal of the two triangles of a surface edge. Precondition: they have one pair of labels, and are
  /// turned alike.
  void flip(PointIndex a, PointIndex b);

  void move(PointIndex v, const Point3& place) { points_[v] = place; }
  /// The triangles of an edge, ascending.
  std::vector<std::uint32_t> faces_between(PointIndex a, PointIndex b) const;

 private:
  std::vector<Point3> points_;
  std::vector<InterfaceTriangle> faces_;
  std::vector<std::vector<std::uint32_t>> faces_of_;  // alive ones, ascending
};

}  // namespace odontoscope
