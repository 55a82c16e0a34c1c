#pragma once
// What any implementation on CGAL would pay at least: the 3D Delaunay triangulation of every slab's points, and nothing
// else.

#include <array>
#include <cstddef>
#include <vector>

#include "recon/input/contour_stack.h"

namespace odontoscope {

/// Bulk insertion (CGAL sorts the points along a space-filling curve itself), on one thread. Returns the number of
/// finite tetrahedra. `stack` by ascending z.
class BareDelaunay {
 public:
  explicit BareDelaunay(const ContourStack& stack);
  std::size_t run() const;

 private:
  std::vector<std::vector<std::array<double, 3>>> slabs_;
};

}  // namespace odontoscope
