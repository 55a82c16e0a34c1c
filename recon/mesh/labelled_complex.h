#pragma once
// One conforming complex of tetrahedra of several materials, which share their faces. Millimetres; a plain value.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

/// A face between two labels, once. Counter-clockwise seen from the side of `outer`. Where both are materials, `inner`
/// is the lower number.
struct InterfaceTriangle {
  Triangle triangle{};
  Label inner = void_label, outer = void_label;  // outer may be void, inner never is
};

struct LabelledComplex {
  std::vector<std::string> structures;  // label l is structures[l - 1]
  TetraMesh mesh;  // no tetrahedra of void; each face belongs to at most two, each point to at least one
  std::vector<InterfaceTriangle> interfaces;  // every face between two labels
};

}  // namespace odontoscope
