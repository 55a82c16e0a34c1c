#pragma once
// Where the interfaces of a complex were before they were meshed anew: what new vertices are put back onto, and what
// new triangles must not leave.

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "recon/mesh/box_tree.h"
#include "recon/mesh/corners.h"
#include "recon/mesh/interface_web.h"
#include "recon/mesh/vector.h"

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
  /// Triangles, or edges as triangles of two corners.
  class Places {
   public:
    explicit Places(const std::vector<Corners>& corners);
    Nearest nearest(const Point3& from) const;

   private:
    struct Face {
      Point3 a;
      Direction ab, ac;
    };
    BoxTree<std::array<double, 3>> tree_;
    std::vector<Face> faces_;  // leaf by leaf
  };
  std::map<LabelPair, Places> faces_;
  std::map<JunctionKind, Places> lines_;
};

}  // namespace odontoscope::elements
