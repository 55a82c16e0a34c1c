#pragma once
// Where the vertex belongs that an edge is collapsed into, and what that costs: the error in volume, without memory of
// the original, of P. Lindstrom and G. Turk, "Fast and memory efficient polygonal simplification", IEEE Visualization
// 1998. Lengths as given; coordinates relative to a point nearby, so that nothing is lost to rounding.

#include <array>

#include "recon/mesh/vector.h"

namespace odontoscope {

class CollapseQuadric {
 public:
  /// The triangle abc of the star.
  void add_triangle(const Direction& a, const Direction& b, const Direction& c);
  /// An edge pq of a junction line: `square` is the squared length of the edge to be collapsed, by which lines count.
  void add_line(const Direction& p, const Direction& q, double square);

  /// The volume that the triangles enclose with any far point stays the same, exactly but for rounding, if
  /// `keep_volume`; else the place is only the best.
  Direction best(bool keep_volume) const;
  /// Square of a volume.
  double cost(const Direction& at) const;

 private:
  std::array<double, 6> square_{};  // xx, xy, xz, yy, yz, zz
  Direction linear_;
  double constant_ = 0;
  Direction normals_;  // sum, twice the area
  double offset_ = 0;
  double areas_ = 0;  // sum of their squares
};

}  // namespace odontoscope
