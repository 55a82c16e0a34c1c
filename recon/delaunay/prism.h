#pragma once
// Triangles of a slice thickened straight along z: for plates and for raised slabs.

#include <algorithm>
#include <array>
#include <utility>

#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {

enum class Thickened { upwards, downwards };

/// Three positive tetrahedra over the triangle (counter-clockwise seen from +z). `base` and `top` number a point of the
/// triangulation in its own plane and in the plane that it is moved to; where both are one, what would be flat is left
/// out. Neighbours cut the side that they share along the same diagonal. `tetrahedra`: a vector or table of corners.
template <class Base, class Top, class Tetrahedra>
void add_prism(const PlanarTriangle& triangle, Base base, Top top, Thickened direction, Tetrahedra& tetrahedra) {
  using Corners = typename Tetrahedra::value_type;
  std::array<SlicePoint, 3> v = triangle.v;
  std::sort(v.begin(), v.end());  // sorted corners: the diagonal does not depend on the triangle
  const int fixed = (v[0] == triangle.v[0]) + (v[1] == triangle.v[1]) + (v[2] == triangle.v[2]);
  const bool even = fixed != 1;  // one corner in place: the other two were swapped
  const auto add = [&](Corners tet, SlicePoint rising) {
    if (base(rising) == top(rising)) return;
    if (even != (direction == Thickened::upwards)) std::swap(tet[0], tet[1]);
    tetrahedra.push_back(tet);
  };
  add({base(v[0]), base(v[1]), base(v[2]), top(v[2])}, v[2]);
  add({base(v[0]), base(v[1]), top(v[2]), top(v[1])}, v[1]);
  add({base(v[0]), top(v[1]), top(v[2]), top(v[0])}, v[0]);
}

}  // namespace odontoscope::delaunay
