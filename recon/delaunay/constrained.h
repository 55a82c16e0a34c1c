#pragma once
// The constrained Delaunay triangulation of a slice's contours in the plane, as CGAL makes it; for conform.cpp and refine.cpp alone, since its headers
// take long to compile.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstdint>
#include <vector>

#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct Number {
  std::uint32_t value = none;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Number, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
using Vertex = Cdt::Vertex_handle;
using Face = Cdt::Face_handle;

/// Points in this order, numbered as in `points`.
std::vector<Vertex> insert_points(Cdt& cdt, const std::vector<Point2>& points, const std::vector<std::uint32_t>& order);

}  // namespace odontoscope::delaunay
