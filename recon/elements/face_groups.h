#pragma once
// Which faces may a new one not touch? A tree of boxes over the faces of a web that is being meshed anew. Needs CGAL's
// headers.

#include <vector>

#include "recon/mesh/interface_web.h"
#include "recon/mesh/moving_box_tree.h"
#include "recon/mesh/triangle_pairs.h"

namespace odontoscope::elements {

NumberedTriangle numbered(const Triangle& triangle, const std::array<Point3, 3>& corners);

/// The tree's shape is that of the faces at its making; faces that come later share a leaf with the one that they came
/// from.
class FaceGroups {
 public:
  explicit FaceGroups(const InterfaceWeb& web);

  /// `made` is a new face beside `beside`.
  void join(std::uint32_t made, std::uint32_t beside, const InterfaceWeb& web);
  /// The face moved or vanished.
  void update(std::uint32_t face, const InterfaceWeb& web);

  /// Have the triangles an area, and meet neither each other nor any face but `without` elsewhere than in what they
  /// share by number? Exact.
  bool fit(const std::vector<NumberedTriangle>& triangles, const std::vector<std::uint32_t>& without) const;

 private:
  void settle(std::uint32_t group);

  std::vector<NumberedTriangle> faces_;
  std::vector<MovingBox> boxes_;                     // empty: vanished
  std::vector<std::uint32_t> group_;                 // of each face
  std::vector<std::vector<std::uint32_t>> members_;  // of each group
  MovingBoxTree tree_;
};

}  // namespace odontoscope::elements
