#pragma once
// Slices between two in which what only one of them has is drawn back along its length. Inner part of blend.h.
//
// Distances shrink a lobe to its middle line, and there it vanishes all at once; what is triangulated between the last
// slice that has it and the first without roofs whatever it ran beside. So slices are put between the two in which the
// lobe grows shorter, from its end to where it joins what stays.

#include <vector>

#include "recon/between/composed.h"

namespace odontoscope::between {

/// A slice at a share of the slab's height.
struct StagedWindow {
  double share = 0;
  Window window;
};

/// `stages` and more between each two of which one has what reaches farther from both than limits::sudden_steps steps
/// of the grid, as the way runs within it. Preconditions: shares ascend strictly, the windows are on the same grid.
std::vector<StagedWindow> drawn_back(const std::vector<StagedWindow>& stages, const Grid& grid);

}  // namespace odontoscope::between
