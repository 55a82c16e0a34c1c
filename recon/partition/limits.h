#pragma once
// Tolerances and bounds of the partition (see recon/core/limits.h for those of all rooms).

#include <cstddef>

namespace odontoscope::partition::limits {

/// How far a point is raised off its slice, over the slab's height: little, since a face that ends becomes a step so
/// high; where no number lies so near to the slice, by the second share. From both slices together less than the whole,
/// with room between.
inline constexpr double raise_share = 0.05, raise_share_narrow = 0.25;
/// How far a face may rise that ends along its length, over the slab's height: beside one of the other slice that rises
/// towards it something must be left between.
inline constexpr double ramp_most = 0.9;
/// Ending triangles times meetings of three labels beyond which a slab is noise, and all rises as usual.
inline constexpr std::size_t ramp_pairs = 10'000'000;
/// A point that rose too far for a tetrahedron to stay positive is lowered until that is flat, and farther by this part
/// of its share; where several have to be, by a factor; after so many times to the usual share.
inline constexpr double ramp_spare = 0.1, ramp_lowered = 0.5;
inline constexpr int ramp_times_lowered = 16;
/// Rounds in which one vertex may be mended by relabelling single parts of its link before the whole of its
/// surroundings gets one label.
inline constexpr std::size_t single_mends = 3;
/// Structures of one partition: one bit each.
inline constexpr std::size_t most_structures = 64;
/// Rounds of mending after which a slab is given up as a bug: each point is patched at most some forty times, since its
/// patch doubles.
inline constexpr std::size_t most_rounds = 100000;
/// A crossing as near as this to the end of a piece is taken to be there, in units in the last place of the largest
/// coordinate: else pieces that run within rounding of each other would be bent to cross again, one unit on, without
/// end.
inline constexpr double snap_ulps = 4;
/// A cut corner narrower than this share of its length is too near to a needle to be cut: its triangles go whole.
inline constexpr double needle_share = 1e-6;
/// Rounds in which pieces are cut where they cross, and corners where four faces meet, before it is a bug.
inline constexpr std::size_t planar_rounds = 100;
inline constexpr std::size_t cutting_rounds = 50,
                             corner_rounds = 2000;  // cut, then given away upwards by priority, which ends
/// How far from a point where four faces meet a corner is cut, over the distance to the nearest other border.
inline constexpr double corner_share = 0.25;
/// How far surfaces travel sideways between two slices, over their distance, from which on three slices or seven are
/// interpolated at once.
inline constexpr double level = 3, very_level = 8;
/// Mean width below which a face of an interpolated slice is taken for what two ways of interpolating the same border
/// leave between them, over the slab's height.
inline constexpr double sliver_share = 0.05;
/// Rounds of conforming a slice's borders, counted in points added over points given, before the slice is taken as not
/// conforming.
inline constexpr std::size_t steiner_factor = 20;
inline constexpr std::size_t steiner_free = 2000;

}  // namespace odontoscope::partition::limits
