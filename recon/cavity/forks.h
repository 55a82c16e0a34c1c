#pragma once
// Is a short branch of a canal a canal of its own?

#include <vector>

#include "recon/cavity/centre_lines.h"
#include "recon/cavity/wall_tree.h"

namespace odontoscope::cavity {

/// What a branch is beyond the canal that it leaves.
struct BranchShape {
  std::size_t parent = 0;  // of the canals: the one whose line is nearest to where it leaves
  std::size_t leaves =
      0;              // of its points: the first one from which on it is apart from every canal; their number: nowhere
  double length = 0;  // from there to the wall at its end
  double mean_width = 0;  // of that part
};

/// What tells a branch's place apart from a canal: material on the straight way to the canal's line; or also that it
/// lies beyond the canal's ball with material on both sides along it, for a branch straight across has none between.
enum class Apart { material_between, or_sideways };
BranchShape branch_shape(const CentreLine& branch, const std::vector<CentreLine>& canals, const WallTree& tree,
                         Apart apart = Apart::material_between);

/// See limits::fork_length. `crown`: unit.
bool is_fork(const CentreLine& branch, const std::vector<CentreLine>& canals, const WallTree& tree,
             const Direction& crown);

}  // namespace odontoscope::cavity
