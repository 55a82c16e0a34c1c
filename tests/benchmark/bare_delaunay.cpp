#include "tests/benchmark/bare_delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace odontoscope {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

BareDelaunay::BareDelaunay(const ContourStack& stack) {
  for (std::size_t k = 0; k + 1 < stack.slices.size(); ++k) {
    slabs_.emplace_back();
    for (std::size_t side : {k, k + 1})
      for (const Contour& contour : stack.slices[side].contours)
        for (const Point2& p : contour.points) slabs_.back().push_back({p.x, p.y, stack.slices[side].z});
  }
}

std::size_t BareDelaunay::run() const {
  std::size_t tetrahedra = 0;
  for (const auto& slab : slabs_) {
    std::vector<Kernel::Point_3> points;
    points.reserve(slab.size());
    for (const auto& [x, y, z] : slab) points.emplace_back(x, y, z);
    const CGAL::Delaunay_triangulation_3<Kernel> triangulation(points.begin(), points.end());
    tetrahedra += triangulation.number_of_finite_cells();
  }
  return tetrahedra;
}

}  // namespace odontoscope
