#pragma once
// What a partition is made of.

#include <cstdint>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::partition {

/// What becomes of a piece of a structure that only says where others end: it goes to the inner one if it borders on
/// it, else to the outer one.
struct StandIn {
  Label inner = void_label, outer = void_label;
};

/// The structures of a partition. Label l belongs to structures[l - 1]; void is label 0.
struct Materials {
  std::vector<std::string> structures;
  std::vector<std::uint32_t> rank;  // of each structure: 0 wins over 1 where they overlap
  double gap = 0;                   // mm; void narrower than this between two structures is closed
  double sliver = 0;                // mm; faces of less than this mean width go to their neighbours
  std::vector<StandIn> stand_ins;   // of the last structures, which get no label of their own

  std::size_t own_labels() const { return structures.size() - stand_ins.size(); }
  bool wins(Label a, Label b) const { return a != void_label && (b == void_label || rank[a - 1] < rank[b - 1]); }
};

/// Of all structures of the stack: those that are named win first, then the others from the inside out. Throws
/// InputError unknown-structure for a name that is not there, too-many-structures. Precondition: the stack is ordered.
Materials materials_of(const ContourStack& stack, const std::vector<std::string>& priority = {}, double gap = 0);

}  // namespace odontoscope::partition
