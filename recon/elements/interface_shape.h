#pragma once
// Where the interfaces of a complex were before they were meshed anew: what new vertices are put back onto, and what
// new triangles must not leave.

#include <map>
#include <utility>
#include <vector>

#include "recon/mesh/interface_web.h"
#include "recon/mesh/surface_tree.h"

namespace odontoscope::elements {

/// The labels on either side of a face, inner and outer.
using LabelPair = std::pair<Label, Label>;
/// The pairs of all faces of a junction line, ascending.
using JunctionKind = std::vector<LabelPair>;

JunctionKind junction_kind(const InterfaceWeb& web, PointIndex a, PointIndex b);

class InterfaceShape {
 public:
  struct Nearest {
    Point3 at;
    double distance;
  };

  /// Keeps a copy of what it needs.
  explicit InterfaceShape(const InterfaceWeb& web);

  /// Precondition: there are faces between these labels.
  Nearest on_faces(const LabelPair& labels, const Point3& from) const;
  /// Precondition: there are lines of this kind.
  Nearest on_lines(const JunctionKind& kind, const Point3& from) const;

 private:
  std::map<LabelPair, SurfaceTree> faces_;
  std::map<JunctionKind, SurfaceTree> lines_;
};

}  // namespace odontoscope::elements
