#pragma once
// Awkward stacks of several structures, by name.

#include "recon/input/contour_stack.h"

namespace odontoscope::test {

/// Three materials around one point, which wanders from slice to slice.
ContourStack three_in_a_drifting_line();
/// "between" lies between "left" and "right" in the middle slice only.
ContourStack one_between_two_in_one_slice();
/// A ring of enamel round dentine that drifts sideways by twice its own thickness a slice.
ContourStack thin_shell_that_drifts();
/// Two squares of one material that touch in a corner, across void.
ContourStack checkerboard_corner();
/// A canal of pulp down through the apex of its root.
ContourStack canal_through_the_apex();

/// Enamel on one side of a pillar of dentine, thinner and thinner downwards, whose margin rises and falls by 1 mm round
/// it, as on a tilted tooth.
ContourStack slanting_margin();
/// The height of its margin at an angle round z.
double slanting_margin_height(double angle);

}  // namespace odontoscope::test
