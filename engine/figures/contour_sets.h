#pragma once
// Small stacks of contours that show one thing each.

#include "recon/input/contour_stack.h"

namespace odontoscope::figures {

/// Two round stumps of four slices each, one upon the other, the upper moved sideways by `radii` of their radius.
ContourStack shifted_stumps(double radii);
inline constexpr double stump_spacing = 0.7;    // mm between slices
inline constexpr std::size_t stump_slices = 4;  // of each stump

/// Few-cornered contours, so that single tetrahedra can be seen.
ContourStack well_placed_pair();
ContourStack one_over_two();
ContourStack badly_placed_pair();

/// A rounded square under a larger, lobed one, as consecutive sections of a crown are.
ContourStack crown_sections();

/// The slices of a tooth from `low` to `high`.
ContourStack part_of(const ContourStack& tooth, double low, double high);

/// Two neighbouring sections as of a molar, with few points: two roots with a canal each below, the trunk with the pulp
/// chamber above.
ContourStack roots_and_trunk();
/// The sample molar's dentine, filled, where the two roots become one.
ContourStack molar_furcation();

}  // namespace odontoscope::figures
