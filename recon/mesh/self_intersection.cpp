#include "recon/mesh/self_intersection.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>

#include "recon/mesh/cgal_surface.h"

namespace odontoscope {

std::vector<std::pair<std::size_t, std::size_t>> self_intersections(const SurfaceMesh& mesh) {
  using Face = HalfEdgeMesh::Face_index;
  std::vector<std::pair<Face, Face>> found;
  CGAL::Polygon_mesh_processing::self_intersections(to_half_edges(mesh), std::back_inserter(found));
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  pairs.reserve(found.size());
  for (const auto& [a, b] : found) pairs.emplace_back(std::min(a.idx(), b.idx()), std::max(a.idx(), b.idx()));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace odontoscope
