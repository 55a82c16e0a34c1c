#pragma once
// The named surfaces of a partition: where two materials meet, and the outside of each.

#include <cstdint>
#include <string>
#include <vector>

#include "recon/mesh/labelled_complex.h"

namespace odontoscope {

struct ComplexGroup {
  std::string name;                              // "enamel-dentine junction", "pulp wall", "A-B border", "A outside"
  Label inner = void_label, outer = void_label;  // as in InterfaceTriangle
  std::vector<std::uint32_t> faces;              // numbers of interfaces, ascending
};

/// In the order of inner, then outer; those that are there. "Outside" is whatever is void, cavities too.
std::vector<ComplexGroup> groups_of(const LabelledComplex& complex);

/// A face of a tetrahedron: face i lies opposite vertex i.
struct ElementFace {
  std::uint32_t tetrahedron = 0;
  int face = 0;
};

/// For each interface, the element on the side of `inner` whose face it is.
std::vector<ElementFace> inner_elements(const LabelledComplex& complex);

}  // namespace odontoscope
