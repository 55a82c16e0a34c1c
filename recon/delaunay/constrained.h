#pragma once
// The constrained Delaunay triangulation of a slice's contours in the plane, as CGAL makes it; for conform.cpp,
// refine.cpp and the planar partitions alone, since its headers take long to compile.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstdint>
#include <vector>

#include "recon/delaunay/planar.h"

namespace odontoscope::delaunay {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<SlicePoint, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<TriangleIndex, Kernel,
                                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
using Vertex = Cdt::Vertex_handle;
using Face = Cdt::Face_handle;

/// By spatial_order.
std::vector<SlicePoint> order_of(const Table<SlicePoint, Point2>& points);

/// Points in this order, numbered as in `points`.
Table<SlicePoint, Vertex> insert_points(Cdt& cdt, const Table<SlicePoint, Point2>& points,
                                        const std::vector<SlicePoint>& order);

/// A point of the two triangles beside the edge that lies within its diametral circle, the one nearest to the edge; a
/// null handle if none does: then no other point does, since the triangulation is constrained Delaunay.
Vertex encroacher(const Cdt& cdt, Face face, int i);

/// Has neither triangle beside the edge the other's corner in its circumcircle?
bool is_delaunay(const Cdt& cdt, Face face, int i);

/// Triangles, neighbours and circumcentres; vertices are numbered as in `planar.points`.
void copy_triangles(const Cdt& cdt, Planar& planar);

}  // namespace odontoscope::delaunay
