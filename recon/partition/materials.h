#pragma once
// What a partition is made of.

#include <cstdint>
#include <string>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope::partition {

/// The structures of a partition. Label l belongs to structures[l - 1]; void is label 0.
struct Materials {
  std::vector<std::string> structures;
  std::vector<std::uint32_t> rank;   // of each structure: 0 wins over 1 where they overlap
  double gap = 0;                    // mm; void narrower than this between two structures is closed
  double sliver = 0;                 // mm; faces of less than this mean width go to their neighbours
  std::vector<Label> stand_in;       // of each structure the label that its places get; empty: its own

  Label label_of(std::size_t structure) const { return stand_in.empty() ? static_cast<Label>(structure + 1) : stand_in[structure]; }
  bool wins(Label a, Label b) const { return a != void_label && (b == void_label || rank[a - 1] < rank[b - 1]); }
};

}  // namespace odontoscope::partition
