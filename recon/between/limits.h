#pragma once
// Bounds of what is told apart between two slices; those of blending itself are in recon/core/limits.h.

namespace odontoscope::limits {

/// A place where only one slice has material juts out like a strip if it is this many times as long as wide (between
/// nested contours: once), surely so from the second number on.
inline constexpr double strip_least = 2.5, strip_certain = 3.5;
/// Over the slab's height: a strip is at most so wide, surely so up to the first number.
inline constexpr double strip_thin = 0.8, strip_wide = 1.2;
/// Shorter ones, in steps of the grid, are left to the blend, and those up to twice as long in part.
inline constexpr double strip_steps = 8;
/// Neighbours towards which a way grows by at least this part of their distance lie straight ahead: between two of
/// eight neighbours it is 0.92.
inline constexpr double strip_ahead = 0.8;
/// Along the middle of a bent strip the way grows by at least this part of each step; across it, by at most this many
/// steps.
inline constexpr double strip_onwards = 0.3, strip_level = 1;

/// Slices in which classes of linked regions meet are parted so many times at most: a wall of single points may leave
/// gaps.
inline constexpr int parting_rounds = 4;
/// A passage that joins what is joined below and above is at most so many steps of the grid long.
inline constexpr int passage_steps = 12;

/// What reaches farther than so many steps of the grid from what two slices share is drawn back between them, in stages
/// about as long, and in so many at most.
inline constexpr double sudden_steps = 6;
inline constexpr int most_drawn_back = 10;

}  // namespace odontoscope::limits
