#pragma once
// Which parts do canals share? Their lines as a graph of chamber, forks, joins and ends.

#include <cstddef>
#include <vector>

#include "recon/cavity/centre_lines.h"

namespace odontoscope {

/// A piece between two nodes that has no other in between, below the orifices.
struct CanalPart {
  std::size_t from = 0, to = 0;     // nodes, in the order in which its canals pass them
  std::vector<std::size_t> canals;  // of CentreLines::canals: all that lead through it, at least one
  std::size_t first = 0, last = 0;  // its points, those of the first of them
};

struct CanalGraph {
  /// The first is the chamber; its parts begin at the orifices. Of a tube without a chamber it is where canals begin.
  std::vector<Point3> nodes;
  std::vector<CanalPart> parts;

  std::size_t leading_to(std::size_t node) const;
  std::size_t leading_from(std::size_t node) const;
  /// "chamber", "end", "fork", "join", or "crossing" where canals join and part again.
  const char* kind(std::size_t node) const;
};

/// Canals run together where their lines are less than half a radius apart, and that for more than a width: so a fork
/// is told a little below where it begins. Canals that end together share their end.
CanalGraph canal_graph(const CentreLines& lines);

}  // namespace odontoscope
