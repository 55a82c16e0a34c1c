#include "recon/cavity/polygon_cap.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <set>

namespace odontoscope::cavity {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlaneVertexBase = CGAL::Triangulation_vertex_base_with_info_2<PointIndex, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<PlaneVertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

}  // namespace

std::optional<std::vector<Triangle>> triangulated(const std::vector<Point2>& polygon) {
  Triangulation made;
  std::vector<Triangulation::Vertex_handle> corners;
  for (PointIndex i = 0; i < polygon.size(); ++i) {
    corners.push_back(made.insert(Kernel::Point_2(polygon[i].x, polygon[i].y)));
    corners.back()->info() = i;
  }
  if (made.number_of_vertices() != polygon.size() || polygon.size() < 3)
    return std::nullopt;  // two corners in one place
  try {
    for (std::size_t i = 0; i < corners.size(); ++i)
      made.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  // All that is reached from outside without crossing a side is outside.
  std::set<Triangulation::Face_handle> outside{made.infinite_face()};
  std::vector<Triangulation::Face_handle> waiting{made.infinite_face()};
  while (!waiting.empty()) {
    const Triangulation::Face_handle face = waiting.back();
    waiting.pop_back();
    for (int k = 0; k < 3; ++k)
      if (!face->is_constrained(k) && outside.insert(face->neighbor(k)).second) waiting.push_back(face->neighbor(k));
  }
  std::vector<Triangle> triangles;
  for (const Triangulation::Face_handle face : made.finite_face_handles())
    if (!outside.contains(face))
      triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  // A polygon of n corners has n - 2.
  if (triangles.size() + 2 != polygon.size()) return std::nullopt;
  return triangles;
}

}  // namespace odontoscope::cavity
