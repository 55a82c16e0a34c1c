#pragma once
// The triangulation that the contours of one slice are laid over each other in, each triangle with its label; gaps and
// slivers among its faces. Inner part of contour_overlay.h.

#include <cstdint>

#include "recon/delaunay/constrained.h"
#include "recon/partition/materials.h"

namespace odontoscope::partition {

using delaunay::Kernel;
using Members = std::uint64_t;  // bit s: inside structure s

struct FaceMembers {
  Members members = 0;
  bool known = false;
  Label label = void_label;
};

using OverlayFaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceMembers, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
struct PointNumber {
  std::uint32_t value = delaunay::none;  // of Borders::points
};
using OverlayVertexBase = CGAL::Triangulation_vertex_base_with_info_2<PointNumber, Kernel>;
using OverlayStructure = CGAL::Triangulation_data_structure_2<OverlayVertexBase, OverlayFaceBase>;
using Overlay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, OverlayStructure, CGAL::No_constraint_intersection_tag>;

/// Beyond the hull lies void.
inline Label label_of(const Overlay& overlay, Overlay::Face_handle face) {
  return overlay.is_infinite(face) ? void_label : face->info().label;
}

/// Void triangles that touch two structures or more become that of them with priority to whose borders, those at its
/// corners, all its corners are within `materials.gap`. Returns their area, mm².
double close_gaps(Overlay& overlay, const Materials& materials);

/// Faces with little area for their circumference (see Materials::sliver) go to the neighbour with the longest common
/// border. `known` of the faces is overwritten.
void drop_slivers(Overlay& overlay, const Materials& materials);

}  // namespace odontoscope::partition
