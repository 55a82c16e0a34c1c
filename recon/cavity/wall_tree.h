#pragma once
// How far is a closed wall, and on which side of it is one?

#include <cstdint>
#include <limits>
#include <vector>

#include "recon/mesh/surface_tree.h"

namespace odontoscope {

class WallTree {
 public:
  struct Nearest {
    Point3 at;
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = 0;
    bool front = false;  // on the side from which the triangles are counter-clockwise
  };

  /// Precondition: a closed oriented manifold (of any number of shells). Keeps a copy of what it needs.
  explicit WallTree(const SurfaceMesh& wall);

  /// The nearest place of the wall. The side is that of the angle-weighted pseudonormal of the nearest face, edge or
  /// vertex, which is right for every point off the wall (J. A. Baerentzen, H. Aanaes, "Signed distance computation
  /// using the angle weighted pseudonormal", 2005). About two microseconds for 17,000 triangles.
  Nearest nearest(const Point3& from) const;

  /// Distance to the wall: positive in front of it, that is in the void for the wall of a cavity, negative behind it.
  double clearance(const Point3& from) const;

  /// The same where it is more than `least`; else something not more than that, sooner. `most`: what it is known not to
  /// exceed. Precondition: 0 <= least < most.
  double clearance_above(const Point3& from, double least, double most = std::numeric_limits<double>::infinity()) const;
  /// And a place of the wall that shows it: no farther away than that.
  double clearance_above(const Point3& from, double least, double most, Point3& shown_by) const;

 private:
  Nearest nearest(const Point3& from, double enough, double most) const;

  SurfaceTree tree_;
  std::vector<Direction> normals_;  // of triangles
  std::vector<Direction> vertex_normals_;
  std::vector<Direction> edge_normals_;  // one a half-edge
  std::vector<Triangle> triangles_;
};

}  // namespace odontoscope
